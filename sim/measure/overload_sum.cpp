// SPDX-License-Identifier: MIT
#include "sim/measure/overload_sum.hpp"

#include <numeric>

namespace cigsim {
namespace {

struct Field {
  const char* name;
  std::uint64_t OverloadSum::*member;
};
constexpr Field kFields[] = {{"frames", &OverloadSum::frames},
                             {"overloaded", &OverloadSum::overloaded},
                             {"saturated", &OverloadSum::saturated},
                             {"dropped_items", &OverloadSum::dropped_items},
                             {"dropped_faces", &OverloadSum::dropped_faces},
                             {"dropped_crossings", &OverloadSum::dropped_crossings},
                             {"overfull_lines", &OverloadSum::overfull_lines},
                             {"saturated_words", &OverloadSum::saturated_words}};

}  // namespace

void OverloadSum::add(const FrameStats& frame) {
  if (!frame.overload) return;
  const Overload& o = *frame.overload;
  const auto words = std::accumulate(o.overflows.begin(), o.overflows.end(), std::uint64_t{0});
  ++frames;
  overloaded += o.dropped_items + o.dropped_faces + o.dropped_crossings + o.overfull_lines > 0;
  saturated += words > 0;
  dropped_items += o.dropped_items;
  dropped_faces += o.dropped_faces;
  dropped_crossings += o.dropped_crossings;
  overfull_lines += o.overfull_lines;
  saturated_words += words;
}

nlohmann::ordered_json overload_sum_json(const OverloadSum& sum) {
  nlohmann::ordered_json json;
  for (const Field& field : kFields) json[field.name] = sum.*field.member;
  return json;
}

OverloadSum overload_sum_from_json(const nlohmann::ordered_json& json) {
  OverloadSum sum;
  for (const Field& field : kFields) json.at(field.name).get_to(sum.*field.member);
  return sum;
}

}  // namespace cigsim
