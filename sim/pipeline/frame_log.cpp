// SPDX-License-Identifier: MIT
#include "sim/pipeline/frame_log.hpp"

#include <utility>

namespace cigsim {

void FrameLog::feed(SystemcMachine::Next next, SystemcMachine::Out out) {
  next_ = std::move(next);
  out_ = std::move(out);
  time_ = {};
}

bool FrameLog::next(std::uint32_t frame) {
  try {
    job_ = next_ && !failure ? next_() : std::nullopt;
  } catch (...) {
    failure = std::current_exception();
    job_.reset();
  }
  if (!job_) return false;
  frames_ = frame + 1;
  stats_of(frame) = {};
  stats_of(frame).overload.emplace();
  stats_of(frame).timing.emplace();
  return true;
}

void FrameLog::started(std::uint32_t k, Cycle cycle) {
  if (job_) stats_of(k).timing->input = cycle;
  for (std::uint32_t age = 1; age <= 2 && age <= k; ++age)
    if (k - age < frames_) stats_of(k - age).timing->period[age - 1] = cycle - last_start_;
  last_start_ = cycle;
}

frame_calculator::Work FrameLog::calculate(frame_calculator::MemoryLoader& loader,
                                           std::uint32_t frame) {
  try {
    frame_calculator::Work work =
        loader.load(*job_->database, job_->viewpoint, job_->position, frame);
    stats_of(frame).detail = work.detail;
    return work;
  } catch (...) {
    failure = std::current_exception();
    return {};
  }
}

void FrameLog::shown(std::uint32_t frame, const Picture& picture, Cycle first, Cycle last,
                     Cycle frame_cycles) {
  FrameTiming& timing = *stats_of(frame).timing;
  timing.first_element = first;
  timing.last_element = last;
  timing.period[2] = last + 1 - last_start_;
  if (frame_cycles > 0)
    for (const Cycle period : timing.period) timing.extended += period > frame_cycles;
  picture_ = &picture;
}

void FrameLog::deliver(FrameStats& stats) {
  stats.host_ms = time_.lap();
  try {
    if (out_ && !failure) out_(*picture_, stats);
  } catch (...) {
    failure = std::current_exception();
  }
  time_.lap();  // what was done with the picture is not the machine's time
}

}  // namespace cigsim
