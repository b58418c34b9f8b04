// SPDX-License-Identifier: MIT
// Video processor: the timed and the clocked level against the functional picture and a count of
// the raster, and against each other, cycle by cycle.
#include <gtest/gtest.h>

#include "models/video_processor/clocked.hpp"
#include "models/video_processor/functional.hpp"
#include "models/video_processor/timed.hpp"
#include "tests/support/fresh_simulation.hpp"
#include "tests/support/stage_bench.hpp"

namespace cigsim::video_processor {
namespace {

/// What a case is about: pictures with their faces and spans.
struct Case {
  Case() = default;
  explicit Case(unsigned seed) : waits(seed) {
    std::mt19937 random(seed);
    const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
    machine.raster.width = static_cast<int>(below(4) == 0 ? 1 + below(3) : 1 + below(60));
    machine.raster.height = static_cast<int>(1 + below(6));
    machine.elements_per_cycle = 1 + below(7);
    if (below(4) != 0) machine.line_cycles = line_length() + below(12);
    if (below(4) != 0)
      machine.frame_cycles = machine.line_cycles * machine.raster.height + below(40);
    for (std::uint32_t& depth : depths) depth = 1 + below(below(2) ? 3 : 20);
    early_starts = below(2) == 1;
    frames = 1 + below(4);
    for (std::uint32_t k = 0; k < frames; ++k) add_frame(random);
  }
  Cycle line_length() const {
    Cycle cycles = 0;
    for (std::uint32_t e = 0; e < static_cast<std::uint32_t>(machine.raster.width);
         e += machine.elements_per_cycle)
      ++cycles;
    return cycles;
  }

  MachineDescription machine;
  std::uint32_t depths[5] = {4, 4, 4, 4, 4}, frames = 0;
  bool early_starts = false;                 ///< a start word may come while a picture is shown
  std::vector<std::vector<FaceWord>> faces;  ///< by frame, with the end word
  std::vector<Colour> backgrounds;
  std::vector<SpanWord> spans;  ///< of all frames
  test::Waits waits = test::Waits::none();

 private:
  void add_frame(std::mt19937& random) {
    const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
    const std::uint32_t count = below(100);
    std::vector<FaceWord> words;
    for (std::uint32_t f = 0; f < count; ++f)
      words.push_back({f, false, below(3) ? below(500) : 65000 + below(2000), below(1u << 24)});
    words.push_back({0, true, 0, 0});
    faces.push_back(words);
    backgrounds.push_back({static_cast<std::uint8_t>(below(256)),
                           static_cast<std::uint8_t>(below(256)),
                           static_cast<std::uint8_t>(below(256))});
    const std::uint32_t width = static_cast<std::uint32_t>(machine.raster.width);
    const std::uint32_t longest = 1 + below(width);
    for (int r = 0; r < machine.raster.height; ++r)
      for (std::uint32_t e = 0; e < width;) {
        const std::uint32_t end = std::min(width, e + 1 + below(longest));
        const std::uint32_t face = count == 0 || below(4) == 0 ? kNone : below(count);
        spans.push_back(
            {face, static_cast<std::uint16_t>(e), static_cast<std::uint16_t>(end), end == width});
        e = end;
      }
  }
};

struct Shown {
  std::uint32_t frame;
  Cycle first, last;
  std::vector<std::uint32_t> colours;
  std::vector<std::uint16_t> numbers;
  friend bool operator==(const Shown&, const Shown&) = default;
};

/// The sequencer's part: starts a picture when its faces are loaded and, unless starts are early,
/// the one before is shown; gives the faces of a picture when the bank is no longer read.
class Sequencer : public sc_core::sc_module {
 public:
  struct Links {
    Link<FaceWord>& faces;
    Link<FrameWord>&loaded, &start, &shown;
  };
  Sequencer(sc_core::sc_module_name name, const Case& c, VideoBanks& banks, const Links& links)
      : sc_module(name), case_(c), banks_(banks), links_(links), shown_(c.frames, -1) {
    SC_HAS_PROCESS(Sequencer);
    SC_THREAD(start);
    SC_THREAD(take_shown);
    SC_THREAD(feed);
  }

