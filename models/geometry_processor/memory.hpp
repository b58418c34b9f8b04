// SPDX-License-Identifier: MIT
// What the geometry processor reads: the faces of a set as words of 32 bits in four memories, and
// the bank that the frame calculator fills for a frame. docs/machine/geometry_processor.md gives
// the layout; it is reconstruction (Stump 1986, ch. II, names faces, edges and vertices as what the
// environment memory holds).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "models/boundary/words.hpp"
#include "models/database/database.hpp"
#include "models/machine/description.hpp"

namespace cigsim::geometry_processor {

inline constexpr std::uint32_t kItemWords = 4;
inline constexpr std::uint32_t kVertexWords = 3;
inline constexpr std::uint32_t kFaceWords = 8;

/// Words of an item's record.
enum ItemField : std::uint8_t { kFirstFace, kFaceCount, kFirstVertex, kVertexCount };
/// Words of a face's record; the normal has three.
enum FaceField : std::uint8_t {
  kFirstCorner = 0,
  kCornerCount = 1,
  kNormal = 2,
  kTwoSided = 5,
  kObject = 6,
  kColour = 7
};

/// The image of a FaceSet.
class FaceMemory {
 public:
  /// Of no faces.
  FaceMemory() = default;
  /// `scale`: the power of two of coordinate_scale. Throws std::invalid_argument with a clear
  /// sentence when an item has more vertices than vertex_capacity, or a face more corners than
  /// corner_capacity.
  FaceMemory(const FaceSet& set, int scale, const MachineDescription& machine);

  std::vector<Word> items;     ///< addresses of face and vertex records, counts (at least 1)
  std::vector<Word> vertices;  ///< x, y, z, scaled
  std::vector<Word> faces;     ///< normals in 1.30; address of the first corner
  std::vector<Word> corners;   ///< vertices, counted within the item

  /// Coordinates that did not fit their word.
  std::uint64_t overflows() const { return overflows_; }

 private:
  void add_item(const FaceSet& set, const Item& item, const MachineDescription& machine);
  void add_face(const FaceSet& set, const PreparedFace& face, const WordFormats& formats);

  std::uint64_t overflows_ = 0;
};

/// What the frame calculator leaves for a frame. The memories must outlive it.
struct GeometryBank {
  ViewWords view;
  std::array<const FaceMemory*, 3> sets{};  ///< by SetId
};

}  // namespace cigsim::geometry_processor
