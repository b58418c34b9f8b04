// SPDX-License-Identifier: MIT
// A case for the edge orderer: pictures of edges, when the links stall, and who gives the edges and
// starts the pictures.
#pragma once

#include <random>
#include <vector>

#include "models/machine/description.hpp"
#include "tests/support/stage_bench.hpp"

namespace cigsim::test {

inline constexpr Word kOneElement = 1 << kRasterFraction;

/// A machine and the edges of some pictures.
struct OrdererCase {
  MachineDescription machine;
  OverloadPolicy policy = OverloadPolicy::kDrop;
  std::vector<std::vector<EdgeWord>> frames;  ///< without end words
  Waits waits{0};
  std::uint32_t depths[4] = {1, 1, 1, 1};

  OrdererCase() = default;
  explicit OrdererCase(unsigned seed) : waits(seed) {
    std::mt19937 random(seed);
    const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
    machine.raster.width = static_cast<int>(1 + below(below(3) == 0 ? 3 : 60));
    machine.raster.height = static_cast<int>(1 + below(below(3) == 0 ? 3 : 12));
    machine.crossing_capacity = below(4) == 0 ? 0 : 2 + below(12);
    policy = static_cast<OverloadPolicy>(below(3));
    for (std::uint32_t& depth : depths) depth = 1 + below(below(2) ? 3 : 20);
    const std::uint32_t count = 1 + below(3), most = 1 + below(below(4) == 0 ? 4 : 80);
    for (std::uint32_t k = 0; k < count; ++k) add_frame(random, below(most));
    if (below(2) == 0) machine.edge_capacity = 80;
  }

 private:
  void add_frame(std::mt19937& random, std::uint32_t edges) {
    const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
    const bool wild = below(4) == 0, whole = below(4) == 0;
    std::vector<EdgeWord> frame;
    std::uint32_t face = 0;
    for (std::uint32_t e = 0; e < edges; ++e) {
      EdgeWord edge;
      face += below(3) == 0;
      edge.face = face;
      edge.first_line =
          static_cast<std::uint16_t>(below(static_cast<std::uint32_t>(machine.raster.height)));
      edge.end_line = static_cast<std::uint16_t>(
          edge.first_line + 1 +
          below(static_cast<std::uint32_t>(machine.raster.height) - edge.first_line));
      edge.left = below(2) == 1;
      edge.x = static_cast<Word>(
                   below(static_cast<std::uint32_t>(machine.raster.width + 8) * kOneElement)) -
               4 * kOneElement;
      edge.slope = static_cast<Word>(below(16 * kOneElement)) - 8 * kOneElement;
      if (whole) {
        edge.x = edge.x / kOneElement * kOneElement;
        edge.slope = edge.slope / kOneElement * kOneElement;
      }
      if (wild && below(3) == 0) {
        edge.x = static_cast<Word>(random());
        edge.slope = static_cast<Word>(random());
      }
      frame.push_back(edge);
    }
    frames.push_back(frame);
  }
};

/// Edges across all lines of a raster.
inline OrdererCase upright_edges(std::uint32_t edges, int height, std::uint32_t capacity,
                                 OverloadPolicy policy) {
  OrdererCase c;
  c.machine.raster = {1024, height};
  c.machine.crossing_capacity = capacity;
  c.policy = policy;
  c.waits = Waits::none();
  for (std::uint32_t& depth : c.depths) depth = 16;
  c.frames.emplace_back();
  for (std::uint32_t e = 0; e < edges; ++e) {
    EdgeWord edge;
    edge.face = e / 2;
    edge.left = e % 2 == 0;
    edge.end_line = static_cast<std::uint16_t>(height);
    edge.x = static_cast<Word>(e) * kOneElement;
    c.frames[0].push_back(edge);
  }
  return c;
}

/// Gives the edges of a picture when the bank is no longer read, and starts it when they are
/// loaded and the picture before is done.
class OrdererSequencer : public sc_core::sc_module {
 public:
  OrdererSequencer(sc_core::sc_module_name name, const OrdererCase& c, Link<EdgeWord>& edges,
                   Link<FrameWord>& loaded, Link<FrameWord>& start, Link<CrossingWord>& crossings)
      : sc_module(name),
        case_(c),
        edges_(edges),
        loaded_(loaded),
        start_(start),
        crossings_(crossings),
        done_("done", 4) {
    SC_HAS_PROCESS(OrdererSequencer);
    SC_THREAD(give);
    SC_THREAD(take);
  }

 private:
  void give() {
    Cycle at = -1;
    std::uint64_t word = 0;
    const auto feed = [&](std::size_t frame) {
      if (frame == case_.frames.size()) return;
      for (const EdgeWord& edge : case_.frames[frame])
        at = edges_.push_from(edge, at + 1 + case_.waits("feeder", word++));
      EdgeWord end;
      end.end = true;
      at = edges_.push_from(end, at + 1);
    };
    const auto wait_for = [&](Link<FrameWord>& link) {
      const Cycle taken = link.available();
      link.take(taken);
      at = std::max(at, taken);
    };
    feed(0);
    for (std::uint32_t k = 0; k < case_.frames.size(); ++k) {
      wait_for(loaded_);
      if (k > 0) wait_for(done_);
      at = start_.push_from({k}, at + 1 + case_.waits("starter", k));
      feed(k + 1);
    }
  }
  void take() {
    Cycle at = -1;
    std::uint64_t word = 0;
    for (int lines = 0;;) {
      at = std::max(crossings_.available(), at + 1 + case_.waits("resolver", word++));
      lines += crossings_.front().end;
      crossings_.take(at);
      if (lines < case_.machine.raster.height) continue;
      lines = 0;
      done_.push_from({0}, at);
    }
  }

  const OrdererCase& case_;
  Link<EdgeWord>& edges_;
  Link<FrameWord>&loaded_, &start_;
  Link<CrossingWord>& crossings_;
  Link<FrameWord> done_;
};

}  // namespace cigsim::test
