// SPDX-License-Identifier: MIT
// Strict reading of the command's arguments: the whole word, finite numbers, stated ranges.
//
// `what` names the argument in messages ("--eye"). Everything throws UsageError.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "models/boundary/transactions.hpp"
#include "models/environment/environment.hpp"

namespace cigsim {

/// The command was used wrongly. Printed as one line; the program exits with 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// True and `value` when the whole of `text` is a finite decimal number, in any locale.
bool to_number(std::string_view text, double& value);

double parse_number(std::string_view what, std::string_view text);
double parse_number(std::string_view what, std::string_view text, double low, double high);
std::uint64_t parse_whole(std::string_view what, std::string_view text, std::uint64_t low,
                          std::uint64_t high);

/// As many finite numbers as `form` has ("X,Y,Z": three), separated by commas.
std::vector<double> parse_list(std::string_view what, std::string_view text, std::string_view form);
Vec3 parse_vector(std::string_view what, std::string_view text);

/// Degrees between 0 and 180, both excluded.
double parse_fov(std::string_view what, std::string_view text);

/// WxH, each 1 to 16384.
Raster parse_raster(std::string_view what, std::string_view text);

/// AZ,EL: elevation -90 to 90.
Sun parse_sun(std::string_view what, std::string_view text);

[[noreturn]] void fail_on_choice(std::string_view what, std::string_view text,
                                 const std::vector<std::string_view>& choices);

/// Throws unless the file's name ends in one of `endings` (without the dot; capitals or not).
void check_ending(std::string_view what, const std::string& file,
                  std::initializer_list<std::string_view> endings);

/// Throws when writing `output` would overwrite `input`.
void check_not_input(std::string_view what, const std::string& output, const std::string& input);

/// One of some words, each with its value.
template <class T>
T parse_choice(std::string_view what, std::string_view text,
               std::initializer_list<std::pair<std::string_view, T>> choices) {
  std::vector<std::string_view> names;
  for (const auto& [name, value] : choices) {
    if (name == text) return value;
    names.push_back(name);
  }
  fail_on_choice(what, text, names);
}

}  // namespace cigsim
