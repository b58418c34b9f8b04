// SPDX-License-Identifier: MIT
#include "sim/path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "models/environment/input_error.hpp"
#include "models/environment/text_file.hpp"
#include "sim/arguments.hpp"

namespace cigsim {
namespace {

constexpr std::array<std::string_view, 7> kColumns{"x",     "y",    "z",  "heading",
                                                   "pitch", "roll", "fov"};
constexpr std::size_t kRequired = 6, kFov = 6;
constexpr std::size_t kAbsent = static_cast<std::size_t>(-1);

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t comma; (comma = line.find(',')) != std::string_view::npos;) {
    fields.push_back(trimmed(line.substr(0, comma)));
    line.remove_prefix(comma + 1);
  }
  fields.push_back(trimmed(line));
  return fields;
}

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

class PathReader {
 public:
  explicit PathReader(const std::string& name) : name_(name) { place_.fill(kAbsent); }

  std::vector<PathRow> read(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      ++line_;
      take(trimmed(text.substr(0, end)));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    if (width_ == 0)
      fail("is empty; the first line must name the columns x,y,z,heading,pitch,roll");
    if (rows_.empty()) fail("has no rows after the column names; give one row a frame");
    return std::move(rows_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw InputError(name_, line_, what); }

  void take(std::string_view line) {
    if (line.empty() || line.starts_with('#')) return;
    if (width_ == 0)
      take_names(line);
    else
      take_row(line);
  }

  void take_names(std::string_view line) {
    const std::vector<std::string_view> names = fields_of(line);
    width_ = names.size();
    for (std::size_t i = 0; i < names.size(); ++i) {
      const auto found = std::find(kColumns.begin(), kColumns.end(), lower(names[i]));
      if (found == kColumns.end()) continue;
      std::size_t& place = place_[static_cast<std::size_t>(found - kColumns.begin())];
      if (place != kAbsent) fail(fmt::format("column '{}' is named twice", *found));
      place = i;
    }
    for (std::size_t c = 0; c < kRequired; ++c)
      if (place_[c] == kAbsent)
        fail(fmt::format("there is no column '{}'; name the columns x,y,z,heading,pitch,roll",
                         kColumns[c]));
  }

  void take_row(std::string_view line) {
    const std::vector<std::string_view> fields = fields_of(line);
    if (fields.size() != width_)
      fail(fmt::format("has {} fields, but {} columns are named", fields.size(), width_));
    std::array<double, kColumns.size()> value{};
    for (std::size_t c = 0; c < kColumns.size(); ++c)
      if (place_[c] != kAbsent && !to_number(fields[place_[c]], value[c]))
        fail(fmt::format("{}: '{}' is not a finite number", kColumns[c], fields[place_[c]]));
    PathRow row{{{value[0], value[1], value[2]}, value[3], value[4], value[5]}, {}};
    if (place_[kFov] != kAbsent) {
      row.fov = value[kFov];
      if (!(*row.fov > 0 && *row.fov < 180)) fail("fov: must lie between 0 and 180 degrees");
    }
    rows_.push_back(row);
  }

  const std::string& name_;
  int line_ = 0;
  std::size_t width_ = 0;  // columns named; 0: not yet
  std::array<std::size_t, kColumns.size()> place_{};
  std::vector<PathRow> rows_;
};

double between(double a, double b, double t) { return a + (b - a) * t; }

double between_angles(double a, double b, double t) { return a + std::remainder(b - a, 360) * t; }

}  // namespace

std::vector<PathRow> parse_path(std::string_view text, const std::string& name) {
  return PathReader(name).read(text);
}

std::vector<PathRow> read_path(const std::filesystem::path& file) {
  return parse_path(read_whole_file(file), file.string());
}

PathRow at_position(const std::vector<PathRow>& rows, double position) {
  const double last = static_cast<double>(rows.size() - 1);
  if (!(position > 0)) return rows.front();
  if (position >= last) return rows.back();
  const auto i = static_cast<std::size_t>(position);
  const double t = position - static_cast<double>(i);
  if (t == 0) return rows[i];
  const Placement &a = rows[i].eye, &b = rows[i + 1].eye;
  PathRow row{{{between(a.position.x, b.position.x, t), between(a.position.y, b.position.y, t),
                between(a.position.z, b.position.z, t)},
               between_angles(a.heading, b.heading, t),
               between_angles(a.pitch, b.pitch, t),
               between_angles(a.roll, b.roll, t)},
              {}};
  if (rows[i].fov && rows[i + 1].fov) row.fov = between(*rows[i].fov, *rows[i + 1].fov, t);
  return row;
}

std::vector<double> even_positions(std::size_t rows, std::size_t count) {
  std::vector<double> positions(count);
  if (count < 2) return positions;
  const double last = static_cast<double>(rows - 1), steps = static_cast<double>(count - 1);
  for (std::size_t i = 0; i < count; ++i) positions[i] = static_cast<double>(i) * last / steps;
  return positions;
}

}  // namespace cigsim
