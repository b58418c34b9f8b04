// SPDX-License-Identifier: MIT
#include "sim/frame_run.hpp"

#include <fmt/format.h>

#include "sim/interrupt.hpp"
#include "sim/measure/setting.hpp"
#include "sim/picture_file.hpp"
#include "sim/progress.hpp"
#include "sim/systemc_machine.hpp"
#include "sim/wave/recording.hpp"

namespace cigsim {
namespace {

constexpr std::size_t kFewFrames = 3;

// Writes pictures and keeps the records.
class Output {
 public:
  Output(const std::vector<FrameView>& views, const std::filesystem::path& folder, RunRecord& run)
      : views_(views), folder_(folder), run_(run) {}

  std::size_t count() const { return run_.frames.size(); }

  void add(const Picture& picture, const std::vector<FrameStats>& repeats) {
    FrameRecord record{views_[count()], median_times(repeats),
                       fmt::format("frame-{:04}.png", count()),
                       fmt::format("ids-{:04}.pgm", count())};
    write_png(picture, folder_ / record.picture);
    write_pgm(picture, folder_ / record.ids);
    run_.frames.push_back(std::move(record));
    if (views_.size() > kFewFrames)
      progress_.show(static_cast<double>(count()) / static_cast<double>(views_.size()));
  }

 private:
  const std::vector<FrameView>& views_;
  const std::filesystem::path& folder_;
  RunRecord& run_;
  Progress progress_{"rendering"};
};

void run_functional(const std::vector<FrameView>& views, const Interrupt& interrupt,
                    const RunRecord& run, Output& output) {
  FunctionalMachine machine(*run.database, run.machine);
  std::vector<FrameStats> repeats;
  for (std::size_t i = 0; i < views.size() && interrupt.signal() == 0; ++i) {
    repeats.clear();
    const Picture* picture = nullptr;
    for (std::size_t r = 0; r < run.repeat; ++r) {
      picture = &machine.compute(views[i].viewpoint, views[i].position);
      repeats.push_back(machine.stats());
    }
    output.add(*picture, repeats);
  }
}

// A frame that is repeated goes through the pipeline as often.
void run_pipeline(const std::vector<FrameView>& views, const Interrupt& interrupt,
                  const std::optional<WaveRequest>& wave, const RunRecord& run, Output& output) {
  const Setting setting{"", run.machine, run.levels};
  SystemcMachine machine("cigsim",
                         pipeline_options(setting, rtl_libraries(setting, *run.database)));
  std::size_t fed = 0;
  std::vector<FrameStats> repeats;
  machine.feed(
      [&]() -> std::optional<FrameJob> {
        const std::size_t view = fed / run.repeat;
        // What was begun is repeated to the end.
        if (view == views.size() || (interrupt.signal() != 0 && fed % run.repeat == 0)) return {};
        ++fed;
        return FrameJob{run.database, views[view].viewpoint, views[view].position};
      },
      [&](const Picture& picture, const FrameStats& stats) {
        repeats.push_back(stats);
        if (repeats.size() < run.repeat) return;
        output.add(picture, repeats);
        repeats.clear();
      });
  if (!wave) return SystemcMachine::simulate({&machine});
  write_wave(*wave, [&](std::ostream& out) {
    machine.record(out, wave->window, wave->stages);
    SystemcMachine::simulate({&machine});
  });
}

}  // namespace

int run_frames(const std::vector<FrameView>& views, const std::filesystem::path& folder,
               const std::optional<WaveRequest>& wave, RunRecord& run) {
  const Interrupt interrupt;
  Output output(views, folder, run);
  if (run.levels.functional())
    run_functional(views, interrupt, run, output);
  else
    run_pipeline(views, interrupt, wave, run, output);
  run.interrupted = run.frames.size() < views.size();
  return run.interrupted ? interrupt.signal() : 0;
}

}  // namespace cigsim
