// SPDX-License-Identifier: MIT
#include "sim/cosim/reproduce.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>

#include "sim/cosim/frames.hpp"
#include "sim/program_pipe.hpp"

namespace cigsim::cosim {
namespace {

constexpr Cycle kCyclesBefore = 40;

// The frames from `first` to `last`, and the databases that they need.
ComparePlan part(const ComparePlan& plan, std::size_t first, std::size_t last) {
  ComparePlan shorter = plan;
  shorter.frames.assign(plan.frames.begin() + static_cast<std::ptrdiff_t>(first),
                        plan.frames.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  std::set<std::size_t> used;
  for (const PlannedFrame& frame : shorter.frames) used.insert(frame.database);
  shorter.databases.clear();
  for (const std::size_t d : used) shorter.databases.push_back(plan.databases[d]);
  for (PlannedFrame& frame : shorter.frames)
    frame.database =
        static_cast<std::size_t>(std::distance(used.begin(), used.find(frame.database)));
  return shorter;
}

// What `cigsim replay` finds.
std::optional<Mismatch> replayed(const std::filesystem::path& file) {
  Pipe pipe({"/proc/self/exe", "replay", file.string(), "--json"}, Pipe::End::kReads);
  std::string text;
  std::array<char, 4096> buffer;
  for (std::size_t n; (n = std::fread(buffer.data(), 1, buffer.size(), pipe.file())) > 0;)
    text.append(buffer.data(), n);
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (json.is_discarded() || !json.contains("mismatch") || json["mismatch"].is_null()) return {};
  const nlohmann::json& m = json["mismatch"];
  Mismatch mismatch{m.at("stage"),    m.at("field"), m.at("cycle"), m.at("frame"), {},
                    m.at("expected"), m.at("got"),   m.at("inputs")};
  if (m.contains("line")) mismatch.line = m.at("line").get<std::uint32_t>();
  return mismatch;
}

}  // namespace

CycleWindow window_around(Cycle cycle) {
  return {std::max(cycle - kCyclesBefore, Cycle{0}), cycle + kCyclesAfter};
}

bool write_shortest_replay(FrameReplay replay, const std::filesystem::path& file) {
  const ComparePlan plan = replay.plan;
  const std::size_t all = plan.frames.size() - 1;
  const std::size_t last =
      replay.mismatch.stage == kAnyStage ? all : std::min<std::size_t>(replay.mismatch.frame, all);
  std::set<std::size_t, std::greater<>> firsts{last, last - std::min<std::size_t>(last, 2), 0};
  const Mismatch seen = replay.mismatch;
  for (const std::size_t first : firsts) {
    replay.plan = part(plan, first, last);
    replay.mismatch = seen;
    write_replay(replay, file);
    if (const auto again = replayed(file)) {
      replay.mismatch = *again;
      write_replay(replay, file);
      return true;
    }
  }
  return false;
}

}  // namespace cigsim::cosim
