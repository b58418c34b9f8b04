// SPDX-License-Identifier: MIT
#include "sim/experiments/so_steps.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <map>

#include "models/database/separation_pairs.hpp"
#include "models/frame_calculator/functional.hpp"
#include "models/priority_processor/eye_side.hpp"
#include "models/priority_processor/so_golden.hpp"
#include "sim/host_time.hpp"

namespace cigsim {
namespace {

using priority_processor::SoAnswers;
using priority_processor::SoGolden;
using priority_processor::SoIncremental;
using priority_processor::SoUpdateWork;

std::span<const SeparationNode> nodes_of(const PriorityHierarchy& hierarchy, std::uint32_t group) {
  const Group& g = hierarchy.groups[group];
  return {hierarchy.nodes.data() + g.first_node, g.node_count};
}

// The plane resolves every pair that it parts.
bool resolves_all(const PriorityHierarchy& hierarchy, const SeparationNode& node) {
  std::array<std::uint64_t, kGroupCapacity> listed{};
  for_each_pair(hierarchy, node,
                [&](std::uint32_t t, std::uint32_t f) { listed[t] |= std::uint64_t{1} << f; });
  bool all = true;
  for_each_member(node.true_members,
                  [&](std::uint32_t t) { all = all && listed[t] == node.false_members; });
  return all;
}

bool has_matrix(const PriorityHierarchy& hierarchy, std::uint32_t group) {
  const auto nodes = nodes_of(hierarchy, group);
  return std::all_of(nodes.begin(), nodes.end(),
                     [&](const SeparationNode& node) { return resolves_all(hierarchy, node); });
}

// A group in a frame: what the matrix is asked.
struct Ask {
  std::uint32_t group = 0;
  std::uint64_t active = 0, eye_true = 0;
};
using Frame = std::vector<Ask>;

std::vector<Frame> frames_of(const Database& database, const std::vector<FrameView>& views,
                             const Raster& raster, std::uint64_t& left_out) {
  const PriorityHierarchy& hierarchy = database.systems[0].hierarchy;
  // A table made by hand has one group.
  const bool matrix = hierarchy.pairs.empty() || has_matrix(hierarchy, 0);
  ActiveEnvironment active;
  FaceSet moving;
  std::vector<Frame> frames;
  for (const FrameView& view : views) {
    frame_calculator::Functional(database).compute(view.viewpoint, raster, view.position, active,
                                                   moving);
    Frame& frame = frames.emplace_back();
    for (const ActiveGroup& group : active.groups) {
      if (std::popcount(group.active) < 2 || hierarchy.groups[group.group].node_count == 0)
        continue;
      if (!matrix) {
        ++left_out;
        continue;
      }
      Ask ask{group.group, group.active, 0};
      const auto nodes = nodes_of(hierarchy, group.group);
      for (std::size_t n = 0; n < nodes.size(); ++n)
        if (priority_processor::eye_on_true_side<double>(hierarchy.planes[nodes[n].plane],
                                                         active.view.eye))
          ask.eye_true |= std::uint64_t{1} << n;
      frame.push_back(ask);
    }
  }
  return frames;
}

// Each group's matrix in both forms.
class Matrices {
 public:
  Matrices(const PriorityHierarchy& hierarchy, const std::vector<Frame>& frames) {
    for (const Frame& frame : frames)
      for (const Ask& ask : frame) {
        if (full_.contains(ask.group)) continue;
        const auto nodes = nodes_of(hierarchy, ask.group);
        const std::uint32_t members = hierarchy.groups[ask.group].member_count;
        kept_.emplace(ask.group, Kept{SoIncremental(nodes, members)});
        SoGolden& golden =
            full_.emplace(ask.group, SoGolden(members, static_cast<unsigned>(nodes.size())))
                .first->second;
        for (std::uint32_t m = 0; m < members; ++m) golden.set_row(m, row_of(nodes, m));
      }
  }

  // The sum of all counts, so that nothing is left out as unused.
  std::uint64_t anew(const Frame& frame) {
    std::uint64_t sum = 0;
    for (const Ask& ask : frame) {
      SoGolden& golden = full_.at(ask.group);
      golden.mark({ask.eye_true}, {ask.active});
      for (std::uint64_t rest = ask.active; rest != 0; rest &= rest - 1)
        sum += golden.row(static_cast<unsigned>(std::countr_zero(rest))).count;
    }
    return sum;
  }

