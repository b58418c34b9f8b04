// SPDX-License-Identifier: MIT
#include "models/environment/scene_entries.hpp"

#include <optional>
#include <stdexcept>

namespace cigsim {
namespace {

using Scope = std::optional<DescriptionRef>;

class Lister {
 public:
  explicit Lister(const Environment& environment)
      : environment_(environment), met_(environment.choices.size(), false) {}

  std::vector<SceneEntry> list(std::size_t first, std::size_t last, const Scope& scope) {
    std::vector<SceneEntry> entries;
    for (std::size_t i = first; i < last;) {
      const Scope& within = environment_.objects[i].within;
      if (within == scope) {
        entries.push_back({false, static_cast<std::uint32_t>(i++)});
        continue;
      }
      const DescriptionRef below = below_scope(within, scope);
      std::size_t end = i;
      while (end < last && holds(below.choice, environment_.objects[end].within)) ++end;
      entries.push_back(choice(below.choice, i, end));
      i = end;
    }
    return entries;
  }

 private:
  SceneEntry choice(std::uint32_t index, std::size_t first, std::size_t last) {
    if (met_[index]) fail(index);
    met_[index] = true;
    SceneEntry entry{true, index};
    const auto count =
        static_cast<std::uint32_t>(environment_.choices[index].thresholds.size() + 1);
    for (std::uint32_t d = 0; d < count; ++d) {
      std::size_t end = first;
      while (end < last && description_in(index, environment_.objects[end].within) == d) ++end;
      entry.descriptions.push_back(list(first, end, DescriptionRef{index, d}));
      first = end;
    }
    if (first != last) fail(index);
    return entry;
  }

  // Of the descriptions around something, the outermost that stands within `scope`.
  DescriptionRef below_scope(Scope at, const Scope& scope) const {
    while (environment_.choices[at->choice].within != scope)
      at = environment_.choices[at->choice].within;
    return *at;
  }

  bool holds(std::uint32_t choice, const Scope& within) const {
    for (Scope at = within; at; at = environment_.choices[at->choice].within)
      if (at->choice == choice) return true;
    return false;
  }

  // Of something that the choice holds.
  std::uint32_t description_in(std::uint32_t choice, Scope at) const {
    while (at->choice != choice) at = environment_.choices[at->choice].within;
    return at->description;
  }

  [[noreturn]] void fail(std::uint32_t choice) const {
    throw std::invalid_argument("the objects of choice \"" + environment_.choices[choice].name +
                                "\" do not follow each other, description after description");
  }

  const Environment& environment_;
  std::vector<bool> met_;
};

}  // namespace

std::vector<SceneEntry> scene_entries(const Environment& environment, std::size_t first,
                                      std::size_t last) {
  return Lister(environment).list(first, last, std::nullopt);
}

}  // namespace cigsim
