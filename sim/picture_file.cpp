// SPDX-License-Identifier: MIT
#include "sim/picture_file.hpp"

#include <fmt/format.h>
#include <png.h>

#include <csetjmp>
#include <new>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "models/environment/input_error.hpp"
#include "models/environment/write.hpp"

namespace cigsim {
namespace {

// Pictures of flat faces have long runs of one colour, which filters only disturb. Level 3 without
// a filter takes about a third of the time of libpng's own choice for twice its few bytes.
constexpr int kCompressionLevel = 3;

void put_bytes(png_structp png, png_bytep bytes, png_size_t count) {
  auto& out = *static_cast<std::ostream*>(png_get_io_ptr(png));
  out.write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(count));
}

void no_flush(png_structp) {}

// libpng reports errors by longjmp: nothing here may need a destructor.
bool write_rows(png_structp png, png_infop info, const Picture& picture, std::ostream& out) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_write_fn(png, &out, put_bytes, no_flush);
  png_set_compression_level(png, kCompressionLevel);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
  const auto width = static_cast<png_uint_32>(picture.width);
  png_set_IHDR(png, info, width, static_cast<png_uint_32>(picture.height), 8, PNG_COLOR_TYPE_RGB,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  png_set_filler(png, 0, PNG_FILLER_AFTER);
  for (int row = 0; row < picture.height; ++row)
    png_write_row(png, reinterpret_cast<png_const_bytep>(picture.colours.data() +
                                                         static_cast<std::size_t>(row) * width));
  png_write_end(png, nullptr);
  return true;
}

// The two structures of libpng, freed together.
struct PngWriter {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;

  PngWriter() {
    if (info != nullptr) return;
    png_destroy_write_struct(&png, nullptr);
    throw std::bad_alloc();
  }
  ~PngWriter() { png_destroy_write_struct(&png, &info); }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;
};

}  // namespace

std::string png_bytes(const Picture& picture) {
  std::ostringstream out;
  PngWriter writer;
  if (!write_rows(writer.png, writer.info, picture, out))
    throw std::runtime_error("libpng could not write a picture");
  return std::move(out).str();
}

void write_png(const Picture& picture, const std::filesystem::path& file) {
  write_file(file, [&](std::ostream& out) {
    PngWriter writer;
    if (!write_rows(writer.png, writer.info, picture, out))
      throw std::runtime_error(fmt::format("{}: libpng could not write it", file.string()));
  });
}

std::vector<std::uint32_t> png_colours(std::string_view bytes, int width, int height,
                                       const std::string& name) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  std::vector<std::uint32_t> colours;
  bool good = png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) != 0;
  if (good && image.width == static_cast<png_uint_32>(width) &&
      image.height == static_cast<png_uint_32>(height)) {
    image.format = PNG_FORMAT_RGBA;
    colours.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    good = png_image_finish_read(&image, nullptr, colours.data(), 0, nullptr) != 0;
  } else {
    good = false;
  }
  png_image_free(&image);
  if (!good)
    throw InputError(name, 0,
                     fmt::format("is no PNG of {} x {} elements; repeat the run", width, height));
  return colours;
}

void write_pgm(const Picture& picture, const std::filesystem::path& file) {
  write_file(file, [&](std::ostream& out) {
    out << fmt::format("P5\n{} {}\n65535\n", picture.width, picture.height);
    const auto width = static_cast<std::size_t>(picture.width);
    std::vector<char> bytes(2 * width);
    for (std::size_t row = 0; row < static_cast<std::size_t>(picture.height); ++row) {
      for (std::size_t c = 0; c < width; ++c) {
        const std::uint16_t number = picture.numbers[row * width + c];
        bytes[2 * c] = static_cast<char>(number >> 8);
        bytes[2 * c + 1] = static_cast<char>(number & 0xff);
      }
      out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    }
  });
}

}  // namespace cigsim
