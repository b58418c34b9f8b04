// SPDX-License-Identifier: MIT
#include "sim/picture_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <iterator>

#include "models/environment/input_error.hpp"
#include "tests/sim/png_reader.hpp"
#include "tests/support/scratch.hpp"

namespace cigsim {
namespace {

class PictureFile : public testing::Test {
 protected:
  const test::Scratch scratch_;
  const std::filesystem::path& folder_ = scratch_.folder();
};

Picture pattern(int width, int height) {
  Picture picture{width, height, {}, {}};
  for (int i = 0; i < width * height; ++i) {
    picture.colours.push_back(0xff000000u | static_cast<std::uint32_t>(i * 2654435761u >> 8));
    picture.numbers.push_back(static_cast<std::uint16_t>(i * 40503u));
  }
  return picture;
}

TEST_F(PictureFile, PngComesBackElementForElement) {
  for (const auto& [width, height] : {std::pair{1, 1}, {7, 3}, {640, 2}, {1, 300}}) {
    const Picture picture = pattern(width, height);
    write_png(picture, folder_ / "a.png");
    const RgbPicture back = read_png(folder_ / "a.png");
    ASSERT_EQ(back.width, width);
    ASSERT_EQ(back.height, height);
    for (std::size_t i = 0; i < picture.colours.size(); ++i)
      for (std::size_t channel = 0; channel < 3; ++channel)
        ASSERT_EQ(back.bytes[3 * i + channel], picture.colours[i] >> 8 * channel & 0xff);
  }
}

TEST_F(PictureFile, ColoursOfAPngAreReadBack) {
  const Picture picture = pattern(7, 3);
  const std::string bytes = png_bytes(picture);
  EXPECT_EQ(png_colours(bytes, 7, 3, "a.png"), picture.colours);
  EXPECT_THROW(png_colours(bytes, 3, 7, "a.png"), InputError);
  for (std::size_t size = 0; size + 16 < bytes.size(); ++size)  // within the elements at least
    EXPECT_THROW(png_colours(bytes.substr(0, size), 7, 3, "a.png"), InputError) << size;
}

TEST_F(PictureFile, PgmHoldsNumbersHighByteFirst) {
  Picture picture = pattern(3, 1);
  picture.numbers = {0, 258, 65535};
  write_pgm(picture, folder_ / "a.pgm");
  std::ifstream in(folder_ / "a.pgm", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  EXPECT_EQ(bytes, std::string("P5\n3 1\n65535\n\x00\x00\x01\x02\xff\xff", 19));
}

TEST_F(PictureFile, FailingToWriteLeavesNothing) {
  EXPECT_THROW(write_png(pattern(2, 2), folder_ / "absent" / "a.png"), InputError);
  EXPECT_THROW(write_pgm(pattern(2, 2), folder_), InputError);
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

}  // namespace
}  // namespace cigsim
