// SPDX-License-Identifier: MIT
// Frame 3: edge orderer, priority resolver and video processor together, in all mixes of levels.
// Pictures are those of the functional levels; every word takes the same cycles in every mix.
#include <gtest/gtest.h>

#include "models/edge_orderer/clocked.hpp"
#include "models/edge_orderer/functional.hpp"
#include "models/edge_orderer/timed.hpp"
#include "models/priority_resolver/clocked.hpp"
#include "models/priority_resolver/functional.hpp"
#include "models/priority_resolver/timed.hpp"
#include "models/video_processor/clocked.hpp"
#include "models/video_processor/functional.hpp"
#include "models/video_processor/timed.hpp"
#include "tests/support/fresh_simulation.hpp"
#include "tests/support/stage_bench.hpp"

namespace cigsim {
namespace {

constexpr Word kOne = 1 << kRasterFraction;

struct Frame {
  std::vector<EdgeWord> edges;  ///< with the end word
  std::vector<FaceWord> faces;  ///< with the end word
  Colour background;
};

/// A machine and its pictures.
struct Case {
  explicit Case(unsigned seed) : waits(seed) {
    std::mt19937 random(seed);
    const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
    machine.raster.width = static_cast<int>(1 + below(60));
    machine.raster.height = static_cast<int>(1 + below(12));
    machine.elements_per_cycle = 1 + below(6);
    machine.crossing_capacity = below(3) == 0 ? 0 : 2 + below(12);
    policy = static_cast<OverloadPolicy>(below(3));
    if (below(4) != 0) {
      machine.line_cycles = machine.raster.width + below(12);
      machine.frame_cycles = machine.line_cycles * machine.raster.height + below(40);
    }
    for (std::uint32_t& depth : depths) depth = 1 + below(below(2) ? 3 : 20);
    const std::uint32_t count = 1 + below(3), most = 1 + below(below(2) ? 5 : 25);
    for (std::uint32_t k = 0; k < count; ++k) add_frame(random, below(most));
  }

  MachineDescription machine;
  OverloadPolicy policy;
  std::vector<Frame> frames;
  std::uint32_t depths[4];
  test::Waits waits;

 private:
  void add_frame(std::mt19937& random, std::uint32_t faces) {
    const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
    Frame frame;
    const std::uint32_t height = static_cast<std::uint32_t>(machine.raster.height);
    for (std::uint32_t f = 0; f < faces; ++f) {
      const std::uint32_t first = below(height), end = first + 1 + below(height - first);
      for (const bool left : {true, false}) {
        const std::uint32_t corner = first + below(end - first);
        for (const auto& [from, to] : {std::pair{first, corner}, std::pair{corner, end}}) {
          if (from == to) continue;
          EdgeWord edge;
          edge.face = f;
          edge.first_line = static_cast<std::uint16_t>(from);
          edge.end_line = static_cast<std::uint16_t>(to);
          edge.left = left;
          edge.x = static_cast<Word>(random() %
                                     (static_cast<std::uint32_t>(machine.raster.width) * kOne));
          edge.slope = static_cast<Word>(random() % (8 * kOne)) - 4 * kOne;
          frame.edges.push_back(edge);
        }
      }
      frame.faces.push_back({f, false, below(70000), below(1u << 24)});
    }
    frame.edges.push_back({});
    frame.edges.back().end = true;
    frame.faces.push_back({0, true, 0, 0});
    frame.background = {static_cast<std::uint8_t>(below(256)), 0, 0};
    frames.push_back(frame);
  }
};

struct Shown {
  std::vector<std::uint32_t> colours;
  std::vector<std::uint16_t> numbers;
  Cycle first = 0, last = 0;
  friend bool operator==(const Shown&, const Shown&) = default;
};

std::vector<Shown> functional_pictures(const Case& c) {
  std::vector<Shown> pictures;
  priority_resolver::Functional resolver;
  for (const Frame& frame : c.frames) {
    EdgeList<MachineWord> list;
    for (const FaceWord& word : frame.faces) {
      if (word.end) continue;
      RasterFace face;
      face.object = word.object;
      face.colour = {static_cast<std::uint8_t>(word.colour),
                     static_cast<std::uint8_t>(word.colour >> 8),
                     static_cast<std::uint8_t>(word.colour >> 16)};
      face.first_edge = static_cast<std::uint32_t>(list.edges.size());
      for (const EdgeWord& edge : frame.edges)
        if (!edge.end && edge.face == word.face)
          list.edges.push_back({edge.first_line, edge.end_line, edge.left, {edge.x}, {edge.slope}});
      face.edge_count = static_cast<std::uint32_t>(list.edges.size()) - face.first_edge;
      list.faces.push_back(face);
    }
    edge_orderer::OrderedCrossings crossings;
    edge_orderer::Functional<MachineWord>(c.machine.crossing_capacity, c.policy)
        .compute(list, c.machine.raster, crossings);
    priority_resolver::SpanLines spans;
    resolver.compute(crossings, list.faces.size(), c.machine.raster, spans);
    Picture picture;
    video_processor::Functional().compute(spans, list.faces, frame.background, c.machine.raster,
                                          picture);
    pictures.push_back({picture.colours, picture.numbers});
  }
  return pictures;
}

/// Gives the edges and faces of a picture when the one before has started, and starts it when all
/// is loaded and the one before is shown.
class Sequencer : public sc_core::sc_module {
 public:
  struct Links {
    Link<EdgeWord>& edges;
    Link<FaceWord>& faces;
    Link<FrameWord>&edges_loaded, &faces_loaded, &start_orderer, &start_video, &shown;
  };
  Sequencer(sc_core::sc_module_name name, const Case& c, video_processor::VideoBanks& banks,
            const Links& links)
      : sc_module(name), case_(c), banks_(banks), links_(links) {
    SC_HAS_PROCESS(Sequencer);
    SC_THREAD(run);
  }

