// SPDX-License-Identifier: MIT
// Two passes: the first gives every label its address, the second makes the words; then the costs.
#include <stdexcept>

#include "firmware/assembler/costs.hpp"
#include "firmware/assembler/expression.hpp"
#include "firmware/assembler/program.hpp"
#include "firmware/assembler/text.hpp"
#include "firmware/sequencer.hpp"
#include "models/environment/input_error.hpp"

namespace cigsim::firmware {
namespace {

using Words = std::vector<std::string_view>;

class Assembler {
 public:
  Assembler(const Format& format, const std::string& file, const Overrides& overrides)
      : file_(file), overrides_(overrides) {
    program_.name = file;
    program_.format = format;
    for (const Field& field : format.fields) field.place.set(defaults_, field.fallback);
    used_.resize(format.fields.size());
  }

  Program assemble(std::string_view text) {
    for_each_line(text, [&](int line, std::string_view row) {
      line_ = line;
      read_row(row);
    });
    for (const auto& [name, value] : overrides_)
      if (!program_.constants.contains(name))
        fail("has no '.define " + name + "' to give another value to; define it there");
    for (const Instruction& instruction : instructions_) make_word(instruction);
    for (const Words& cost : costs_) add_cost(cost);
    return std::move(program_);
  }

 private:
  struct Instruction {
    int line = 0;
    Words settings;
  };

  [[noreturn]] void fail(const std::string& message) const {
    throw InputError(file_, line_, message);
  }

  // First pass.

  void read_row(std::string_view row) {
    Words words = words_of(row);
    std::size_t first = 0;
    for (; first < words.size() && words[first].ends_with(':'); ++first)
      add_label(words[first].substr(0, words[first].size() - 1));
    words.erase(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(first));
    if (words.empty()) return;
    if (words[0] == ".define") {
      define(words);
    } else if (words[0] == ".cost") {
      costs_.push_back(words);
      cost_lines_.push_back(line_);
    } else if (words[0].starts_with('.')) {
      fail(quoted(words[0]) + " is no directive; there are .define and .cost");
    } else {
      if (instructions_.size() > kAddressMask)
        fail("the program is longer than the control store of 4,096 words; shorten it");
      instructions_.push_back({line_, std::move(words)});
      program_.sources.push_back(
          {line_, std::string(row.substr(0, row.find_last_not_of("\r") + 1))});
    }
  }

  void add_label(std::string_view label) {
    check_new(label);
    program_.labels.emplace(label, static_cast<std::uint32_t>(instructions_.size()));
  }

  void define(const Words& words) {
    if (words.size() != 3) fail("a constant is written '.define NAME EXPRESSION'");
    check_new(words[1]);
    const std::int64_t value = number(words[2], [&](std::string_view name) {
      const auto found = program_.constants.find(name);
      if (found == program_.constants.end())
        fail(quoted(name) + " is not defined above; constants use earlier ones only");
      return found->second;
    });
    const auto other = overrides_.find(words[1]);
    program_.constants.emplace(words[1], other == overrides_.end() ? value : other->second);
  }

  void check_new(std::string_view name) const {
    if (!is_name(name)) fail(quoted(name) + " is no name; use letters, digits and _");
    if (program_.labels.contains(name) || program_.constants.contains(name))
      fail(quoted(name) + " is defined twice; take another name");
  }

  // Second pass.

  void make_word(const Instruction& instruction) {
    line_ = instruction.line;
    word_ = defaults_;
    used_.assign(used_.size(), false);
    const Words& words = instruction.settings;
    for (std::size_t i = 0; i < words.size(); ++i) {
      const std::string_view word = words[i];
      const std::size_t equals = word.find('=');
      if (equals != std::string_view::npos) {
        set(word.substr(0, equals), word.substr(equals + 1));
      } else if (word == "if" || word == "unless") {
        if (++i == words.size()) fail("a condition is missing after '" + std::string(word) + "'");
        set("cond", words[i]);
        set("pol", word == "if" ? "0" : "1");
      } else if (program_.format.field("op").values.contains(word)) {
        set("op", word);
        if (i + 1 < words.size() && is_address(words[i + 1])) set("address", words[++i]);
      } else if (word != "nop") {
        fail(quoted(word) +
             " is not understood; write FIELD=VALUE, an instruction of the sequencer, or nop");
      }
    }
    program_.words.push_back(word_);
  }