 private:
  void start() {
    Cycle at = 0;
    for (std::uint32_t k = 0; k < case_.frames; ++k) {
      at = std::max(at, links_.loaded.available() + case_.waits("loaded drain", k));
      EXPECT_EQ(links_.loaded.front().frame, k);
      links_.loaded.take(at);
      banks_[k % 2].background = case_.backgrounds[k];
      if (k > 0 && !case_.early_starts) at = std::max(at, shown(k - 1));
      at = links_.start.push_from({k}, at + 1 + case_.waits("start feeder", k));
    }
  }
  void take_shown() {
    for (std::uint32_t k = 0; k < case_.frames; ++k) {
      const Cycle at = links_.shown.available() + case_.waits("shown drain", k);
      EXPECT_EQ(links_.shown.front().frame, k);
      links_.shown.take(at);
      shown_[k] = at;
      shown_event_.notify(sc_core::SC_ZERO_TIME);
    }
  }
  void feed() {
    Cycle at = -1;
    for (std::uint32_t k = 0, word = 0; k < case_.frames; ++k) {
      if (k >= 2) at = std::max(at, shown(k - 2));
      for (const FaceWord& face : case_.faces[k])
        at = links_.faces.push_from(face, at + 1 + case_.waits("faces feeder", word++));
    }
  }
  /// The cycle in which the word of picture k was taken from `shown`. Waits for it.
  Cycle shown(std::uint32_t k) {
    while (shown_[k] < 0) wait(shown_event_);
    return shown_[k];
  }

  const Case& case_;
  VideoBanks& banks_;
  Links links_;
  std::vector<Cycle> shown_;
  sc_core::sc_event shown_event_;
};

/// The video pins, in every cycle in which elements leave.
class Monitor : public sc_core::sc_module {
 public:
  struct Group {
    Cycle cycle;
    std::uint32_t line, element, colour;
  };
  Monitor(sc_core::sc_module_name name, const Clock& clock, const Clocked& stage)
      : sc_module(name), clock_(clock), stage_(stage) {
    SC_HAS_PROCESS(Monitor);
    SC_METHOD(edge);
    dont_initialize();
    sensitive << clock_.wire.posedge_event();
  }
  std::vector<Group> groups;

 private:
  void edge() {
    if (stage_.video_on.read())
      groups.push_back({clock_.cycle(), stage_.video_line.read(), stage_.video_element.read(),
                        stage_.video_colour.read()});
  }
  const Clock& clock_;
  const Clocked& stage_;
};

class Bench {
 public:
  Bench(const Case& c, bool clocked, const Clock& clock)
      : faces("faces", c.depths[0], c.waits),
        loaded("loaded", c.depths[1], c.waits),
        start("start", c.depths[2], c.waits),
        spans("spans", c.depths[3], c.waits),
        shown("shown", c.depths[4], c.waits) {
    Outputs outputs;
    outputs.figures = [this](const Figures& frame) { figures.push_back(frame); };
    outputs.line = [this](std::uint32_t, std::uint32_t, Cycle cycle) { lines.push_back(cycle); };
    outputs.picture = [this](std::uint32_t frame, const Picture& picture, Cycle first, Cycle last) {
      pictures.push_back({frame, first, last, picture.colours, picture.numbers});
    };
    parts_.make<test::Feeder<SpanWord>>(spans.link, c.spans, c.waits);
    parts_.make<Sequencer>(c, banks_,
                           Sequencer::Links{faces.link, loaded.link, start.link, shown.link});
    if (clocked) {
      Clocked& stage = parts_.make<Clocked>(c.machine, clock, banks_, outputs);
      stage.clock(clock.wire);
      monitor = &parts_.make<Monitor>(clock, stage);
      parts_.connect(clock, faces.link, stage.faces);
      parts_.connect(clock, stage.loaded, loaded.link);
      parts_.connect(clock, start.link, stage.start);
      parts_.connect(clock, spans.link, stage.spans);
      parts_.connect(clock, stage.shown, shown.link);
    } else {
      parts_.make<Timed>(c.machine,
                         Timed::Links{faces.link, loaded.link, start.link, spans.link, shown.link},
                         banks_, outputs);
    }
  }
  test::RecordedLink<FaceWord> faces;
  test::RecordedLink<FrameWord> loaded, start;
  test::RecordedLink<SpanWord> spans;
  test::RecordedLink<FrameWord> shown;
  std::vector<Figures> figures;
  std::vector<Shown> pictures;
  std::vector<Cycle> lines;
  Monitor* monitor = nullptr;