 private:
  void run() {
    Cycle at = 0;
    const auto wait_for = [&](Link<FrameWord>& link) {
      const Cycle taken = link.available();
      link.take(taken);
      at = std::max(at, taken);
    };
    const auto give = [&](std::size_t k) {
      if (k == case_.frames.size()) return;
      banks_[k % 2].background = case_.frames[k].background;
      for (const FaceWord& face : case_.frames[k].faces) links_.faces.offer(face, at + 1);
      for (const EdgeWord& edge : case_.frames[k].edges) links_.edges.offer(edge, at + 1);
    };
    give(0);
    for (std::uint32_t k = 0; k < case_.frames.size(); ++k) {
      wait_for(links_.edges_loaded);
      wait_for(links_.faces_loaded);
      if (k > 0) wait_for(links_.shown);
      links_.start_orderer.push(FrameWord{k}, std::max(at + 1, links_.start_orderer.room()));
      links_.start_video.push(FrameWord{k}, std::max(at + 1, links_.start_video.room()));
      give(k + 1);
    }
    wait_for(links_.shown);
  }

  const Case& case_;
  video_processor::VideoBanks& banks_;
  Links links_;
};

/// The three stages: bit 0 of `clocked` is the edge orderer, 1 the resolver, 2 the video processor.
struct Bench {
  Bench(const Case& c, unsigned clocked, const Clock& clock)
      : edges("edges", c.depths[0], c.waits),
        faces("faces", c.depths[1], c.waits),
        crossings("crossings", c.depths[2], c.waits),
        spans("spans", c.depths[3], c.waits),
        edges_loaded("edges_loaded", 1, c.waits),
        faces_loaded("faces_loaded", 1, c.waits),
        start_orderer("start_orderer", 1, c.waits),
        start_video("start_video", 1, c.waits),
        shown("shown", 1, c.waits) {
    parts.make<Sequencer>(
        c, banks,
        Sequencer::Links{edges.link, faces.link, edges_loaded.link, faces_loaded.link,
                         start_orderer.link, start_video.link, shown.link});
    PinOut<CrossingWord>* crossings_out = nullptr;
    PinIn<CrossingWord>* crossings_in = nullptr;
    PinOut<SpanWord>* spans_out = nullptr;
    PinIn<SpanWord>* spans_in = nullptr;
    make_orderer(c, clocked & 1 ? &clock : nullptr, crossings_out);
    make_resolver(c, clocked & 2 ? &clock : nullptr, crossings_in, spans_out);
    make_video(c, clocked & 4 ? &clock : nullptr, spans_in);
    connect(clock, crossings_out, crossings.link, crossings_in);
    connect(clock, spans_out, spans.link, spans_in);
  }

