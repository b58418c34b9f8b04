// SPDX-License-Identifier: MIT
#include "sim/report/frame_repeat.hpp"

#include <fmt/format.h>

#include "models/environment/input_error.hpp"
#include "models/environment/text_file.hpp"
#include "sim/measure/reference.hpp"
#include "sim/picture_file.hpp"
#include "sim/report/spread.hpp"

namespace cigsim {
namespace {

constexpr std::size_t kMostPlaces = 300;
constexpr std::uint32_t kWrongObject = 0xff3d26d7, kWrongColour = 0xff3aa3f2;  // as Picture

std::uint32_t pale_grey(std::uint32_t colour) {
  const std::uint32_t r = colour & 0xff, g = colour >> 8 & 0xff, b = colour >> 16 & 0xff;
  const std::uint32_t grey = 160 + (54 * r + 183 * g + 19 * b) / 256 * 80 / 255;
  return 0xff000000 | grey << 16 | grey << 8 | grey;
}

std::vector<std::array<int, 2>> places_of_difference(const Picture& a, const Picture& b) {
  std::vector<int> places;
  for (std::size_t i = 0; i < a.numbers.size(); ++i)
    if (a.numbers[i] != b.numbers[i] || a.colours[i] != b.colours[i])
      places.push_back(static_cast<int>(i));
  std::vector<std::array<int, 2>> out;
  for (const std::size_t i : spread_evenly(places.size(), kMostPlaces))
    out.push_back({places[i] % a.width, places[i] / a.width});
  return out;
}

FrameDifference difference_of(const Picture& picture, ReferencePicture reference) {
  FrameDifference out;
  out.error = picture_error(picture, reference);
  if (out.error.wrong + out.error.wrong_colours == 0) return out;
  out.exact_png = png_bytes(reference.picture);
  out.difference_png = png_bytes(difference_picture(picture, reference.picture));
  out.places = places_of_difference(picture, reference.picture);
  return out;
}

std::uint64_t count_other(const Picture& a, const Picture& b) {
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < a.numbers.size(); ++i)
    count += a.numbers[i] != b.numbers[i] || a.colours[i] != b.colours[i];
  return count;
}

}  // namespace

std::vector<std::uint16_t> read_ids(const std::filesystem::path& file, const Raster& raster) {
  const std::string bytes = read_whole_file(file);
  const std::string head = fmt::format("P5\n{} {}\n65535\n", raster.width, raster.height);
  const std::size_t count =
      static_cast<std::size_t>(raster.width) * static_cast<std::size_t>(raster.height);
  if (bytes.compare(0, head.size(), head) != 0 || bytes.size() != head.size() + 2 * count)
    throw InputError(file.string(), 0,
                     fmt::format("holds no {} x {} object numbers of cigsim run; repeat the run",
                                 raster.width, raster.height));
  std::vector<std::uint16_t> ids(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto at = head.size() + 2 * i;
    ids[i] = static_cast<std::uint16_t>(static_cast<unsigned char>(bytes[at]) << 8 |
                                        static_cast<unsigned char>(bytes[at + 1]));
  }
  return ids;
}

Picture read_picture(const RecordedFrame& frame, const std::filesystem::path& folder,
                     const Raster& raster) {
  Picture picture;
  picture.width = raster.width;
  picture.height = raster.height;
  const std::filesystem::path file = folder / frame.picture;
  picture.colours = png_colours(read_whole_file(file), raster.width, raster.height, file.string());
  picture.numbers = read_ids(folder / frame.ids, raster);
  return picture;
}

Picture difference_picture(const Picture& picture, const Picture& exact) {
  Picture out = picture;
  for (std::size_t i = 0; i < out.colours.size(); ++i) {
    if (picture.numbers[i] != exact.numbers[i])
      out.colours[i] = kWrongObject;
    else if (picture.colours[i] != exact.colours[i])
      out.colours[i] = kWrongColour;
    else
      out.colours[i] = pale_grey(picture.colours[i]);
  }
  return out;
}

FrameRepeater::FrameRepeater(const RecordedRun& run)
    : run_(run),
      scene_(load_scene(run.scene_file, run.preparation)),
      machine_(scene_.database, run.machine) {}

RepeatedFrame FrameRepeater::repeat(const RecordedFrame& frame, const Picture& recorded,
                                    bool with_difference) {
  const MachineOptions& options = run_.machine;
  machine_.compute(frame.view.viewpoint, frame.view.position);
  RepeatedFrame out;
  out.faces = machine_.faces();
  // Without time there is no deadline: the machine itself may have come less far down the list.
  keep_first(out.faces, frame.faces);
  out.crossings = crossings_by_line(out.faces, options.raster.height);
  const bool words = options.number == NumberType::kMachine;
  out.limits = line_limits(out.faces, options.raster.height,
                           words ? options.description.crossing_capacity : 0, options.overload);
  const Picture picture =
      shown_picture(out.faces, out.limits, scene_.database.background, options.raster);
  out.other_elements = count_other(picture, recorded);
  if (!with_difference || out.other_elements > 0) return out;
  out.difference = difference_of(
      picture,
      std::move(reference_pictures(scene_.database, {frame.view}, options.raster).front()));
  return out;
}

}  // namespace cigsim
