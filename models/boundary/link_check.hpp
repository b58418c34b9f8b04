// SPDX-License-Identifier: MIT
// The same link of two pipelines: word by word the same values, in the same cycles. One checker a
// link; either pipeline may be ahead.
#pragma once

#include <cstdint>
#include <deque>
#include <sstream>
#include <string>
#include <utility>

#include "models/boundary/link.hpp"
#include "models/boundary/mismatch.hpp"
#include "models/boundary/trace_words.hpp"

namespace cigsim {

class LinkCheckBase {
 public:
  virtual ~LinkCheckBase() = default;
  /// Words compared.
  virtual std::uint64_t words() const = 0;
  /// Words of one pipeline that the other one has not had; to be called at the end.
  virtual void finish() = 0;
};

template <class T>
class LinkCheck : public LinkCheckBase {
 public:
  /// `stage` is the link's producer; `lines` of its ends make a frame.
  LinkCheck(Link<T>& expected, Link<T>& got, std::string stage, std::uint32_t lines,
            MismatchFunction report)
      : name_(got.name()), stage_(std::move(stage)), lines_(lines), report_(std::move(report)) {
    expected.set_probe([this](const T& word, Cycle pushed, Cycle taken) {
      add({word, pushed, taken}, got_, expected_, true);
    });
    got.set_probe([this](const T& word, Cycle pushed, Cycle taken) {
      add({word, pushed, taken}, expected_, got_, false);
    });
  }

  std::uint64_t words() const override { return words_; }
  void finish() override {
    if (!expected_.empty()) fail("number of words", expected_.front(), "more", "none");
    if (!got_.empty()) fail("number of words", got_.front(), "none", "more");
  }

 private:
  struct Event {
    T word;
    Cycle pushed, taken;
  };

  void add(const Event& event, std::deque<Event>& other, std::deque<Event>& own, bool expected) {
    if (failed_) return;
    if (other.empty()) return own.push_back(event);
    const Event before = other.front();
    other.pop_front();
    if (expected)
      compare(event, before);
    else
      compare(before, event);
  }

  void compare(const Event& expected, const Event& got) {
    ++words_;
    if (!(expected.word == got.word))
      fail("word", got, text(expected.word), text(got.word));
    else if (expected.pushed != got.pushed)
      fail("cycle of push", got, std::to_string(expected.pushed), std::to_string(got.pushed));
    else if (expected.taken != got.taken)
      fail("cycle of take", got, std::to_string(expected.taken), std::to_string(got.taken));
    else if (ends_stream(got.word))
      ++ended_;
  }

  static std::string text(const T& word) {
    std::ostringstream out;
    out << word;
    return out.str();
  }

  void fail(const std::string& what, const Event& at, const std::string& expected,
            const std::string& got) {
    if (std::exchange(failed_, true)) return;
    Mismatch mismatch{stage_,    name_ + ", word " + std::to_string(words_) + ": " + what,
                      at.pushed, static_cast<std::uint32_t>(ended_ / lines_),
                      {},        expected,
                      got,       {}};
    if (lines_ > 1) mismatch.line = static_cast<std::uint32_t>(ended_ % lines_);
    report_(mismatch);
  }

  std::string name_, stage_;
  std::uint32_t lines_;
  MismatchFunction report_;
  std::deque<Event> expected_, got_;
  std::uint64_t words_ = 0, ended_ = 0;
  bool failed_ = false;
};

}  // namespace cigsim
