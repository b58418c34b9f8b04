// SPDX-License-Identifier: MIT
// The frames of a recorded run computed again: their faces, and how they differ from the exact
// pictures.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/measure/picture_error.hpp"
#include "sim/report/recorded_run.hpp"
#include "sim/report/shown_faces.hpp"

namespace cigsim {

/// Against the exact picture of the most detailed descriptions.
struct FrameDifference {
  PictureError error;
  std::string exact_png, difference_png;  ///< bytes; none where nothing differs
  /// [column, line] of elements that differ, row by row; of very many some, spread over all.
  std::vector<std::array<int, 2>> places;
};

struct RepeatedFrame {
  FrameFaces faces;
  std::vector<std::uint32_t> crossings;  ///< by line, before any were dropped
  std::vector<LineLimit> limits;         ///< by line
  std::uint64_t other_elements = 0;      ///< where the faces do not give what was recorded
  std::optional<FrameDifference> difference;
};

class FrameRepeater {
 public:
  /// Loads the run's scene as the run did: a relative name is one of the current folder. Throws
  /// InputError or UsageError when that is not possible any more.
  explicit FrameRepeater(const RecordedRun& run);

  /// Computes a frame again; `recorded` is the picture that the run wrote.
  RepeatedFrame repeat(const RecordedFrame& frame, const Picture& recorded, bool with_difference);
  const Database& database() const { return scene_.database; }

 private:
  const RecordedRun& run_;
  LoadedScene scene_;
  FunctionalMachine machine_;
};

/// The object numbers of a PGM as the run writes it. Throws InputError when it is another file or
/// of another size.
std::vector<std::uint16_t> read_ids(const std::filesystem::path& file, const Raster& raster);

/// Colours and object numbers as the run wrote them into `folder`. Throws InputError.
Picture read_picture(const RecordedFrame& frame, const std::filesystem::path& folder,
                     const Raster& raster);

/// Where the two differ: in the object red, in the colour alone orange, else a pale grey of the
/// picture. Both on one raster.
Picture difference_picture(const Picture& picture, const Picture& exact);

}  // namespace cigsim
