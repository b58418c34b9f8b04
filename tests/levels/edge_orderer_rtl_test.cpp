// SPDX-License-Identifier: MIT
// Edge orderer: the RTL against the clocked level, on every pin in every cycle.
#include <gtest/gtest.h>

#include <limits>

#include "models/edge_orderer/clocked.hpp"
#include "models/edge_orderer/rtl.hpp"
#include "rtl/edge_orderer/edge_orderer.pins.hpp"
#include "tests/levels/orderer_case.hpp"
#include "tests/support/cases.hpp"
#include "tests/support/fresh_simulation.hpp"

namespace cigsim::edge_orderer {
namespace {

using test::kOneElement;
using test::OrdererCase;
using test::upright_edges;

/// A size of the RTL that is built.
struct Size {
  const char* parameters;
  std::uint32_t edges;
  int lines;
  std::uint32_t crossings;

  std::filesystem::path library() const {
    return std::filesystem::path(CIGSIM_RTL_LIBRARIES) /
           (std::string("edge_orderer-") + parameters + ".so");
  }
};
constexpr Size kSmall{"Edges=100-Lines=16-Crossings=16", 100, 16, 16};
constexpr Size kShipped{"Edges=4096-Lines=1024-Crossings=256", 4096, 1024, 256};

/// The pins of a cycle.
struct Cut {
  bool edges[2], loaded[2], start[2], crossings[2];  ///< valid, ready
  EdgeWord edge;
  FrameWord loaded_frame, start_frame;
  CrossingWord crossing;
  friend bool operator==(const Cut&, const Cut&) = default;
};
void PrintTo(const Cut& cut, std::ostream* out) {
  *out << "edges " << cut.edges[0] << cut.edges[1] << " " << cut.edge << "; loaded "
       << cut.loaded[0] << cut.loaded[1] << " " << cut.loaded_frame << "; start " << cut.start[0]
       << cut.start[1] << " " << cut.start_frame << "; crossings " << cut.crossings[0]
       << cut.crossings[1] << " " << cut.crossing;
}

template <class Stage>
class PinRecorder : public sc_core::sc_module {
 public:
  PinRecorder(sc_core::sc_module_name name, const Clock& clock, const Stage& stage)
      : sc_module(name), stage_(stage) {
    SC_HAS_PROCESS(PinRecorder);
    SC_METHOD(edge);
    dont_initialize();
    sensitive << clock.wire.posedge_event();
  }
  std::vector<Cut> cuts;

 private:
  void edge() {
    cuts.push_back({{stage_.edges.valid, stage_.edges.ready},
                    {stage_.loaded.valid, stage_.loaded.ready},
                    {stage_.start.valid, stage_.start.ready},
                    {stage_.crossings.valid, stage_.crossings.ready},
                    stage_.edges.word,
                    stage_.loaded.word,
                    stage_.start.word,
                    stage_.crossings.word});
  }
  const Stage& stage_;
};

/// A stage between links with the stalls of a case. `arguments` of the RTL: library, seed.
template <class Stage>
class Bench {
 public:
  template <class... Arguments>
  Bench(const OrdererCase& c, const Clock& clock, Arguments... arguments)
      : edges_("edges", c.depths[0], c.waits),
        loaded_("loaded", c.depths[1], c.waits),
        start_("start", c.depths[2], c.waits),
        crossings_("crossings", c.depths[3], c.waits) {
    parts_.make<test::OrdererSequencer>(c, edges_, loaded_, start_, crossings_);
    const FiguresFunction report = [this](const Figures& frame) { figures.push_back(frame); };
    Stage& stage = make(c, clock, report, arguments...);
    stage.clock(clock.wire);
    parts_.connect(clock, edges_, stage.edges);
    parts_.connect(clock, stage.loaded, loaded_);
    parts_.connect(clock, start_, stage.start);
    parts_.connect(clock, stage.crossings, crossings_);
    recorder_ = &parts_.make<PinRecorder<Stage>>(clock, stage);
  }
  const std::vector<Cut>& cuts() const { return recorder_->cuts; }
  std::vector<Figures> figures;

