// SPDX-License-Identifier: MIT
// How --help is set out: descriptions wrapped beside their options.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace cigsim {

/// `text` with line breaks at blanks, so that no line is longer than `width` where a blank allows.
std::string wrapped(const std::string& text, std::size_t width);

class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter();
  std::string make_option_opts(const CLI::Option* option) const override;
  std::string make_option_desc(const CLI::Option* option) const override;
};

}  // namespace cigsim
