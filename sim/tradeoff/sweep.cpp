// SPDX-License-Identifier: MIT
#include "sim/tradeoff/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace cigsim {
namespace {

constexpr int kLargestRaster = 16384;

struct Width {
  const char* name;
  int WordFormats::*bits;
  std::vector<int> values;
};

// From what a description may have at least to what containers hold.
const std::vector<Width>& widths() {
  static const std::vector<Width> all{
      {"coordinate_bits", &WordFormats::coordinate_bits, {16, 18, 20, 24, 28, 31}},
      {"direction_fraction", &WordFormats::direction_fraction, {12, 16, 20, 30}},
      {"quotient_fraction", &WordFormats::quotient_fraction, {8, 12, 16, 20, 24, 30}},
      {"raster_fraction", &WordFormats::raster_fraction, {4, 8, 12, 15, 18}}};
  return all;
}

class Sweep {
 public:
  explicit Sweep(const SweepRange& range) : range_(range) {}

  std::vector<SweepPoint> points() {
    add("default", base("double", NumberType::kDouble));
    if (has(Level::kFunctional)) add_functional();
    if (has(Level::kFunctional)) add_words();
    add_levels();
    return std::move(points_);
  }

 private:
  using Change = std::function<void(MachineOptions&)>;

  bool has(Level level) const {
    return std::find(range_.levels.begin(), range_.levels.end(), level) != range_.levels.end();
  }
  void add(const char* knob, Setting setting) { points_.push_back({knob, std::move(setting)}); }

  Setting base(std::string name, NumberType number) const {
    Setting setting;
    setting.name = std::move(name);
    setting.machine.number = number;
    setting.machine.raster = range_.raster;
    setting.machine.eye_reach = range_.eye_reach;
    if (number == NumberType::kMachine) {
      setting.machine.description = range_.description;
      setting.machine.overload = range_.overload;
      setting.machine.resolver = ResolverMethod::kActiveList;
    }
    return setting;
  }
  Setting base(std::string name, NumberType number, const Change& change) const {
    Setting setting = base(std::move(name), number);
    change(setting.machine);
    return setting;
  }
  void turn(const char* knob, std::string name, const Change& change) {
    add(knob, base(std::move(name), NumberType::kDouble, change));
  }

  void add_functional() {
    add("number", base("float", NumberType::kFloat));
    add("number", base("certified", NumberType::kCertified));
    add("number", base("exact", NumberType::kExact));
    if (range_.choices)
      for (const double scale : {0.0, 0.5, 2.0, 4.0})
        turn("detail", scale == 0 ? "detail most" : fmt::format("detail {:g}", scale),
             [scale](MachineOptions& m) { m.detail = scale; });
    add_raster(NumberType::kDouble, 1, 2);
    add_raster(NumberType::kDouble, 1, 4);
    add_raster(NumberType::kDouble, 2, 1);
    turn("priority", "priority so",
         [](MachineOptions& m) { m.priority = PriorityMethod::kSoMatrix; });
    turn("resolver", "resolver painter",
         [](MachineOptions& m) { m.resolver = ResolverMethod::kPainter; });
    turn("resolver", "resolver coverage",
         [](MachineOptions& m) { m.resolver = ResolverMethod::kCoverage; });
    turn("resolver", "resolver active-list",
         [](MachineOptions& m) { m.resolver = ResolverMethod::kActiveList; });
    turn("retrieval", "retrieval off", [](MachineOptions& m) { m.retrieval = false; });
    turn("coherence", "coherence off", [](MachineOptions& m) { m.coherence = false; });
    add_raster(NumberType::kFloat, 1, 2);
    add_raster(NumberType::kFloat, 1, 4);
    if (range_.choices) {
      add("together",
          base("float, detail 4", NumberType::kFloat, [](MachineOptions& m) { m.detail = 4; }));
      add("together", base("certified, detail most", NumberType::kCertified,
                           [](MachineOptions& m) { m.detail = 0; }));
    }
  }

  void add_raster(NumberType number, int times, int part) {
    const Raster& r = range_.raster;
    const Raster raster{r.width * times / part, r.height * times / part};
    if (std::min(raster.width, raster.height) < 1 ||
        std::max(raster.width, raster.height) > kLargestRaster)
      return;
    const std::string scale = part > 1 ? fmt::format("1/{}", part) : fmt::format("{}", times);
    const bool alone = number == NumberType::kDouble;
    add(alone ? "raster" : "together", base(alone ? "raster " + scale : "float, raster " + scale,
                                            number, [&](MachineOptions& m) { m.raster = raster; }));
  }

  void add_words() {
    add("number", base("machine", NumberType::kMachine));
    for (const Width& width : widths())
      for (const int bits : width.values)
        if (bits != range_.description.formats.*width.bits)
          add("words", base(fmt::format("{} {}", width.name, bits), NumberType::kMachine,
                            [&](MachineOptions& m) { m.description.formats.*width.bits = bits; }));
    add("together", base("narrow words", NumberType::kMachine, [](MachineOptions& m) {
          m.description.formats = {20, 16, 16, 8};
        }));
  }

  void add_levels() {
    for (const Level level : {Level::kTimed, Level::kClocked, Level::kRtl})
      if (has(level)) add("level", at_level(base("", NumberType::kMachine), level));
    if (!has(Level::kTimed)) return;
    for (const Level level : {Level::kClocked, Level::kRtl})
      for (const Stage stage : kAllStages)
        if (has(level) && exists(stage, level)) add("level", with_one(stage, level));
    if (!range_.choices) return;
    Setting coarse = at_level(base("", NumberType::kMachine), Level::kTimed);
    coarse.name = "timed, detail 4";
    coarse.machine.detail = 4;
    add("together", coarse);
  }

  Setting with_one(Stage stage, Level level) const {
    Setting setting = at_level(base("", NumberType::kMachine), Level::kTimed);
    setting.levels[stage] = level;
    setting.name = setting.levels.text();
    return setting;
  }

  const SweepRange& range_;
  std::vector<SweepPoint> points_;
};

}  // namespace

std::vector<SweepPoint> sweep(const SweepRange& range) { return Sweep(range).points(); }

}  // namespace cigsim