 private:
  Stage& make(const OrdererCase& c, const Clock& clock, const FiguresFunction& report) {
    return parts_.make<Stage>(c.machine, c.policy, clock, report);
  }
  Stage& make(const OrdererCase& c, const Clock& clock, const FiguresFunction& report,
              const std::filesystem::path& library, std::uint32_t seed) {
    return parts_.make<Stage>(c.machine, c.policy, clock, library, report, seed);
  }
  Link<EdgeWord> edges_;
  Link<FrameWord> loaded_, start_;
  Link<CrossingWord> crossings_;
  test::Parts parts_;
  PinRecorder<Stage>* recorder_;
};

void lock_step(const Size& size, const std::vector<std::unique_ptr<OrdererCase>>& cases) {
  test::fresh_simulation();
  Clock clock("clock", 125);
  std::vector<std::unique_ptr<Bench<Clocked>>> clocked;
  std::vector<std::unique_ptr<Bench<Rtl>>> rtl;
  for (const auto& c : cases) {
    const auto seed = static_cast<std::uint32_t>(clocked.size()) + 1;
    clocked.push_back(std::make_unique<Bench<Clocked>>(*c, clock));
    rtl.push_back(std::make_unique<Bench<Rtl>>(*c, clock, size.library(), seed));
  }
  const auto running = [&] {
    for (std::size_t i = 0; i < cases.size(); ++i)
      if (clocked[i]->figures.size() < cases[i]->frames.size()) return true;
    return false;
  };
  clock.start();
  for (int hundreds = 0; running() && hundreds < 1000; ++hundreds)
    sc_core::sc_start(100 * clock.period());
  sc_core::sc_start(10 * clock.period());
  clock.stop();

  for (std::size_t i = 0; i < cases.size(); ++i) {
    SCOPED_TRACE("case " + std::to_string(i));
    ASSERT_EQ(clocked[i]->figures.size(), cases[i]->frames.size());
    ASSERT_EQ(rtl[i]->cuts().size(), clocked[i]->cuts().size());
    for (std::size_t cycle = 0; cycle < clocked[i]->cuts().size(); ++cycle)
      ASSERT_EQ(rtl[i]->cuts()[cycle], clocked[i]->cuts()[cycle]) << "in cycle " << cycle;
    ASSERT_TRUE(rtl[i]->figures == clocked[i]->figures);
  }
}

/// Random cases that fit the size, the first of `first_seed`.
std::vector<std::unique_ptr<OrdererCase>> random_cases(const Size& size, unsigned first_seed,
                                                       std::size_t count) {
  std::vector<std::unique_ptr<OrdererCase>> cases;
  for (unsigned seed = first_seed; cases.size() < count; ++seed) {
    auto made = std::make_unique<OrdererCase>(seed);
    const std::uint32_t capacity = made->machine.crossing_capacity;
    const bool fits = capacity == 0 ? size.crossings >= 80 : capacity <= size.crossings;
    if (fits) cases.push_back(std::move(made));
  }
  return cases;
}

TEST(EdgeOrdererRtl, EveryPinAgreesWithClockedInEveryCycleOfASmallOne) {
  lock_step(kSmall, random_cases(kSmall, 0, test::cases(500)));
}
TEST(EdgeOrdererRtl, EveryPinAgreesWithClockedInEveryCycleOfTheShippedSize) {
  lock_step(kShipped, random_cases(kShipped, 5000, test::cases(100)));
}

// Lines of `capacity` crossings and more, whose elements come from all sides, in faces of a few
// edges each, through all cells of the sorting memories.
std::unique_ptr<OrdererCase> crowded(unsigned seed, std::uint32_t capacity, std::uint32_t edges,
                                     OverloadPolicy policy) {
  std::mt19937 random(seed);
  const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
  auto c = std::make_unique<OrdererCase>(upright_edges(edges, 5, capacity, policy));
  const std::uint32_t faces = 1 + below(edges);
  for (EdgeWord& edge : c->frames[0]) {
    edge.face = below(faces);
    edge.x = static_cast<Word>(below(1030 * kOneElement));
    edge.slope = static_cast<Word>(below(200 * kOneElement)) - 100 * kOneElement;
    edge.first_line = static_cast<std::uint16_t>(below(2));
  }
  c->frames.push_back(c->frames[0]);
  return c;
}

TEST(EdgeOrdererRtl, FullAndOverfullSortingMemoriesAgree) {
  constexpr OverloadPolicy kPolicies[] = {OverloadPolicy::kDrop, OverloadPolicy::kCut,
                                          OverloadPolicy::kExtend};
  std::vector<std::unique_ptr<OrdererCase>> small, shipped;
  for (unsigned seed = 0; seed < 60; ++seed) {
    small.push_back(crowded(seed, 16, 10 + seed, kPolicies[seed % 3]));
    if (seed < 15) shipped.push_back(crowded(seed, 256, 200 + 40 * seed, kPolicies[seed % 3]));
  }
  lock_step(kSmall, small);
  lock_step(kShipped, shipped);
}

// As many edges and lines as the shipped size has, faces and elements of all bits.
TEST(EdgeOrdererRtl, PicturesOfTheWholeShippedSizeAgree) {
  std::vector<std::unique_ptr<OrdererCase>> cases;
  for (const int width : {16383, 9000}) {
    std::mt19937 random(static_cast<unsigned>(width));
    const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
    cases.push_back(std::make_unique<OrdererCase>(
        upright_edges(kShipped.edges, kShipped.lines, kShipped.crossings, OverloadPolicy::kDrop)));
    OrdererCase& c = *cases.back();
    c.machine.raster.width = width;
    c.machine.crossing_capacity = width == 9000 ? 200 : 256;
    c.frames.push_back(c.frames[0]);
    for (auto& frame : c.frames) {
      const std::uint32_t crowd = below(static_cast<std::uint32_t>(kShipped.lines));
      for (EdgeWord& edge : frame) {
        edge.face = below(1 << 24);
        const bool crowded = below(8) == 0;  // into a line with more than the capacity
        edge.first_line = static_cast<std::uint16_t>(crowded ? crowd : below(kShipped.lines));
        edge.end_line = static_cast<std::uint16_t>(
            std::min<std::uint32_t>(edge.first_line + 1 + below(3), kShipped.lines));
        edge.x = static_cast<Word>(random());
        edge.slope = static_cast<Word>(random()) / 4;
      }
    }
  }
  lock_step(kShipped, cases);
}

// All edges of the shipped size on one line, and all or most that go on to the next; in few faces,
// of which many crossings go at once; elements and faces of all bits.
TEST(EdgeOrdererRtl, EveryEdgeOfTheShippedSizeOnOneLineAgrees) {
  std::mt19937 random(1979);
  const auto one_of = [&](std::uint32_t n) { return random() % n == 0; };
  std::vector<std::unique_ptr<OrdererCase>> cases;
  const auto add = [&](OverloadPolicy policy, int lines) -> std::vector<EdgeWord>& {
    cases.push_back(std::make_unique<OrdererCase>(
        upright_edges(kShipped.edges, lines, kShipped.crossings, policy)));
    cases.back()->machine.raster.width = 16383;
    for (EdgeWord& edge : cases.back()->frames[0]) {
      edge.x = static_cast<Word>(random());
      edge.slope = static_cast<Word>(random()) / 4;
    }
    return cases.back()->frames[0];
  };
  for (EdgeWord& edge : add(OverloadPolicy::kDrop, 2)) edge.face = 0x5a'5a5a >> random() % 4;
  for (EdgeWord& edge : add(OverloadPolicy::kDrop, 2)) edge.face = 0xa5'a5a5 >> one_of(4);
  for (EdgeWord& edge : add(OverloadPolicy::kCut, 2)) edge.end_line -= one_of(8);
  for (EdgeWord& edge : add(OverloadPolicy::kExtend, 1)) {
    edge.face = static_cast<std::uint32_t>(random() % (1 << 24));
    if (one_of(8)) edge.x = std::numeric_limits<Word>::max();
  }
  lock_step(kShipped, cases);
}

// Each bucket of the small size once with all edges.
TEST(EdgeOrdererRtl, AnyBucketHoldsAllEdges) {
  std::vector<std::unique_ptr<OrdererCase>> cases;
  cases.push_back(std::make_unique<OrdererCase>(
      upright_edges(kSmall.edges, kSmall.lines, 16, OverloadPolicy::kDrop)));
  OrdererCase& c = *cases.back();
  const std::vector<EdgeWord> edges = c.frames[0];
  c.frames.clear();
  for (int line = 0; line < kSmall.lines; ++line) {
    c.frames.push_back(edges);
    for (EdgeWord& edge : c.frames.back()) {
      edge.first_line = static_cast<std::uint16_t>(line);
      edge.end_line = static_cast<std::uint16_t>(line + 1);
    }
  }
  lock_step(kSmall, cases);
}

/// The module of the small size, out of reset.
class Module {
 public:
  using Pins = rtl::edge_orderer::Pins;
  Module(std::uint32_t height, std::uint32_t capacity, OverloadPolicy policy)
      : model_(kSmall.library(), sizeof(Pins), 1) {
    pins().rst_i = true;
    pins().cfg_width_i = 16;
    pins().cfg_height_i = static_cast<decltype(Pins::cfg_height_i)>(height);
    pins().cfg_crossing_capacity_i = capacity;
    pins().cfg_policy_i = static_cast<decltype(Pins::cfg_policy_i)>(policy);
    edge();
    edge();
    pins().rst_i = false;
    model_.settle();
  }
  Pins& pins() { return model_.pins<Pins>(); }
  void edge() { model_.edge(); }

