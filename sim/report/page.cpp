// SPDX-License-Identifier: MIT
#include "sim/report/page.hpp"

#include <map>

#include "sim/markup.hpp"

namespace cigsim {
namespace {

// In the order in which they need each other.
constexpr const char* kScripts[] = {"elements.js", "priority.js", "timeline.js", "graphs.js",
                                    "tables.js",   "picture.js",  "frame.js",    "page.js"};

// Puts values where the template says {{name}}; what comes in is not looked at again.
std::string filled(std::string_view text, const std::map<std::string_view, std::string>& values) {
  std::string out;
  while (!text.empty()) {
    const std::size_t open = text.find("{{");
    out += text.substr(0, open);
    if (open == std::string_view::npos) break;
    const std::size_t close = text.find("}}", open);
    out += values.at(text.substr(open + 2, close - open - 2));
    text.remove_prefix(close + 2);
  }
  return out;
}

}  // namespace

std::string script_json(const nlohmann::ordered_json& data) {
  const std::string text =
      data.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '<') {
      out += "\\u003c";
    } else if (text[i] == '>') {
      out += "\\u003e";
    } else if (text[i] == '&') {
      out += "\\u0026";
    } else if (text.compare(i, 3, "\xe2\x80\xa8") == 0 || text.compare(i, 3, "\xe2\x80\xa9") == 0) {
      out += text[i + 2] == '\xa8' ? "\\u2028" : "\\u2029";
      i += 2;
    } else {
      out += text[i];
    }
  }
  return out;
}

std::string report_page(std::string_view title, const nlohmann::ordered_json& data) {
  const auto files = embedded_report_page();
  std::string script;
  for (const char* name : kScripts) script += embedded_text(files, name);
  return filled(embedded_text(files, "page.html"),
                {{"title", markup_escaped(title)},
                 {"style", std::string(embedded_text(files, "page.css"))},
                 {"script", script},
                 {"data", script_json(data)}});
}

}  // namespace cigsim