  // `first`: of groups that were not in view before.
  std::uint64_t update(const Frame& frame, SoUpdateWork& first, SoUpdateWork& work,
                       std::uint64_t& rows) {
    std::uint64_t sum = 0;
    for (const Ask& ask : frame) {
      Kept& kept = kept_.at(ask.group);
      const std::uint64_t before = work.crossings;
      kept.matrix.move(ask.eye_true, kept.active == 0 ? first : work);
      if (work.crossings != before || kept.active != ask.active) {
        kept.active = ask.active;
        kept.sum = 0;
        for (std::uint64_t rest = ask.active; rest != 0; rest &= rest - 1, ++rows)
          kept.sum += static_cast<unsigned>(std::popcount(
              kept.matrix.hidden(static_cast<unsigned>(std::countr_zero(rest))) & ask.active));
      }
      sum += kept.sum;
    }
    return sum;
  }

  std::uint64_t wrong_rows(const Frame& frame) {
    std::uint64_t wrong = 0;
    for (const Ask& ask : frame)
      for (std::uint64_t rest = ask.active; rest != 0; rest &= rest - 1) {
        const auto m = static_cast<unsigned>(std::countr_zero(rest));
        const SoAnswers& row = full_.at(ask.group).row(m);
        const SoIncremental& kept = kept_.at(ask.group).matrix;
        wrong += row.hides[0] != (kept.hides(m) & ask.active) ||
                 row.hidden[0] != (kept.hidden(m) & ask.active);
      }
    return wrong;
  }

 private:
  struct Kept {
    SoIncremental matrix;
    std::uint64_t active = 0, sum = 0;
  };

  static priority_processor::SoRow row_of(std::span<const SeparationNode> nodes, std::uint32_t m) {
    priority_processor::SoRow row;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      row.plus[0] |= (nodes[n].true_members >> m & 1) << n;
      row.tells[0] |= ((nodes[n].true_members | nodes[n].false_members) >> m & 1) << n;
    }
    return row;
  }

  std::map<std::uint32_t, SoGolden> full_;
  std::map<std::uint32_t, Kept> kept_;
};

void count(const std::vector<Frame>& frames, Matrices& matrices, SoSteps& steps) {
  for (const Frame& frame : frames) {
    steps.groups += frame.size();
    for (const Ask& ask : frame) {
      const auto members = static_cast<std::uint64_t>(std::popcount(ask.active));
      steps.full_cycles += members;
      steps.pairs += members * (members - 1) / 2;
    }
    const std::uint64_t sum = matrices.anew(frame);
    if (matrices.update(frame, steps.first, steps.update, steps.row_cycles) != sum)
      ++steps.wrong_rows;
    steps.wrong_rows += matrices.wrong_rows(frame);
  }
}

}  // namespace

std::string_view SoSteps::why_not() const {
  if (groups_left_out > 0)
    return "a table made by hand resolves only some of the pairs that its planes part, which a "
           "matrix of planes cannot hold";
  return groups == 0 ? "no group has two members in view, with a plane between any" : "";
}

SoSteps so_steps(const Database& database, const std::vector<FrameView>& views,
                 const Raster& raster, std::size_t rounds, std::uint64_t seed) {
  SoSteps steps;
  steps.frames = views.size();
  const PriorityHierarchy& hierarchy = database.systems[0].hierarchy;
  const std::vector<Frame> frames = frames_of(database, views, raster, steps.groups_left_out);
  {
    Matrices matrices(hierarchy, frames);
    count(frames, matrices, steps);
  }
  // Both on matrices that have seen the flight once; its end and its beginning follow each other.
  Matrices matrices(hierarchy, frames);
  std::vector<double> full_ms, update_ms;
  std::uint64_t sums = 0, rows = 0;
  SoUpdateWork work;
  for (const Frame& frame : frames) sums += matrices.update(frame, work, work, rows);
  for (const std::size_t form : interleaved(2, rounds, seed)) {
    HostTime time;
    for (const Frame& frame : frames)
      sums += form == 0 ? matrices.anew(frame) : matrices.update(frame, work, work, rows);
    (form == 0 ? full_ms : update_ms).push_back(time.lap() / static_cast<double>(frames.size()));
  }
  // A sum that is asked for is computed.
  if (sums == ~std::uint64_t{0}) ++steps.wrong_rows;
  steps.full_ms = spread(std::move(full_ms));
  steps.update_ms = spread(std::move(update_ms));
  return steps;
}

}  // namespace cigsim