 private:
  RtlModel model_;
};

// All bits of the configuration are looked at.
TEST(EdgeOrdererRtl, RastersOfTooManyLinesAreTold) {
  for (int bit = 0; bit < 14; ++bit)
    for (const std::uint32_t more : {0u, 1u}) {
      const std::uint32_t height = (1u << bit) + more;
      Module module(height, 16, OverloadPolicy::kDrop);
      EXPECT_EQ(module.pins().mon_too_small_o, height > 16) << height;
    }
}

// A capacity of more crossings than there are cells is none that is reached: a line that fills the
// cells is told as too much for the size, under every policy, and is not filled in more passes.
TEST(EdgeOrdererRtl, CapacitiesOf32Bits) {
  for (int bit = 5; bit < 32; ++bit)
    for (const std::uint32_t more : {0u, 16u})
      for (const OverloadPolicy policy :
           {OverloadPolicy::kDrop, OverloadPolicy::kCut, OverloadPolicy::kExtend}) {
        Module module(1, (1u << bit) + more, policy);
        Module::Pins& pins = module.pins();
        pins.edges_valid_i = true;
        pins.edges_end_line_i = 1;
        for (int edge = 0; edge < 17; ++edge) module.edge();
        pins.edges_end_line_i = 0;
        pins.edges_end_i = true;
        module.edge();
        pins.edges_valid_i = false;
        pins.loaded_ready_i = true;
        module.edge();
        pins.loaded_ready_i = false;
        pins.start_valid_i = true;
        module.edge();
        pins.start_valid_i = false;
        int passes = 0;
        bool overfull = false;
        for (int cycle = 0; cycle < 40; ++cycle) {
          passes += pins.mon_pass_o;
          overfull |= pins.mon_overfull_o;
          EXPECT_EQ(pins.mon_too_small_o, cycle > 17) << cycle;
          EXPECT_EQ(pins.mon_dropped_o, 0u);
          module.edge();
        }
        EXPECT_EQ(passes, 1) << bit;
        EXPECT_FALSE(overfull) << bit;
      }
}

// The sequencer of a machine always has room for a loaded word. Without it the word is held, and no
// edge taken.
TEST(EdgeOrdererRtl, LoadedWordIsHeldUntilItIsTaken) {
  using rtl::edge_orderer::Pins;
  RtlModel model(kSmall.library(), sizeof(Pins), 1);
  Pins& pins = model.pins<Pins>();
  pins.rst_i = true;
  pins.cfg_width_i = pins.cfg_height_i = 16;
  model.edge();
  model.edge();
  pins.rst_i = false;
  model.edge();
  for (std::uint32_t frame = 0; frame < 300; ++frame) {
    ASSERT_TRUE(pins.edges_ready_o);
    pins.edges_valid_i = pins.edges_end_i = true;
    pins.loaded_ready_i = false;
    model.edge();
    pins.edges_valid_i = false;
    for (int waits = 0; waits < 3; ++waits) {
      ASSERT_TRUE(pins.loaded_valid_o);
      ASSERT_EQ(pins.loaded_frame_o, frame);
      ASSERT_FALSE(pins.edges_ready_o);
      model.edge();
    }
    pins.loaded_ready_i = true;
    model.edge();
    ASSERT_FALSE(pins.loaded_valid_o);
  }
}

/// What ends a simulation of the case.
std::string fault(const OrdererCase& c) {
  test::fresh_simulation();
  Clock clock("clock", 125);
  Bench<Rtl> bench(c, clock, kSmall.library(), 1u);
  clock.start();
  try {
    sc_core::sc_start(1000 * clock.period());
  } catch (const std::exception& error) {
    return error.what();
  }
  EXPECT_EQ(bench.figures.size(), c.frames.size());
  return "";
}

TEST(EdgeOrdererRtl, PicturesBeyondTheSizeAreNamed) {
  const auto too_small = [](std::uint32_t edges, int height, std::uint32_t capacity) {
    const std::string what = fault(upright_edges(edges, height, capacity, OverloadPolicy::kDrop));
    EXPECT_TRUE(what.empty() || what.find("than this RTL size holds") != std::string::npos) << what;
    return !what.empty();
  };
  EXPECT_FALSE(too_small(100, 2, 16));
  EXPECT_TRUE(too_small(101, 2, 16));
  EXPECT_FALSE(too_small(16, 16, 0));
  EXPECT_TRUE(too_small(17, 16, 0));
  EXPECT_FALSE(too_small(16, 16, 17));
  EXPECT_TRUE(too_small(17, 16, 17));
  EXPECT_TRUE(too_small(1, 17, 16));
}

TEST(EdgeOrdererRtl, BrokenContractsEndTheSimulation) {
  OrdererCase c = upright_edges(2, 4, 16, OverloadPolicy::kDrop);
  EXPECT_EQ(fault(c), "");
  c.frames[0][1].end_line = c.frames[0][1].first_line;
  EXPECT_NE(fault(c).find("a contract of the RTL is broken"), std::string::npos);
  c.frames[0][1].end_line = 5;
  EXPECT_NE(fault(c).find("a contract of the RTL is broken"), std::string::npos);
}

}  // namespace
}  // namespace cigsim::edge_orderer
