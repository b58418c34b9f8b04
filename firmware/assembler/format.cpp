// SPDX-License-Identifier: MIT
#include "firmware/assembler/format.hpp"

#include <stdexcept>

#include "firmware/assembler/text.hpp"
#include "firmware/sequencer.hpp"
#include "models/environment/input_error.hpp"

namespace cigsim::firmware {
namespace {

class Reader {
 public:
  explicit Reader(const std::string& file) : file_(file) {}

  Format read(std::string_view text) {
    for_each_line(text, [&](int line, std::string_view row) {
      line_ = line;
      const auto words = words_of(row);
      if (!words.empty()) read_row(words);
    });
    line_ = 0;
    if (format_.name.empty()) fail("says no name; begin it with 'format NAME'");
    for (const char* needed : {"op", "cond"})
      if (!format_.find(needed))
        fail(std::string("has no field '") + needed + "'; write 'sequencer' and 'field cond BITS'");
    const Field& cond = format_.field("cond");
    const auto always = cond.values.find("TRUE");
    if (always == cond.values.end() || always->second != 0 || cond.fallback != 0)
      fail("field 'cond' needs the value 'TRUE 0' as its default: the condition that always holds");
    return std::move(format_);
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw InputError(file_, line_, message);
  }

  void read_row(const std::vector<std::string_view>& words) {
    const std::string_view first = words[0];
    if (first == "format" && words.size() == 2) {
      format_.name = words[1];
    } else if (first == "sequencer" && words.size() == 1) {
      add_sequencer();
    } else if (first == "field") {
      read_field(words);
    } else if (words.size() == 2 && !format_.fields.empty()) {
      add_value(std::string(first), number(words[1]));
    } else {
      fail(quoted(first) +
           " is not understood; write 'format NAME', 'sequencer', 'field NAME BITS [default "
           "VALUE]', or 'NAME NUMBER' for a value of the field above");
    }
  }

  void read_field(const std::vector<std::string_view>& words) {
    if (words.size() != 3 && !(words.size() == 5 && words[3] == "default"))
      fail("a field is written 'field NAME BITS [default VALUE]'");
    const std::int64_t bits = number(words[2]);
    if (bits < 1 || bits > 32) fail("a field has 1 to 32 bits; divide it");
    add_field(std::string(words[1]), static_cast<unsigned>(bits));
    if (words.size() == 5) format_.fields.back().fallback = fitting(number(words[4]));
  }

  void add_field(const std::string& name, unsigned bits) {
    if (!is_name(name)) fail(quoted(name) + " is no name; use letters, digits and _");
    if (format_.find(name)) fail("field '" + name + "' is there already; take another name");
    unsigned first = format_.width;
    if (first < 64 && first + bits > 64) first = 64;
    if (first + bits > kWordBits)
      fail("field '" + name + "' does not fit into 128 bits; make fields narrower");
    format_.fields.push_back({name, {first, bits}, {}, 0});
    format_.width = first + bits;
  }

  void add_value(const std::string& name, std::int64_t value) {
    if (!is_name(name)) fail(quoted(name) + " is no name; use letters, digits and _");
    Field& field = format_.fields.back();
    if (!field.values.emplace(name, fitting(value)).second)
      fail("field '" + field.name + "' has a value '" + name + "' already");
  }

  void add_sequencer() {
    constexpr const char* kOps[] = {"JZ",   "CJS",  "JMAP", "CJP",  "PUSH", "JSRP", "CJV",  "JRP",
                                    "RFCT", "RPCT", "CRTN", "CJPP", "LDCT", "LOOP", "CONT", "TWB"};
    add_field("op", 4);
    for (std::uint32_t code = 0; code < 16; ++code) add_value(kOps[code], code);
    format_.fields.back().fallback = static_cast<std::uint32_t>(SequencerOp::kCont);
    add_field("pol", 1);
    add_field("d", 1);
    add_value("WORD", 0);
    add_value("DATA", 1);
    add_field("address", kAddressBits);
  }

  std::int64_t number(std::string_view word) const {
    const auto value = to_whole(word);
    if (!value) fail(quoted(word) + " is no whole number from 0 on");
    return *value;
  }
  std::uint32_t fitting(std::int64_t value) const {
    const Field& field = format_.fields.back();
    if (static_cast<std::uint64_t>(value) > field.place.mask())
      fail(std::to_string(value) + " does not fit into the " + std::to_string(field.place.bits) +
           " bits of field '" + field.name + "'");
    return static_cast<std::uint32_t>(value);
  }

  const std::string& file_;
  int line_ = 0;
  Format format_;
};

}  // namespace

const Field* Format::find(std::string_view field) const {
  for (const Field& f : fields)
    if (f.name == field) return &f;
  return nullptr;
}

const Field& Format::field(std::string_view field) const {
  if (const Field* found = find(field)) return *found;
  throw std::invalid_argument("format '" + name + "' has no field '" + std::string(field) + "'");
}

std::uint32_t Format::value(std::string_view name_of_field, std::string_view value) const {
  const Field& f = field(name_of_field);
  const auto found = f.values.find(value);
  if (found != f.values.end()) return found->second;
  throw std::invalid_argument("field '" + f.name + "' of format '" + name + "' has no value '" +
                              std::string(value) + "'");
}

Format parse_format(const std::string& file, std::string_view text) {
  return Reader(file).read(text);
}

}  // namespace cigsim::firmware
