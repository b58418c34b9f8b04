// SPDX-License-Identifier: MIT
#include "sim/budget/candidates.hpp"

#include <fmt/format.h>

#include "sim/arguments.hpp"
#include "sim/stats.hpp"

namespace cigsim {
namespace {

class Candidates {
 public:
  Candidates(const Budget& budget, const CandidateRange& range) : budget_(budget), range_(range) {}

  std::vector<Setting> list() {
    if (budget_.kind == Budget::Kind::kExact) {
      add_numbers({NumberType::kCertified}, {0});
      return std::move(settings_);
    }
    const std::vector<double> scales =
        range_.choices ? std::vector<double>{1, 0, 0.5, 2, 4} : std::vector<double>{1};
    if (!budget_.cycles) {  // which the functional level does not know
      if (range_.machine_given)
        for (const double scale : scales) add_words(Level::kFunctional, scale);
      else
        add_numbers(numbers(), scales);
      return std::move(settings_);
    }
    for (const double scale : scales) add_words(Level::kTimed, scale);
    add_words(range_.referee, 1);
    return std::move(settings_);
  }

 private:
  void add(std::string name, const MachineOptions& machine, const LevelChoice& levels,
           double scale) {
    Setting& setting = settings_.emplace_back();
    setting.name = std::move(name);
    if (range_.choices && scale != 1)
      setting.name += scale == 0 ? ", detail most" : fmt::format(", detail {:g}", scale);
    setting.machine = machine;
    setting.machine.detail = scale;
    setting.levels = levels;
  }

  std::vector<NumberType> numbers() const {
    if (!range_.floats) return {NumberType::kDouble, NumberType::kCertified};
    return {NumberType::kFloat, NumberType::kDouble, NumberType::kCertified};
  }

  // Resolvers other than the one that is chosen frame by frame: with the scene's own thresholds.
  void add_numbers(const std::vector<NumberType>& numbers, const std::vector<double>& scales) {
    for (const NumberType number : numbers)
      for (const double scale : scales)
        for (const ResolverMethod resolver :
             {ResolverMethod::kAuto, ResolverMethod::kPainter, ResolverMethod::kCoverage}) {
          if (resolver != ResolverMethod::kAuto && scale != scales.front()) continue;
          MachineOptions machine;
          machine.number = number;
          machine.raster = range_.words.raster;
          machine.eye_reach = range_.words.eye_reach;
          machine.resolver = resolver;
          std::string name = name_of(number);
          if (resolver != ResolverMethod::kAuto)
            name += fmt::format(", resolver {}", name_of(resolver));
          add(std::move(name), machine, {}, scale);
        }
  }

  void add_words(Level level, double scale) {
    add(level == Level::kFunctional ? "machine" : std::string(name_of(level)), range_.words,
        LevelChoice::parse(std::string(name_of(level))), scale);
  }

  const Budget& budget_;
  const CandidateRange& range_;
  std::vector<Setting> settings_;
};

}  // namespace

std::vector<Setting> candidates(const Budget& budget, const CandidateRange& range) {
  if (budget.kind == Budget::Kind::kExact && range.machine_given)
    throw UsageError(
        "--max-error: a machine's words are rounded, so that 0 cannot be kept; leave out "
        "--machine, "
        "or allow a share such as elements=0.1%");
  return Candidates(budget, range).list();
}

}  // namespace cigsim
