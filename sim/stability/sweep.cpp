// SPDX-License-Identifier: MIT
#include "sim/stability/sweep.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <exception>
#include <mutex>
#include <string_view>
#include <thread>

namespace cigsim::stability {
namespace {

std::uint64_t mixed(std::uint64_t a, std::uint64_t b) {
  return Random(a ^ Random(b).bits()).bits();
}

std::uint64_t hash_of(std::string_view text) {
  std::uint64_t hash = 0;
  for (const char c : text) hash = mixed(hash, static_cast<unsigned char>(c) + 1);
  return hash;
}

void note(Cell& cell, const Outcome& outcome, std::uint64_t seed, const Instance& instance) {
  if (outcome.verdict == Verdict::kNone) return;
  ++cell.posed;
  if (outcome.verdict == Verdict::kDoubtful) ++cell.doubtful;
  if (outcome.verdict == Verdict::kWrong) {
    if (cell.wrong++ == 0) cell.first = Failure{seed, instance, outcome};
  }
  if (outcome.error) cell.worst_error = std::max(cell.worst_error, *outcome.error);
  if (!outcome.bound || !outcome.error) return;
  ++cell.claims;
  cell.largest_bound = std::max(cell.largest_bound, *outcome.bound);
  if (*outcome.bound > 0)
    cell.worst_ratio = std::max(cell.worst_ratio, *outcome.error / *outcome.bound);
  // A wrong answer whose border is at distance 0 breaks a claim of 0 too.
  const bool never_wrong = *outcome.bound == 0 && outcome.verdict == Verdict::kWrong;
  if (*outcome.error <= *outcome.bound && !never_wrong) return;
  if (cell.broken++ == 0) cell.first_broken = Failure{seed, instance, outcome};
}

// One value of an axis for one decision; its cells, a format each, are filled by one thread.
struct Task {
  std::size_t decision = 0;
  Axis axis = Axis::kScale;
  double value = 0;
  std::size_t first_cell = 0, formats = 0;
};

void run(const SweepPlan& plan, const Material& material, const Task& task, Cell* cells) {
  const Decision& decision = plan.decisions[task.decision];
  const std::span<const Format> formats = std::span(plan.formats).first(task.formats);
  for (std::uint32_t trial = 0; trial < plan.trials; ++trial) {
    const std::uint64_t seed = instance_seed(plan.seed, decision, task.axis, task.value, trial);
    Random random(seed);
    const Extremes extremes = at(task.axis, task.value, random);
    const Instance instance = decision.pose(material, extremes, random);
    const std::vector<Outcome> outcomes = decision.judge(instance, formats);
    for (std::size_t f = 0; f < outcomes.size(); ++f) note(cells[f], outcomes[f], seed, instance);
  }
}

bool has(const std::vector<Axis>& axes, Axis axis) {
  return std::find(axes.begin(), axes.end(), axis) != axes.end();
}

// The tasks, and the cells that they fill.
std::vector<Task> lay_out(const SweepPlan& plan, std::vector<Cell>& cells) {
  std::vector<Task> tasks;
  for (std::size_t d = 0; d < plan.decisions.size(); ++d)
    for (const Axis axis : plan.axes) {
      if (!has(plan.decisions[d].axes, axis)) continue;
      const std::size_t formats = plan.decisions[d].shared ? 1 : plan.formats.size();
      for (const double value : values_of(axis)) {
        tasks.push_back({d, axis, value, cells.size(), formats});
        for (std::size_t f = 0; f < formats; ++f) {
          Cell& cell = cells.emplace_back();
          cell.decision = d;
          cell.format = f;
          cell.axis = axis;
          cell.value = value;
        }
      }
    }
  return tasks;
}

}  // namespace

std::uint64_t instance_seed(std::uint64_t seed, const Decision& decision, Axis axis, double value,
                            std::uint32_t trial) {
  std::uint64_t out = mixed(seed, hash_of(decision.name));
  out = mixed(out, hash_of(name_of(axis)));
  out = mixed(out, std::bit_cast<std::uint64_t>(value));
  return mixed(out, trial);
}

Sweep sweep(const SweepPlan& plan, const Material& material) {
  Sweep out;
  if (plan.formats.empty()) return out;
  const std::vector<Task> tasks = lay_out(plan, out.cells);
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failed;
  std::mutex failing;
  const auto work = [&](bool tells) {
    for (std::size_t t; (t = next++) < tasks.size();) {
      try {
        run(plan, material, tasks[t], &out.cells[tasks[t].first_cell]);
      } catch (...) {
        const std::lock_guard lock(failing);
        failed = std::current_exception();
        next = tasks.size();
      }
      if (tells && plan.progress)
        plan.progress(static_cast<double>(t) / static_cast<double>(tasks.size()));
    }
  };
  {
    std::vector<std::jthread> threads;
    for (unsigned i = 1; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
      threads.emplace_back(work, false);
    work(true);
  }
  if (failed) std::rethrow_exception(failed);
  return out;
}

Summary summary(const Sweep& sweep, std::size_t decision, std::size_t format,
                std::optional<Axis> axis) {
  Summary out;
  for (const Cell& cell : sweep.cells) {
    if (cell.decision != decision || cell.format != format || (axis && cell.axis != *axis))
      continue;
    out.posed += cell.posed;
    out.wrong += cell.wrong;
    out.doubtful += cell.doubtful;
    out.claims += cell.claims;
    out.broken += cell.broken;
    out.worst_error = std::max(out.worst_error, cell.worst_error);
    out.largest_bound = std::max(out.largest_bound, cell.largest_bound);
    out.worst_ratio = std::max(out.worst_ratio, cell.worst_ratio);
    if (cell.wrong == 0) continue;
    if (out.worst == nullptr || cell.wrong * out.worst->posed > out.worst->wrong * cell.posed)
      out.worst = &cell;
  }
  return out;
}

const Cell* first_failure(const Sweep& sweep, std::size_t decision, std::size_t format, Axis axis) {
  const Cell* first = nullptr;
  for (const Cell& cell : sweep.cells) {
    if (cell.decision != decision || cell.format != format || cell.axis != axis || cell.wrong == 0)
      continue;
    if (first == nullptr || extremity(axis, cell.value) < extremity(axis, first->value))
      first = &cell;
  }
  return first;
}

}  // namespace cigsim::stability
