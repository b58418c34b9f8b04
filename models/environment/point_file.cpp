// SPDX-License-Identifier: MIT
#include "models/environment/point_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "models/environment/input_error.hpp"
#include "models/environment/text_file.hpp"

namespace cigsim {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

bool names_columns(std::string_view line) {
  std::string plain;
  for (const char c : line)
    if (!is_blank(c)) plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return plain == "x,y,z" || plain == "\"x\",\"y\",\"z\"";
}

class PointReader {
 public:
  PointReader(std::string name, bool commas) : name_(std::move(name)), commas_(commas) {}

  std::vector<Vec3> read(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      ++line_;
      take(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    if (points_.empty())
      throw InputError(name_, 0, "has no points; write one a line, as " + form());
    return std::move(points_);
  }

 private:
  std::string form() const { return commas_ ? "x,y,z" : "x y z"; }
  [[noreturn]] void fail(const std::string& what) const { throw InputError(name_, line_, what); }

  void take(std::string_view line) {
    line = trimmed(line.substr(0, line.find('#')));
    if (line.empty()) return;
    if (commas_ && points_.empty() && !named_ && names_columns(line)) {
      named_ = true;
      return;
    }
    const std::vector<std::string_view> fields = fields_of(line);
    if (fields.size() != 3)
      fail("has " + std::to_string(fields.size()) + (fields.size() == 1 ? " number" : " numbers") +
           "; write one point a line, as " + form());
    points_.push_back({number(fields[0]), number(fields[1]), number(fields[2])});
  }

  std::vector<std::string_view> fields_of(std::string_view line) const {
    std::vector<std::string_view> fields;
    const auto separates = [&](char c) { return commas_ ? c == ',' : is_blank(c); };
    for (;;) {
      const auto length = static_cast<std::size_t>(
          std::find_if(line.begin(), line.end(), separates) - line.begin());
      fields.push_back(trimmed(line.substr(0, length)));
      if (length == line.size()) return fields;
      line.remove_prefix(length + 1);
      if (!commas_) line = trimmed(line);
    }
  }

  double number(std::string_view field) {
    const std::string_view digits =
        field.starts_with('+') && !field.starts_with("+-") ? field.substr(1) : field;
    double value = 0;
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error == std::errc::result_out_of_range)
      fail(quoted(field) + " is beyond the range of doubles; scale the points");
    if (error != std::errc() || stop != digits.data() + digits.size() || !std::isfinite(value))
      fail(quoted(field) + " is no finite decimal number; write a point as " + form());
    return value;
  }

  static std::string quoted(std::string_view text) {
    std::string out = "'";
    out.append(text.substr(0, 40));
    return out + (text.size() > 40 ? "...'" : "'");
  }

  std::string name_;
  bool commas_, named_ = false;
  int line_ = 0;
  std::vector<Vec3> points_;
};

}  // namespace

bool is_point_file(const std::filesystem::path& file) {
  const std::string ending = lower_ending(file);
  return ending == "xyz" || ending == "csv";
}

std::vector<Vec3> read_points(const std::filesystem::path& file) {
  return PointReader(file.string(), lower_ending(file) == "csv").read(read_whole_file(file));
}

}  // namespace cigsim
