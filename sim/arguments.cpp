// SPDX-License-Identifier: MIT
#include "sim/arguments.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "models/environment/text_file.hpp"

namespace cigsim {
namespace {

constexpr std::uint64_t kLargestRaster = 16384;

}  // namespace

bool to_number(std::string_view text, double& value) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() && std::isfinite(value);
}

double parse_number(std::string_view what, std::string_view text) {
  double value = 0;
  if (!to_number(text, value))
    throw UsageError(fmt::format("{}: '{}' is not a finite number", what, text));
  return value;
}

double parse_number(std::string_view what, std::string_view text, double low, double high) {
  const double value = parse_number(what, text);
  if (!(value >= low && value <= high))
    throw UsageError(fmt::format("{}: {} must lie from {} to {}", what, value, low, high));
  return value;
}

std::uint64_t parse_whole(std::string_view what, std::string_view text, std::uint64_t low,
                          std::uint64_t high) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value < low || value > high)
    throw UsageError(
        fmt::format("{}: '{}' is not a whole number from {} to {}", what, text, low, high));
  return value;
}

std::vector<double> parse_list(std::string_view what, std::string_view text,
                               std::string_view form) {
  std::vector<double> values;
  std::string_view rest = text;
  for (bool more = true; more;) {
    const std::size_t comma = rest.find(',');
    more = comma != std::string_view::npos;
    double value = 0;
    if (!to_number(rest.substr(0, comma), value)) values.clear(), more = false;
    values.push_back(value);
    if (more) rest.remove_prefix(comma + 1);
  }
  const auto wanted = static_cast<std::size_t>(1 + std::count(form.begin(), form.end(), ','));
  if (values.size() != wanted)
    throw UsageError(fmt::format("{}: '{}' must be {}, {} finite numbers with commas and no blanks",
                                 what, text, form, wanted));
  return values;
}

Vec3 parse_vector(std::string_view what, std::string_view text) {
  const std::vector<double> v = parse_list(what, text, "X,Y,Z");
  return {v[0], v[1], v[2]};
}

double parse_fov(std::string_view what, std::string_view text) {
  const double fov = parse_number(what, text);
  if (!(fov > 0 && fov < 180))
    throw UsageError(fmt::format("{}: {} must lie between 0 and 180 degrees", what, text));
  return fov;
}

Raster parse_raster(std::string_view what, std::string_view text) {
  const std::size_t by = text.find('x');
  if (by == std::string_view::npos)
    throw UsageError(fmt::format("{}: '{}' must be WxH, such as 1024x768", what, text));
  const std::uint64_t width = parse_whole(what, text.substr(0, by), 1, kLargestRaster);
  const std::uint64_t height = parse_whole(what, text.substr(by + 1), 1, kLargestRaster);
  return {static_cast<int>(width), static_cast<int>(height)};
}

Sun parse_sun(std::string_view what, std::string_view text) {
  const std::vector<double> v = parse_list(what, text, "AZ,EL");
  if (std::abs(v[1]) > 90)
    throw UsageError(fmt::format("{}: the elevation {} must lie from -90 to 90", what, v[1]));
  return {v[0], v[1]};
}

void check_ending(std::string_view what, const std::string& file,
                  std::initializer_list<std::string_view> endings) {
  const std::string ending = lower_ending(file);
  if (std::find(endings.begin(), endings.end(), ending) == endings.end())
    throw UsageError(
        fmt::format("{}: '{}' must end in .{}", what, file, fmt::join(endings, " or .")));
}

void fail_on_choice(std::string_view what, std::string_view text,
                    const std::vector<std::string_view>& choices) {
  throw UsageError(
      fmt::format("{}: '{}' is not known; choose from {}", what, text, fmt::join(choices, ", ")));
}

void check_not_input(std::string_view what, const std::string& output, const std::string& input) {
  std::error_code none;
  if (std::filesystem::equivalent(input, output, none))
    throw UsageError(fmt::format("{}: {} is an input; name another", what, output));
}

}  // namespace cigsim
