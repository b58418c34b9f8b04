// SPDX-License-Identifier: MIT
#include "models/environment/detail.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace cigsim {
namespace {

void expect(bool holds, const std::string& thing, const char* what) {
  if (!holds) throw std::invalid_argument(thing + " " + what);
}

void check_place(const Environment& environment, const std::optional<DescriptionRef>& within,
                 std::uint32_t model, std::size_t choices, const std::string& thing) {
  if (!within) return;
  expect(within->choice < choices, thing, "names a choice that does not come before it");
  const Choice& choice = environment.choices[within->choice];
  expect(within->description <= choice.thresholds.size(), thing,
         "names a description that its choice does not have");
  expect(choice.model == model, thing, "stands in a choice of another model");
}

void check_thresholds(const Choice& choice, const std::string& thing) {
  expect(choice.thresholds.size() < kMostDescriptions, thing, "has too many descriptions");
  double last = 0;
  for (const double threshold : choice.thresholds) {
    expect(std::isfinite(threshold) && threshold > last, thing,
           "has thresholds that do not ascend from above 0");
    last = threshold;
  }
}

}  // namespace

bool is_most_detailed(const Environment& environment, const Object& object) {
  for (std::optional<DescriptionRef> at = object.within; at;
       at = environment.choices[at->choice].within)
    if (at->description < environment.choices[at->choice].thresholds.size()) return false;
  return true;
}

Environment most_detailed(Environment environment) {
  for (Object& object : environment.objects) {
    if (is_most_detailed(environment, object)) continue;
    object.vertices.clear();
    object.faces.clear();
  }
  for (Object& object : environment.objects) object.within.reset();
  environment.choices.clear();
  return environment;
}

void check_choices(const Environment& environment) {
  std::vector<std::size_t> depth(environment.choices.size(), 1);
  for (std::size_t c = 0; c < environment.choices.size(); ++c) {
    const Choice& choice = environment.choices[c];
    const std::string thing = "choice \"" + choice.name + "\"";
    expect(choice.model < environment.models.size(), thing, "names a model that is not there");
    check_place(environment, choice.within, choice.model, c, thing);
    check_thresholds(choice, thing);
    if (choice.within) depth[c] += depth[choice.within->choice];
    expect(depth[c] <= kDeepestChoice, thing, "stands too deep within other choices");
  }
  std::vector<bool> filled(environment.choices.size(), false);
  for (const Object& object : environment.objects) {
    check_place(environment, object.within, object.model, environment.choices.size(),
                "object \"" + object.name + "\"");
    for (std::optional<DescriptionRef> at = object.within; at;
         at = environment.choices[at->choice].within)
      if (at->description == environment.choices[at->choice].thresholds.size())
        filled[at->choice] = true;
  }
  for (std::size_t c = 0; c < filled.size(); ++c)
    expect(filled[c], "choice \"" + environment.choices[c].name + "\"",
           "has no object in its most detailed description");
}

}  // namespace cigsim
