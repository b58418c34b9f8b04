// SPDX-License-Identifier: MIT
// Words as they may stand in XML (SVG) and HTML.
#pragma once

#include <string>
#include <string_view>

namespace cigsim {

/// `words` as UTF-8 that XML and HTML may hold: bytes that are not UTF-8 and characters that XML
/// forbids become U+FFFD; tabs and line ends spaces; other control characters are left out.
std::string clean_words(std::string_view words);

/// The same as the contents of an element, or of an attribute in quotes of either kind:
/// & < > " ' replaced.
std::string markup_escaped(std::string_view words);

}  // namespace cigsim
