// SPDX-License-Identifier: MIT
// The checkers that hold two levels against each other: they must be silent where nothing differs,
// and tell the first difference where something does.
#include <gtest/gtest.h>

#include <deque>
#include <optional>

#include "models/boundary/link_check.hpp"
#include "models/boundary/pin_check.hpp"
#include "models/boundary/stuck_bit.hpp"
#include "tests/support/fresh_simulation.hpp"

namespace cigsim::test {
namespace {

// Offers `words` one after the other, each until it is taken.
class Offerer : public sc_core::sc_module {
 public:
  Offerer(sc_core::sc_module_name name, const Clock& clock, std::deque<SpanWord> words)
      : sc_module(name), words_(std::move(words)) {
    SC_HAS_PROCESS(Offerer);
    SC_METHOD(edge);
    dont_initialize();
    sensitive << clock.wire.posedge_event();
  }
  PinOut<SpanWord> out;

 private:
  void edge() {
    if (out.valid.read() && out.ready.read()) words_.pop_front();
    out.valid.write(!words_.empty());
    if (!words_.empty()) out.word.write(words_.front());
  }
  std::deque<SpanWord> words_;
};

const std::deque<SpanWord> kSpans{{1, 0, 4, false}, {2, 4, 9, true}, {3, 0, 9, true}};

class Checks : public testing::Test {
 protected:
  Checks() { fresh_simulation(); }

  // Two offerers on one ready pin, one of which offers `words`.
  std::optional<Mismatch> pins(const std::deque<SpanWord>& words, unsigned lines,
                               const std::optional<StuckBit>& stuck = {}) {
    std::optional<Mismatch> found;
    Clock clock("clock", 10);
    Offerer a("a", clock, kSpans), b("b", clock, words);
    Wires<SpanWord> expected, sound, got;
    sc_core::sc_signal<bool> unused;
    expected.connect(a.out);
    Wires<SpanWord>& from = stuck ? sound : got;
    b.out.valid(from.valid);
    b.out.word(from.word);
    b.out.ready(got.ready);
    std::unique_ptr<StuckPins<SpanWord>> fault;
    if (stuck) fault = std::make_unique<StuckPins<SpanWord>>("fault", *stuck, sound, got);
    expected.ready.write(true);
    got.ready.write(true);
    PinCheck check("check", clock, "resolver", lines, [&](const Mismatch& m) { found = m; });
    check.output("spans", got, expected);
    clock.start();
    sc_core::sc_start(100, sc_core::SC_NS);
    ended_ = check.ended();
    return found;
  }

  std::uint64_t ended_ = 0;
};

TEST_F(Checks, EqualPinsAreNoMismatch) {
  EXPECT_FALSE(pins(kSpans, 2));
  EXPECT_EQ(ended_, 2u);
}

TEST_F(Checks, TheFirstWordThatDiffersIsToldByFieldCycleFrameAndLine) {
  std::deque<SpanWord> words = kSpans;
  words[2].first = 1;
  const auto found = pins(words, 1);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->field, "spans_word.first");
  EXPECT_EQ(found->cycle, 3) << "offered from cycle 1 on, one a cycle";
  EXPECT_EQ(found->frame, 1u) << "a line a frame, and one is over";
  EXPECT_EQ(found->expected, "0");
  EXPECT_EQ(found->got, "1");
}

TEST_F(Checks, LinesAreCountedWithinFrames) {
  std::deque<SpanWord> words = kSpans;
  words[2].end = 8;
  const auto found = pins(words, 2);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->frame, 0u);
  EXPECT_EQ(found->line, 1u);
}

TEST_F(Checks, AMissingWordShowsOnTheValidPin) {
  std::deque<SpanWord> words = kSpans;
  words.pop_back();
  const auto found = pins(words, 2);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->field, "spans_valid");
  EXPECT_EQ(found->cycle, 3);
}

TEST_F(Checks, AStuckBitDiffersInTheFirstCycleInWhichItMatters) {
  // Bit 2 of `end` is set in 4, not in 9.
  const auto found = pins(kSpans, 2, StuckBit{"spans", "end", 2, true});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->field, "spans_word.end");
  EXPECT_EQ(found->cycle, 2);
  EXPECT_EQ(found->expected, "9");
  EXPECT_EQ(found->got, "13");
}
TEST_F(Checks, AStuckValidPinOffersWhatIsNotThere) {
  const auto found = pins(kSpans, 2, StuckBit{"spans", "valid", 0, true});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->field, "spans_valid");
  EXPECT_EQ(found->cycle, 0);
}

// Words through a link, each pushed and taken as early as it can be but for `wait` at word 1.
void run_link(Link<SpanWord>& link, const std::deque<SpanWord>& words, Cycle wait) {
  Cycle at = 0;
  for (std::size_t i = 0; i < words.size(); ++i) {
    at = std::max(at + 1, link.room_now()) + (i == 1 ? wait : 0);
    link.push(words[i], at);
    link.take(link.available_now());
  }
}

std::optional<Mismatch> links(const std::deque<SpanWord>& words, Cycle wait,
                              std::uint64_t* compared = nullptr) {
  std::optional<Mismatch> found;
  Link<SpanWord> a("spans", 4), b("spans", 4);
  LinkCheck<SpanWord> check(a, b, "resolver", 2, [&](const Mismatch& m) { found = m; });
  run_link(a, kSpans, 0);
  run_link(b, words, wait);
  check.finish();
  if (compared != nullptr) *compared = check.words();
  return found;
}

TEST_F(Checks, EqualLinksAreNoMismatch) {
  std::uint64_t words = 0;
  EXPECT_FALSE(links(kSpans, 0, &words));
  EXPECT_EQ(words, 3u);
}

TEST_F(Checks, AWordThatIsLateIsAMismatchOfCycles) {
  const auto found = links(kSpans, 5);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->field, "spans, word 2: cycle of push");
}

TEST_F(Checks, AnotherValueIsAMismatchOfTheWord) {
  std::deque<SpanWord> words = kSpans;
  words[1].face = 9;
  const auto found = links(words, 0);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->field, "spans, word 2: word");
  EXPECT_EQ(found->got, "face 9 elements 4..9 last");
  EXPECT_EQ(found->line, 0u);
}

TEST_F(Checks, AWordTooFewIsFoundAtTheEnd) {
  std::deque<SpanWord> words = kSpans;
  words.pop_back();
  const auto found = links(words, 0);
  ASSERT_TRUE(found);
  EXPECT_NE(found->field.find("number of words"), std::string::npos);
}

}  // namespace
}  // namespace cigsim::test
