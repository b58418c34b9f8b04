// SPDX-License-Identifier: MIT
#include "sim/commands/help.hpp"

#include <sstream>

namespace cigsim {
namespace {

constexpr std::size_t kNames = 30, kDescription = 68;

}  // namespace

std::string wrapped(const std::string& text, std::size_t width) {
  std::string result;
  std::size_t column = 0;
  std::istringstream words(text);
  for (std::string word; words >> word; column += word.size()) {
    if (column > 0) {
      const bool fits = column + 1 + word.size() <= width;
      result += fits ? ' ' : '\n';
      column = fits ? column + 1 : 0;
    }
    result += word;
  }
  return result;
}

HelpFormatter::HelpFormatter() { column_width(kNames); }

// The form of the value and whether it must be given; what excludes what is in the descriptions.
std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
  std::string text = option->get_type_name();
  if (!text.empty()) text.insert(0, 1, ' ');
  if (option->get_required()) text += " (required)";
  return text;
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const {
  return wrapped(option->get_description(), kDescription);
}

}  // namespace cigsim
