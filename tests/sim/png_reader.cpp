// SPDX-License-Identifier: MIT
#include "tests/sim/png_reader.hpp"

#include <png.h>

#include <stdexcept>

namespace cigsim {

RgbPicture read_png(const std::filesystem::path& file) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, file.c_str()) == 0)
    throw std::runtime_error(file.string() + ": " + image.message);
  if (image.format != PNG_FORMAT_RGB) throw std::runtime_error(file.string() + " is not 8-bit RGB");
  RgbPicture picture{static_cast<int>(image.width), static_cast<int>(image.height), {}};
  picture.bytes.resize(PNG_IMAGE_SIZE(image));
  if (png_image_finish_read(&image, nullptr, picture.bytes.data(), 0, nullptr) == 0)
    throw std::runtime_error(file.string() + ": " + image.message);
  return picture;
}

}  // namespace cigsim