  static bool is_address(std::string_view word) {
    return word.find('=') == std::string_view::npos && word != "if" && word != "unless";
  }

  void set(std::string_view name, std::string_view text) {
    const Field* field = program_.format.find(name);
    if (!field)
      fail("there is no field '" + std::string(name) + "'; the format '" + program_.format.name +
           "' declares them");
    const auto index = static_cast<std::size_t>(field - program_.format.fields.data());
    if (used_[index]) fail("field '" + field->name + "' is set twice; give each field one value");
    used_[index] = true;
    field->place.set(word_, value(*field, text));
  }

  std::uint32_t value(const Field& field, std::string_view text) const {
    const auto named = field.values.find(text);
    if (named != field.values.end()) return named->second;
    const std::int64_t result =
        number(text, [&](std::string_view name) { return symbol(field, name); });
    const auto limit = static_cast<std::int64_t>(field.place.mask());
    if (result > limit || result < -(limit / 2) - 1)
      fail(quoted(text) + " is " + std::to_string(result) + ", which does not fit into the " +
           std::to_string(field.place.bits) + " bits of field '" + field.name + "'");
    return static_cast<std::uint32_t>(result);
  }

  std::int64_t symbol(const Field& field, std::string_view name) const {
    if (name == ".") return static_cast<std::int64_t>(program_.words.size());
    const auto constant = program_.constants.find(name);
    if (constant != program_.constants.end()) return constant->second;
    const auto label = program_.labels.find(name);
    if (label != program_.labels.end()) return label->second;
    fail(quoted(name) + " is no value of field '" + field.name + "', constant or label; define it");
  }

  std::int64_t number(std::string_view text, const Lookup& lookup) const {
    try {
      return evaluate(text, lookup);
    } catch (const std::invalid_argument& error) {
      fail(std::string(error.what()) + "; write a number or a name");
    }
  }

  void add_cost(const Words& words) {
    line_ = cost_lines_[program_.costs.size()];
    if (words.size() < 4)
      fail("a cost is written '.cost NAME FROM TO [pass LABEL...] [fail LABEL...]'");
    const std::string name(words[1]);
    Path path{address_of(words[2]), address_of(words[3]), {}};
    const std::string_view* way = nullptr;
    for (std::size_t i = 4; i < words.size(); ++i) {
      if (words[i] == "pass" || words[i] == "fail")
        way = &words[i];
      else if (way)
        path.outcomes[address_of(words[i])] = *way == "pass";
      else
        fail("'pass' or 'fail' is missing before '" + std::string(words[i]) + "'");
    }
    Cycle cycles = 0;
    try {
      cycles = count_path(program_, path);
    } catch (const std::invalid_argument& error) {
      fail("the path '" + name + "' " + error.what());
    }
    if (!program_.costs.emplace(name, cycles).second)
      fail("cost '" + name + "' is there already; take another name");
  }

  std::uint32_t address_of(std::string_view label) const {
    const auto found = program_.labels.find(label);
    if (found == program_.labels.end())
      fail("there is no label '" + std::string(label) + "'; put it before an instruction");
    return found->second;
  }

  const std::string& file_;
  const Overrides& overrides_;
  int line_ = 0;
  Program program_;
  Microword defaults_, word_;
  std::vector<bool> used_;  ///< fields that the instruction has set
  std::vector<Instruction> instructions_;
  std::vector<Words> costs_;
  std::vector<int> cost_lines_;
};

}  // namespace

Program assemble(const Format& format, const std::string& source_file, std::string_view text,
                 const Overrides& overrides) {
  return Assembler(format, source_file, overrides).assemble(text);
}

Cycle Program::cost(std::string_view path) const {
  const auto found = costs.find(path);
  if (found != costs.end()) return found->second;
  throw std::invalid_argument("microprogram '" + name + "' names no cost '" + std::string(path) +
                              "'");
}

std::uint32_t Program::address(std::string_view label) const {
  const auto found = labels.find(label);
  if (found != labels.end()) return found->second;
  throw std::invalid_argument("microprogram '" + name + "' has no label '" + std::string(label) +
                              "'");
}

}  // namespace cigsim::firmware
