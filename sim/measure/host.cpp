// SPDX-License-Identifier: MIT
#include "sim/measure/host.hpp"

#include <sys/utsname.h>

#include <fstream>
#include <thread>

namespace cigsim {

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(':');
    if (!line.starts_with("model name") || colon == std::string::npos) continue;
    const std::size_t begin = line.find_first_not_of(" \t", colon + 1);
    if (begin != std::string::npos) return line.substr(begin);
  }
  utsname system{};
  return ::uname(&system) == 0 ? system.machine : "unknown";
}

nlohmann::ordered_json host_json() {
  return {{"processor", processor_name()}, {"cores", std::thread::hardware_concurrency()}};
}

}  // namespace cigsim
