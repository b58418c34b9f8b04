// SPDX-License-Identifier: MIT
// Words in SVG and HTML: whatever the bytes, what comes out is UTF-8 that both may hold, and means
// the words.
#include "sim/markup.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

namespace cigsim {
namespace {

const std::string kGap = "\xef\xbf\xbd";

TEST(MarkupEscaped, MeansItselfInElementsAndAttributes) {
  EXPECT_EQ(markup_escaped("<a b='c'>&\""), "&lt;a b=&#39;c&#39;&gt;&amp;&quot;");
  EXPECT_EQ(markup_escaped("&amp;"), "&amp;amp;");
  EXPECT_EQ(markup_escaped(""), "");
}

TEST(MarkupEscaped, LeavesCharactersOfEveryLength) {
  const std::string words = "aäµ€\xf0\x9d\x84\x9e";
  EXPECT_EQ(markup_escaped(words), words);
}

TEST(MarkupEscaped, HasNoControlCharacters) {
  EXPECT_EQ(markup_escaped(std::string("a\0b\x01\x1f\x7f", 6)), "ab");
  EXPECT_EQ(markup_escaped("a\tb\nc\rd"), "a b c d");
  EXPECT_EQ(markup_escaped("a\xc2\x85"
                           "b"),
            "ab");  // U+0085
}

TEST(MarkupEscaped, ReplacesWhatIsNotUtf8OrNotOfXml) {
  EXPECT_EQ(markup_escaped("\xff"), kGap);
  EXPECT_EQ(markup_escaped("a\xc3"), "a" + kGap);                 // cut short
  EXPECT_EQ(markup_escaped("\xc0\xbc"), kGap + kGap);             // "<", too long
  EXPECT_EQ(markup_escaped("\xed\xa0\x80"), kGap + kGap + kGap);  // a surrogate
  EXPECT_EQ(markup_escaped("\xf4\x90\x80\x80"), kGap + kGap + kGap + kGap);
  EXPECT_EQ(markup_escaped("\xef\xbf\xbe"), kGap);  // U+FFFE
  EXPECT_EQ(markup_escaped("\xc3<"), kGap + "&lt;");
}

// The JSON library judges what is UTF-8.
TEST(MarkupEscaped, RandomBytesComeOutAsUtf8) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 3000; ++trial) {
    std::string bytes;
    for (unsigned i = random() % 12; i-- > 0;)
      bytes += static_cast<char>(random() % 3 == 0 ? random() % 128 : 128 + random() % 128);
    const std::string out = markup_escaped(bytes);
    EXPECT_NO_THROW(nlohmann::json(out).dump()) << trial;
    EXPECT_EQ(out.find_first_of("<>\"'\n"), std::string::npos) << trial;
  }
}

}  // namespace
}  // namespace cigsim
