// SPDX-License-Identifier: MIT
#include "models/environment/json_reason.hpp"

namespace cigsim {

std::string json_reason(const std::string& message) {
  std::size_t from = message.find("] ");
  from = from == std::string::npos ? 0 : from + 2;
  const std::size_t place = message.find(": ", from);
  if (message.compare(from, 11, "parse error") == 0 && place != std::string::npos) from = place + 2;
  std::string reason = message.substr(from);
  for (char& c : reason)
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  return reason;
}

}  // namespace cigsim
