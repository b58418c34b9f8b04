// SPDX-License-Identifier: MIT
#include "models/boundary/rtl_coverage.hpp"

#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <map>
#include <mutex>
#include <string>

namespace cigsim {
namespace {

/// Counts by coverage point. A line of a file is C 'point' count.
class Sums {
 public:
  explicit Sums(const std::filesystem::path& folder)
      : file_(folder / ("rtl-" + std::to_string(getpid()) + ".dat")) {}
  ~Sums() {
    std::ofstream out(file_);
    out << "# SystemC::Coverage-3\n";
    for (const auto& [point, count] : counts_) out << point << ' ' << count << '\n';
  }
  void add(const std::function<void(const std::filesystem::path&)>& write) {
    const std::lock_guard lock(mutex_);
    write(file_);
    std::ifstream in(file_);
    for (std::string line; std::getline(in, line);) {
      const std::size_t end = line.rfind(' ');
      if (line.starts_with("C ")) counts_[line.substr(0, end)] += std::stoull(line.substr(end + 1));
    }
  }

 private:
  std::filesystem::path file_;
  std::mutex mutex_;
  std::map<std::string, std::uint64_t> counts_;
};

}  // namespace

void add_rtl_coverage(const std::function<void(const std::filesystem::path&)>& write) {
  const char* const folder = std::getenv("CIGSIM_RTL_COVERAGE");
  if (folder == nullptr) return;
  static Sums sums(folder);
  sums.add(write);
}

}  // namespace cigsim
