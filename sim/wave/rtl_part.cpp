// SPDX-License-Identifier: MIT
#include "sim/wave/rtl_part.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace cigsim {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

// The next word between blanks, taken from `text`; empty at its end.
std::string_view next(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(kBlanks));
  text.remove_prefix(word.size());
  return word;
}

// The words up to $end, which is taken too.
std::vector<std::string_view> words_to_end(std::string_view& text) {
  std::vector<std::string_view> words;
  for (std::string_view word = next(text); !word.empty() && word != "$end"; word = next(text))
    words.push_back(word);
  return words;
}

}  // namespace

RtlPart::RtlPart(std::string scope, std::string prefix, std::unique_ptr<WavePart> part)
    : scope_(std::move(scope)),
      prefix_(std::move(prefix)),
      part_(std::move(part)),
      text_(std::make_shared<std::string>()) {}

void RtlPart::fail(std::string_view what) const {
  throw std::runtime_error(fmt::format("waves of {}: {}", scope_, what));
}

std::vector<RtlPart::Variable> RtlPart::declare(const std::string& clock) {
  part_->open([text = text_](std::string_view piece) { text->append(piece); });
  constexpr std::size_t kOuterScopes = 2;  // of the model, and of the module
  std::vector<Variable> variables;
  std::vector<std::string_view> scopes;
  std::string_view text = *text_;
  while (true) {
    const std::string_view command = next(text);
    if (command.empty()) fail("the declarations have no end");
    const std::vector<std::string_view> words = words_to_end(text);
    if (command == "$enddefinitions") break;
    if (command == "$scope") {
      if (words.size() < 2) fail("a scope has no name");
      scopes.push_back(words[1]);
    } else if (command == "$upscope") {
      if (scopes.empty()) fail("no scope is open");
      scopes.pop_back();
    } else if (command == "$var") {
      if (words.size() < 4) fail("a signal has no name");
      if (scopes.size() < kOuterScopes) continue;
      Variable variable{scope_, std::string(words[0]), std::string(words[1]), "",
                        prefix_ + std::string(words[2])};
      for (std::size_t i = kOuterScopes; i < scopes.size(); ++i)
        variable.name.append(".").append(scopes[i]);
      variable.name.append(".").append(words[3]);
      for (std::size_t i = 4; i < words.size(); ++i) variable.range += words[i];
      if (scopes.size() == kOuterScopes && words[3] == "clk_i") clock_ = words[2];
      variables.push_back(std::move(variable));
    }
  }
  text_->clear();
  for (Variable& variable : variables)
    if (variable.code == prefix_ + clock_) variable.code = clock;
  return variables;
}

void RtlPart::sample(Cycle n, std::ostream& out) {
  text_->clear();
  part_->sample(n);
  std::string_view text = *text_;
  for (std::string_view word = next(text); !word.empty(); word = next(text)) {
    switch (word.front()) {
      case '#':  // the time is ours
        break;
      case '$':  // $dumpvars and the like enclose values, until $end
        if (word == "$comment") words_to_end(text);
        break;
      case 'b':
      case 'B':
      case 'r':
      case 'R':
      case 's':
      case 'S': {
        const std::string_view code = next(text);
        if (code.empty()) fail(fmt::format("the value {} has no code", word));
        out << word << ' ' << prefix_ << code << '\n';
        break;
      }
      default:
        if (std::string_view("01xXzZ").find(word.front()) == std::string_view::npos ||
            word.size() < 2)
          fail(fmt::format("{} is no value", word));
        if (word.substr(1) != clock_) out << word.front() << prefix_ << word.substr(1) << '\n';
    }
  }
}

void RtlPart::close() {
  part_->close();
  text_->clear();
}

}  // namespace cigsim
