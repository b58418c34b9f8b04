// SPDX-License-Identifier: MIT
// A page of HTML that needs nothing beside itself: style, script and data inside.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "common/embedded_file.hpp"

namespace cigsim {

/// The files of sim/report/page.
std::span<const EmbeddedFile> embedded_report_page();

/// JSON that no browser takes for HTML within <script>: <, >, & and the line ends U+2028, U+2029
/// are escaped. Bytes that are not UTF-8 are replaced.
std::string script_json(const nlohmann::ordered_json& data);

/// The page of a report. What `data` holds: page/page.js.
std::string report_page(std::string_view title, const nlohmann::ordered_json& data);

}  // namespace cigsim
