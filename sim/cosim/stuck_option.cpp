// SPDX-License-Identifier: MIT
#include "sim/cosim/stuck_option.hpp"

#include <fmt/format.h>

#include <vector>

#include "models/boundary/fields.hpp"
#include "sim/arguments.hpp"

namespace cigsim::cosim {
namespace {

constexpr const char* kOption = "--stuck";
constexpr unsigned kMostBits = 256;

struct Place {
  Stage stage;
  std::string pins, field;
  unsigned bits;
};

template <class Word>
void add_places(Stage stage, const std::string& pins, std::vector<Place>& places) {
  places.push_back({stage, pins, "valid", 1});
  const Word word;
  for_each_field(word, [&](const char* name, const auto& field) {
    using Field = std::remove_cvref_t<decltype(field)>;
    places.push_back({stage, pins, name, std::is_same_v<Field, bool> ? 1 : 8 * sizeof field});
  });
}

const std::vector<Place>& places() {
  static const std::vector<Place> all = [] {
    std::vector<Place> list;
    add_places<ItemWord>(Stage::kPriorityProcessor, "items", list);
    add_places<FrameWord>(Stage::kEdgeOrderer, "loaded", list);
    add_places<CrossingWord>(Stage::kEdgeOrderer, "crossings", list);
    add_places<SpanWord>(Stage::kPriorityResolver, "spans", list);
    return list;
  }();
  return all;
}

}  // namespace

StuckChoice parse_stuck(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || (text.substr(equals) != "=0" && text.substr(equals) != "=1"))
    throw UsageError(
        fmt::format("{}: '{}' must be a bit of a stage's output pins and its value, such as "
                    "priority_resolver.spans.first:3=1 or so_engine.answer_hides_o:5=0",
                    kOption, text));
  const bool high = text.back() == '1';
  const std::size_t colon = std::min(text.find(':'), equals);
  const unsigned bit =
      colon == equals ? 0
                      : static_cast<unsigned>(parse_whole(
                            kOption, text.substr(colon + 1, equals - colon - 1), 0, kMostBits - 1));
  const std::string name = text.substr(0, colon);
  constexpr std::string_view kEngine = "so_engine.";
  if (name.starts_with(kEngine)) return SoStuckBit{name.substr(kEngine.size()), bit, high};
  std::vector<std::string> known;
  for (const Place& place : places()) {
    known.push_back(fmt::format("{}.{}.{}", name_of(place.stage), place.pins, place.field));
    if (known.back() != name) continue;
    if (bit >= place.bits)
      throw UsageError(fmt::format("{}: {} has bits 0 to {}", kOption, name, place.bits - 1));
    return std::pair{place.stage, StuckBit{place.pins, place.field, bit, high}};
  }
  fail_on_choice(kOption, name, {known.begin(), known.end()});
}

}  // namespace cigsim::cosim
