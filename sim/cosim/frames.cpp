// SPDX-License-Identifier: MIT
#include "sim/cosim/frames.hpp"

#include <fmt/format.h>

#include <chrono>
#include <map>
#include <memory>
#include <sstream>

#include "models/environment/random.hpp"
#include "sim/functional_machine.hpp"
#include "sim/systemc_machine.hpp"
#include "sim/wave/recording.hpp"

namespace cigsim::cosim {
namespace {

constexpr Cycle kLongestStall = 12;

// A quarter of the words wait.
StallFunction random_stalls(std::uint64_t seed) {
  return [seed](const std::string& link, std::uint64_t word) -> Cycle {
    std::uint64_t name = 0;
    for (const char c : link.substr(link.rfind('.') + 1))
      name = name * 31 + static_cast<unsigned char>(c);
    Random random(seed ^ name * 0x9e3779b97f4a7c15u ^ word);
    return random.below(4) == 0 ? static_cast<Cycle>(random.below(kLongestStall)) : 0;
  };
}

MachineOptions functional_options(const ComparePlan& plan) {
  MachineOptions options;
  options.number = NumberType::kMachine;
  options.resolver = ResolverMethod::kActiveList;
  options.description = plan.description;
  options.raster = plan.description.raster;
  options.overload = plan.overload;
  options.eye_reach = plan.eye_reach;
  return options;
}

// The machine in question, the timed one and the functional one on the frames of a plan.
class Comparison {
 public:
  Comparison(const std::string& name, const ComparePlan& plan, const FramesOptions& options,
             MismatchFunction report)
      : plan_(plan), progress_(options.progress), report_(std::move(report)) {
    PipelineOptions pipeline;
    pipeline.description = plan.description;
    pipeline.overload = plan.overload;
    pipeline.eye_reach = plan.eye_reach;
    if (plan.stalls) pipeline.stalls = random_stalls(*plan.stalls);
    for (const Stage stage : kAllStages) pipeline.levels[stage] = Level::kTimed;
    timed_ = std::make_unique<SystemcMachine>(name + "_timed", pipeline);
    feed(*timed_, false);

    for (std::size_t i = 0; i < plan.stages.size(); ++i) {
      pipeline.levels[plan.stages[i]] = Level::kRtl;
      pipeline.libraries[plan.stages[i]] = rtl_library(plan.variants[i], options.say).file;
    }
    pipeline.rtl_seed = plan.seed;
    pipeline.stuck = plan.stuck;
    pipeline.lockstep = report_;
    machine_ = std::make_unique<SystemcMachine>(name, pipeline);
    machine_->check_links(*timed_, report_);
    feed(*machine_, true);
  }

  SystemcMachine& machine() { return *machine_; }
  SystemcMachine& timed() { return *timed_; }

  // After the simulation.
  void add_to(FramesResult& result) {
    result.words += machine_->finish_checks();
    if (shown_ != plan_.frames.size())
      report_({"video_processor",
               "pictures shown",
               machine_->cycles(),
               static_cast<std::uint32_t>(shown_),
               {},
               std::to_string(plan_.frames.size()),
               std::to_string(shown_),
               {}});
    result.cycles += machine_->cycles();
    result.frames += shown_;
    result.pictures += pictures_;
    result.elements += elements_;
  }

 private:
  void feed(SystemcMachine& machine, bool compare) {
    machine.feed(
        [this, fed = std::size_t{0}]() mutable -> std::optional<FrameJob> {
          if (fed == plan_.frames.size()) return {};
          const PlannedFrame& frame = plan_.frames[fed++];
          return FrameJob{plan_.databases[frame.database].get(), frame.view.viewpoint,
                          frame.view.position};
        },
        [this, compare](const Picture& picture, const FrameStats& stats) {
          if (compare) shown(picture, stats);
        });
  }

  void shown(const Picture& picture, const FrameStats& stats) {
    const std::size_t f = shown_++;
    if (progress_)
      progress_(static_cast<double>(shown_) / static_cast<double>(plan_.frames.size()));
    const bool deadline = plan_.description.frame_cycles > 0 && stats.overload->dropped_faces > 0;
    if (deadline && plan_.overload != OverloadPolicy::kExtend) return;
    const PlannedFrame& frame = plan_.frames[f];
    auto& functional = functional_[frame.database];
    if (!functional)
      functional = std::make_unique<FunctionalMachine>(*plan_.databases[frame.database],
                                                       functional_options(plan_));
    const Picture& expected = functional->compute(frame.view.viewpoint, frame.view.position);
    ++pictures_;
    for (std::size_t i = 0; i < expected.colours.size(); ++i) {
      if (expected.colours[i] == picture.colours[i] && expected.numbers[i] == picture.numbers[i])
        continue;
      const auto width = static_cast<std::size_t>(picture.width);
      const auto element = [&](const Picture& of) {
        return fmt::format("object {}, colour {:06x}", of.numbers[i], of.colours[i] & 0xffffff);
      };
      report_({"video_processor",
               fmt::format("picture, element {}", i % width),
               machine_->cycles(),
               static_cast<std::uint32_t>(f),
               static_cast<std::uint32_t>(i / width),
               element(expected),
               element(picture),
               {}});
      return;
    }
    elements_ += expected.colours.size();
  }

  const ComparePlan& plan_;
  std::function<void(double)> progress_;
  MismatchFunction report_;
  std::unique_ptr<SystemcMachine> timed_, machine_;
  std::map<std::size_t, std::unique_ptr<FunctionalMachine>> functional_;
  std::size_t shown_ = 0;
  std::uint64_t pictures_ = 0, elements_ = 0;
};

}  // namespace

FramesResult compare_frames(std::span<const ComparePlan> plans, const FramesOptions& options) {
  FramesResult result;
  std::vector<std::unique_ptr<Comparison>> comparisons;
  std::vector<SystemcMachine*> machines;
  for (std::size_t p = 0; p < plans.size(); ++p) {
    const auto report = [&, p](const Mismatch& mismatch) {
      if (result.mismatch) return;
      result.mismatch = mismatch;
      result.plan = p;
      comparisons[p]->machine().stop(options.after);
    };
    comparisons.push_back(std::make_unique<Comparison>(
        p == 0 ? std::string("cigsim") : fmt::format("cigsim_{}", p), plans[p], options, report));
    machines.push_back(&comparisons.back()->machine());
    machines.push_back(&comparisons.back()->timed());
  }
  const auto begin = std::chrono::steady_clock::now();
  const auto simulate = [&] {
    try {
      SystemcMachine::simulate(machines);
    } catch (const std::runtime_error& error) {
      if (result.mismatch) return;
      if (!std::string_view(error.what()).ends_with(kBrokenContract)) throw;
      // Which plan's it is, the message does not tell.
      result.mismatch = Mismatch{std::string(kAnyStage),
                                 "contract",
                                 comparisons.front()->machine().cycles(),
                                 0,
                                 {},
                                 "kept",
                                 error.what(),
                                 {}};
    }
  };
  if (options.wave)
    write_wave(*options.wave, [&](std::ostream& out) {
      comparisons.front()->machine().record(out, options.wave->window, options.wave->stages);
      simulate();
    });
  else
    simulate();
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  for (const auto& comparison : comparisons) comparison->add_to(result);
  return result;
}

}  // namespace cigsim::cosim
