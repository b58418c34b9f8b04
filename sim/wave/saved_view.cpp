// SPDX-License-Identifier: MIT
#include "sim/wave/saved_view.hpp"

#include <fmt/format.h>

#include <charconv>

#include "models/environment/input_error.hpp"

namespace cigsim {
namespace {

// Bits of the flags after @ that matter here.
enum Flags : std::uint64_t {
  kHexadecimal = 0x2,
  kDecimal = 0x4,
  kBinary = 0x8,
  kOctal = 0x10,
  kBlank = 0x200,  // a heading or an empty row
  kSigned = 0x400,
  kText = 0x800,
  kNamed = 0x2000,  // values have names from a file
  kGroupEnd = 0x1000000
};

Radix radix_of(std::uint64_t flags) {
  if (flags & kSigned) return Radix::kSigned;
  if (flags & kBinary) return Radix::kBinary;
  if (flags & kOctal) return Radix::kOctal;
  if (flags & kDecimal) return Radix::kDecimal;
  if (flags & kText) return Radix::kText;
  return Radix::kHexadecimal;
}

class ViewReader {
 public:
  explicit ViewReader(const std::string& name) : name_(name) {}

  std::vector<ViewRow> read(std::string_view text) {
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      std::string_view line = text.substr(0, end);
      if (line.ends_with('\r')) line.remove_suffix(1);
      ++line_;
      if (!line.empty()) take(line);
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    for (const ViewRow& row : rows_)
      if (row.kind == ViewRow::Kind::kSignal) return std::move(rows_);
    line_ = 0;
    fail("names no signals; save a view with signals in it");
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw InputError(name_, line_, what); }

  void take(std::string_view line) {
    switch (line.front()) {
      case '[':  // the window's state
      case '*':  // zoom and markers
      case '>':  // shifts of time
        return;
      case '^':
        return take_filter(line.substr(1));
      case '@':
        return take_flags(line.substr(1));
      case '-':
        return take_heading(line.substr(1));
      case '+':
        return take_alias(line);
      case '#':
        fail("puts bits together to a signal; name whole signals");
      default:
        if (line.find(' ') != std::string_view::npos)
          fail(fmt::format("'{}' is not the name of a signal", line.substr(0, 60)));
        add_signal(line, "");
    }
  }

  void take_flags(std::string_view text) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), flags_, 16);
    if (error != std::errc{} || end != text.data() + text.size())
      fail(fmt::format("'@{}' has no hexadecimal flags", text));
  }

  void take_heading(std::string_view text) {
    if (flags_ & kGroupEnd) return;
    while (text.starts_with(' ')) text.remove_prefix(1);
    add({text.empty() ? ViewRow::Kind::kBlank : ViewRow::Kind::kHeading, std::string(text), "",
         Radix::kHexadecimal, line_});
  }

  // ^number file; 0 for none. A filter that is a program has ^> or ^<.
  void take_filter(std::string_view text) {
    if (text.starts_with('>') || text.starts_with('<')) return;
    const std::size_t blank = text.find(' ');
    names_ = text.starts_with('0') || blank == std::string_view::npos ? "" : text.substr(blank + 1);
  }

  // +{label} name
  void take_alias(std::string_view line) {
    const std::size_t close = line.find("} ");
    if (!line.starts_with("+{") || close == std::string_view::npos || close + 2 == line.size())
      fail(fmt::format("'{}' must be +{{label}} and the name of a signal", line.substr(0, 60)));
    add_signal(line.substr(close + 2), line.substr(2, close - 2));
  }

  void add_signal(std::string_view name, std::string_view label) {
    add({ViewRow::Kind::kSignal, std::string(name), std::string(label), radix_of(flags_), line_,
         flags_ & kNamed ? names_ : ""});
  }
  void add(ViewRow row) { rows_.push_back(std::move(row)); }

  const std::string& name_;
  int line_ = 0;
  std::uint64_t flags_ = 0;
  std::string names_;
  std::vector<ViewRow> rows_;
};

}  // namespace

std::vector<ViewRow> parse_saved_view(std::string_view text, const std::string& name) {
  return ViewReader(name).read(text);
}

}  // namespace cigsim