 private:
  VideoBanks banks_;
  test::Parts parts_;
};

/// The pictures of the functional level.
void expect_functional_pictures(const Case& c, const Bench& bench) {
  ASSERT_EQ(bench.pictures.size(), c.frames);
  std::size_t next = 0;
  for (std::uint32_t k = 0; k < c.frames; ++k) {
    priority_resolver::SpanLines lines;
    lines.reset(c.machine.raster.height);
    for (int r = 0; r < c.machine.raster.height; ++r) do {
        lines.add(r, {c.spans[next].face, c.spans[next].first, c.spans[next].end});
      } while (!c.spans[next++].last);
    std::vector<RasterFace> faces;
    for (const FaceWord& word : c.faces[k]) {
      RasterFace face;
      face.object = word.object;
      face.colour = {static_cast<std::uint8_t>(word.colour),
                     static_cast<std::uint8_t>(word.colour >> 8),
                     static_cast<std::uint8_t>(word.colour >> 16)};
      faces.push_back(face);
    }
    Picture expected;
    Functional().compute(lines, faces, c.backgrounds[k], c.machine.raster, expected);
    ASSERT_EQ(bench.pictures[k].frame, k);
    ASSERT_EQ(bench.pictures[k].colours, expected.colours);
    ASSERT_EQ(bench.pictures[k].numbers, expected.numbers);
  }
}

/// The raster, counted cycle by cycle from when the spans were taken: which cycles show elements,
/// and that no span was taken into a buffer in use.
void expect_raster(const Case& c, const Bench& bench) {
  const int height = c.machine.raster.height;
  const Cycle length = c.line_length();
  std::size_t span = 0;
  for (std::uint32_t k = 0; k < c.frames; ++k) {
    const Cycle begin = bench.start.history[k].taken;
    std::vector<Cycle> first_taken, complete;
    for (int r = 0; r < height; ++r) {
      first_taken.push_back(bench.spans.history[span].taken);
      while (!bench.spans.history[span].word.last) ++span;
      complete.push_back(bench.spans.history[span++].taken);
    }
    ASSERT_GT(first_taken[0], begin);
    int line = 0;
    std::uint32_t late = 0;
    Cycle worst = 0, due = begin + c.machine.vertical_blanking(), busy_until = begin;
    if (due == begin) ++due;
    for (Cycle now = begin + 1; line < height; ++now) {
      if (now <= busy_until || now < due || now <= complete[static_cast<std::size_t>(line)])
        continue;
      const std::size_t l = static_cast<std::size_t>(line);
      ASSERT_EQ(bench.lines[k * static_cast<std::size_t>(height) + l], now);
      const Cycle lateness = now - due;
      const bool counts = c.machine.line_cycles > 0 && (line > 0 || c.machine.frame_cycles > 0);
      if (counts && lateness > 0) ++late;
      if (counts) worst = std::max(worst, lateness);
      busy_until = now + length - 1;
      if (l + 2 < first_taken.size()) {
        ASSERT_GT(first_taken[l + 2], busy_until);
      }
      if (line == 0) {
        ASSERT_EQ(bench.pictures[k].first, now);
      }
      due = now + std::max(c.machine.line_cycles, length);
      ++line;
    }
    ASSERT_EQ(bench.pictures[k].last, busy_until);
    ASSERT_EQ(bench.figures[k].late_lines, late);
    ASSERT_EQ(bench.figures[k].worst_lateness, worst);
    ASSERT_EQ(bench.figures[k].frame, k);
    ASSERT_EQ(bench.figures[k].activity.start, begin);
    ASSERT_EQ(bench.figures[k].activity.finish, bench.shown.history[k].pushed);
    ASSERT_GT(bench.shown.history[k].pushed, busy_until);
  }
}

/// The pins show each group of elements, in its cycle, with its first colour.
void expect_video(const Case& c, const Bench& bench) {
  const std::size_t width = static_cast<std::size_t>(c.machine.raster.width);
  const std::size_t height = static_cast<std::size_t>(c.machine.raster.height);
  std::size_t next = 0;
  for (std::size_t l = 0; l < bench.lines.size(); ++l) {
    const std::vector<std::uint32_t>& colours = bench.pictures[l / height].colours;
    for (Cycle i = 0; i < c.line_length(); ++i) {
      ASSERT_LT(next, bench.monitor->groups.size());
      const Monitor::Group& group = bench.monitor->groups[next++];
      const std::size_t element = static_cast<std::size_t>(i) * c.machine.elements_per_cycle;
      ASSERT_EQ(group.cycle, bench.lines[l] + i);
      ASSERT_EQ(group.line, l % height);
      ASSERT_EQ(group.element, element);
      ASSERT_EQ(group.colour, colours[l % height * width + element]);
    }
  }
  ASSERT_EQ(next, bench.monitor->groups.size());
}

TEST(VideoProcessor, TimedAndClockedGiveTheFunctionalPicturesInTheSameCycles) {
  constexpr unsigned kCases = 600;
  test::fresh_simulation();
  Clock clock("clock", 125);
  std::vector<std::unique_ptr<Case>> cases;
  std::vector<std::unique_ptr<Bench>> timed, clocked;
  for (unsigned seed = 0; seed < kCases; ++seed) {
    cases.push_back(std::make_unique<Case>(seed));
    timed.push_back(std::make_unique<Bench>(*cases.back(), false, clock));
    clocked.push_back(std::make_unique<Bench>(*cases.back(), true, clock));
  }
  test::run_timed_then_clocked(clock, [&] {
    Cycle last = 0;
    for (const auto& bench : timed) last = std::max(last, test::last_taken(bench->shown.history));
    return last;
  });

  for (unsigned seed = 0; seed < kCases; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Bench &a = *timed[seed], &b = *clocked[seed];
    expect_functional_pictures(*cases[seed], a);
    expect_raster(*cases[seed], a);
    ASSERT_EQ(b.faces.history, a.faces.history);
    ASSERT_EQ(b.loaded.history, a.loaded.history);
    ASSERT_EQ(b.start.history, a.start.history);
    ASSERT_EQ(b.spans.history, a.spans.history);
    ASSERT_EQ(b.shown.history, a.shown.history);
    ASSERT_EQ(b.lines, a.lines);
    ASSERT_TRUE(b.pictures == a.pictures);
    ASSERT_TRUE(b.figures == a.figures);
    expect_video(*cases[seed], b);
    if (HasFatalFailure()) return;
  }
}

// Worked by hand from VP1 to VP8: the faces' end word is taken in cycle 1 and its frame word in 3,
// so B = 5; blanking is 2 and the pitch 3 cycles.
TEST(VideoProcessor, SmallPictureTakesTheCyclesWorkedByHand) {
  Case c;
  c.machine.raster = {4, 2};
  c.machine.elements_per_cycle = 2;
  c.machine.line_cycles = 3;
  c.machine.frame_cycles = 8;
  c.frames = 1;
  c.faces = {{{0, true, 0, 0}}};
  c.backgrounds.resize(1);
  c.spans = {{kNone, 0, 4, true}, {kNone, 0, 4, true}};
  test::fresh_simulation();
  Clock clock("clock", 125);
  Bench timed(c, false, clock), clocked(c, true, clock);
  clock.start();
  sc_core::sc_start(100 * clock.period());
  for (const Bench* bench : {&timed, &clocked}) {
    EXPECT_EQ(bench->start.history.at(0).taken, 5);
    EXPECT_EQ(bench->spans.history.at(0).taken, 6);
    EXPECT_EQ(bench->spans.history.at(1).taken, 7);
    EXPECT_EQ(bench->lines, (std::vector<Cycle>{7, 10}));
    EXPECT_EQ(bench->pictures.at(0).first, 7);
    EXPECT_EQ(bench->pictures.at(0).last, 11);
    const Figures& figures = bench->figures.at(0);
    EXPECT_EQ(figures.activity, (Activity{5, 12, 0, 0}));
    EXPECT_EQ(figures.late_lines, 0u);
  }
}

}  // namespace
}  // namespace cigsim::video_processor