  void make_orderer(const Case& c, const Clock* clock, PinOut<CrossingWord>*& out) {
    using namespace edge_orderer;
    const auto report = [this](const Figures& f) { orderer_figures.push_back(f); };
    if (clock == nullptr) {
      parts.make<Timed>(
          c.machine, c.policy,
          Timed::Links{edges.link, edges_loaded.link, start_orderer.link, crossings.link}, report);
      return;
    }
    auto& stage = parts.make<Clocked>(c.machine, c.policy, *clock, report);
    stage.clock(clock->wire);
    parts.connect(*clock, edges.link, stage.edges);
    parts.connect(*clock, stage.loaded, edges_loaded.link);
    parts.connect(*clock, start_orderer.link, stage.start);
    out = &stage.crossings;
  }
  void make_resolver(const Case& c, const Clock* clock, PinIn<CrossingWord>*& in,
                     PinOut<SpanWord>*& out) {
    using namespace priority_resolver;
    const auto report = [this](const Figures& f) { resolver_figures.push_back(f); };
    if (clock == nullptr) {
      parts.make<Timed>(c.machine, Timed::Links{crossings.link, spans.link}, report);
      return;
    }
    auto& stage = parts.make<Clocked>(c.machine, *clock, report);
    stage.clock(clock->wire);
    in = &stage.crossings;
    out = &stage.spans;
  }
  void make_video(const Case& c, const Clock* clock, PinIn<SpanWord>*& in) {
    using namespace video_processor;
    Outputs outputs;
    outputs.figures = [this](const Figures& f) { video_figures.push_back(f); };
    outputs.picture = [this](std::uint32_t, const Picture& picture, Cycle first, Cycle last) {
      pictures.push_back({picture.colours, picture.numbers, first, last});
    };
    if (clock == nullptr) {
      parts.make<Timed>(
          c.machine,
          Timed::Links{faces.link, faces_loaded.link, start_video.link, spans.link, shown.link},
          banks, outputs);
      return;
    }
    auto& stage = parts.make<Clocked>(c.machine, *clock, banks, outputs);
    stage.clock(clock->wire);
    parts.connect(*clock, faces.link, stage.faces);
    parts.connect(*clock, stage.loaded, faces_loaded.link);
    parts.connect(*clock, start_video.link, stage.start);
    parts.connect(*clock, stage.shown, shown.link);
    in = &stage.spans;
  }
  template <class T>
  void connect(const Clock& clock, PinOut<T>* from, Link<T>& link, PinIn<T>* to) {
    if (from && to)
      parts.connect(clock, *from, link, *to);
    else if (from)
      parts.connect(clock, *from, link);
    else if (to)
      parts.connect(clock, link, *to);
  }

  test::RecordedLink<EdgeWord> edges;
  test::RecordedLink<FaceWord> faces;
  test::RecordedLink<CrossingWord> crossings;
  test::RecordedLink<SpanWord> spans;
  test::RecordedLink<FrameWord> edges_loaded, faces_loaded, start_orderer, start_video, shown;
  video_processor::VideoBanks banks;
  std::vector<edge_orderer::Figures> orderer_figures;
  std::vector<priority_resolver::Figures> resolver_figures;
  std::vector<video_processor::Figures> video_figures;
  std::vector<Shown> pictures;
  test::Parts parts;
};

TEST(Display, EveryMixOfLevelsShowsTheFunctionalPicturesInTheSameCycles) {
  constexpr unsigned kCases = 150, kMixes = 8;
  test::fresh_simulation();
  Clock clock("clock", 125);
  std::vector<std::unique_ptr<Case>> cases;
  std::vector<std::unique_ptr<Bench>> benches;
  for (unsigned seed = 0; seed < kCases; ++seed) {
    cases.push_back(std::make_unique<Case>(seed));
    for (unsigned mix = 0; mix < kMixes; ++mix)
      benches.push_back(std::make_unique<Bench>(*cases.back(), mix, clock));
  }
  test::run_timed_then_clocked(clock, [&] {
    Cycle last = 0;
    for (unsigned seed = 0; seed < kCases; ++seed)
      last = std::max(last, test::last_taken(benches[seed * kMixes]->shown.history));
    return last;
  });
  for (unsigned seed = 0; seed < kCases; ++seed) {
    const Bench& timed = *benches[seed * kMixes];
    std::vector<Shown> expected = functional_pictures(*cases[seed]);
    for (unsigned mix = 0; mix < kMixes; ++mix) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", mix " + std::to_string(mix));
      const Bench& bench = *benches[seed * kMixes + mix];
      ASSERT_EQ(bench.pictures.size(), expected.size());
      for (std::size_t k = 0; k < expected.size(); ++k) {
        ASSERT_EQ(bench.pictures[k].colours, expected[k].colours);
        ASSERT_EQ(bench.pictures[k].numbers, expected[k].numbers);
      }
      ASSERT_EQ(bench.edges.history, timed.edges.history);
      ASSERT_EQ(bench.faces.history, timed.faces.history);
      ASSERT_EQ(bench.crossings.history, timed.crossings.history);
      ASSERT_EQ(bench.spans.history, timed.spans.history);
      ASSERT_EQ(bench.shown.history, timed.shown.history);
      ASSERT_TRUE(bench.pictures == timed.pictures);
      ASSERT_TRUE(bench.orderer_figures == timed.orderer_figures);
      ASSERT_TRUE(bench.resolver_figures == timed.resolver_figures);
      ASSERT_TRUE(bench.video_figures == timed.video_figures);
    }
  }
}

}  // namespace
}  // namespace cigsim
