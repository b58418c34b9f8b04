// SPDX-License-Identifier: MIT
// The SO matrix kept up to date plane by plane, in RTL, against the matrix worked out anew.
#include <gtest/gtest.h>

#include <stdexcept>

#include "models/boundary/rtl_model.hpp"
#include "rtl/priority_processor/so_update.pins.hpp"
#include "sim/cosim/so_cases.hpp"
#include "tests/rtl/so_specification.hpp"

namespace cigsim {
namespace {

using cosim::SoKind;
using priority_processor::SoAnswers;
using priority_processor::SoBits;
using priority_processor::SoGolden;
using priority_processor::SoRow;
using Pins = rtl::so_update::Pins;

constexpr unsigned kObjects = 16, kPlanes = 16;

class Update {
 public:
  explicit Update(std::uint32_t seed)
      : model_(CIGSIM_RTL_LIBRARIES "/so_update-Objects=16-Planes=16.so", sizeof(Pins), seed),
        pins(model_.pins<Pins>()) {
    pins.rst_i = true;
    model_.edge();
    model_.edge();
    pins.rst_i = false;
  }
  void edge() { model_.edge(); }

  void load(const std::vector<SoRow>& rows) {
    pins.clear_i = true;
    edge();
    pins.clear_i = false;
    pins.column_valid_i = true;
    for (unsigned n = 0; n < kPlanes; ++n) {
      pins.column_plane_i = n;
      pins.column_tells_i = pins.column_plus_i = 0;
      for (unsigned o = 0; o < kObjects; ++o) {
        pins.column_tells_i |= std::uint64_t{bit_of(rows[o].tells, n)} << o;
        pins.column_plus_i |= std::uint64_t{bit_of(rows[o].plus, n)} << o;
      }
      edge();
    }
    pins.column_valid_i = false;
  }
  /// The eye is now on this side of the plane. Returns the cycles that it took.
  unsigned side(unsigned plane, bool plus) {
    pins.side_valid_i = true;
    pins.side_plane_i = plane;
    pins.side_plus_i = plus;
    edge();
    pins.side_valid_i = false;
    unsigned cycles = 1;
    for (; !pins.side_ready_o; ++cycles) edge();
    return cycles;
  }
  /// Answers that differ from the golden model's.
  unsigned differing(SoGolden& golden) {
    unsigned differing = 0;
    for (unsigned l = 0; l < kObjects; ++l) {
      pins.row_i = l;
      model_.settle();
      const SoAnswers& expected = golden.row(l);
      differing += pins.row_hides_o != expected.hides[0] ||
                   pins.row_hidden_o != expected.hidden[0] ||
                   pins.row_unresolved_o != expected.unresolved[0];
    }
    return differing;
  }

 private:
  RtlModel model_;

 public:
  Pins& pins;
};

TEST(SoUpdate, StaysEqualToTheMatrixWorkedOutAnew) {
  const std::uint32_t seed = 31;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  Random random(seed);
  Update update(seed);
  SoGolden golden(kObjects, kPlanes);
  const SoBits all{(1u << kObjects) - 1};
  for (unsigned matrix = 0; matrix < 80; ++matrix) {
    SCOPED_TRACE(testing::Message() << "matrix " << matrix);
    const auto kind = static_cast<SoKind>(matrix % static_cast<unsigned>(SoKind::kCount));
    const auto rows = cosim::random_so_rows(random, kind, kObjects, kPlanes);
    update.load(rows);
    // Planes that the eye's side of was not told yet part nobody.
    std::vector<SoRow> told(kObjects);
    SoBits eye{};
    std::uint64_t known = 0;
    for (unsigned n = 0; n < 200; ++n) {
      const unsigned plane = random.below(kPlanes);
      const bool plus = random.below(2) == 1;
      const std::uint64_t bit = std::uint64_t{1} << plane;
      std::uint64_t tells = 0;
      for (unsigned o = 0; o < kObjects; ++o) tells += (rows[o].tells[0] & bit) != 0;
      const bool same = (known & bit) != 0 && bit_of(eye, plane) == plus;
      eye[0] = plus ? eye[0] | bit : eye[0] & ~bit;
      for (unsigned o = 0; o < kObjects; ++o) {
        told[o].tells[0] |= rows[o].tells[0] & bit;
        told[o].plus[0] = rows[o].plus[0];
        golden.set_row(o, told[o]);
      }
      known |= bit;
      golden.mark(eye, all);
      // One cycle, and one for each object that the plane tells of; nothing where it is no news.
      ASSERT_EQ(update.side(plane, plus), same ? 1 : 1 + tells);
      ASSERT_EQ(update.differing(golden), 0u) << "plane " << plane;
    }
  }
}

// The counts of planes at their ends: two halves of the objects that all planes part alike.
TEST(SoUpdate, AllPlanesMayTellTheSameOfTwo) {
  const std::uint32_t seed = 32;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  Random random(seed);
  Update update(seed);
  SoGolden golden(kObjects, kPlanes);
  const std::uint64_t all_planes = (1u << kPlanes) - 1;
  for (unsigned matrix = 0; matrix < 8; ++matrix) {
    std::vector<SoRow> rows(kObjects), told(kObjects);
    for (SoRow& row : rows) {
      row.tells[0] = all_planes;
      if (random.below(2) == 1) row.plus[0] = all_planes;
    }
    update.load(rows);
    SoBits eye{};
    // To one side of all, to the other of all, and back.
    for (const bool plus : {matrix % 2 == 0, matrix % 2 == 1, matrix % 2 == 0}) {
      for (unsigned plane = 0; plane < kPlanes; ++plane) {
        const std::uint64_t bit = std::uint64_t{1} << plane;
        eye[0] = plus ? eye[0] | bit : eye[0] & ~bit;
        for (unsigned o = 0; o < kObjects; ++o) {
          told[o].tells[0] |= bit;
          told[o].plus[0] = rows[o].plus[0];
          golden.set_row(o, told[o]);
        }
        golden.mark(eye, SoBits{(1u << kObjects) - 1});
        update.side(plane, plus);
        ASSERT_EQ(update.differing(golden), 0u) << "matrix " << matrix << ", plane " << plane;
      }
    }
  }
}

TEST(SoUpdate, SidesToldWhileAllIsClearedAreNotTaken) {
  Update update(6);
  std::vector<SoRow> rows(kObjects), untold(kObjects);
  for (unsigned o = 0; o < kObjects; ++o) rows[o] = {SoBits{1}, SoBits{o % 2}};
  update.load(rows);
  SoGolden golden(kObjects, kPlanes);
  for (unsigned o = 0; o < kObjects; ++o) golden.set_row(o, untold[o]);
  golden.mark(SoBits{1}, SoBits{(1u << kObjects) - 1});
  update.pins.clear_i = true;
  EXPECT_EQ(update.side(0, true), 1u);
  update.pins.clear_i = false;
  EXPECT_EQ(update.differing(golden), 0u);
}

TEST(SoUpdate, SeplDoesNotChangeWithinACrossing) {
  Update update(5);
  std::vector<SoRow> rows(kObjects);
  for (SoRow& row : rows) row.tells[0] = 1;
  update.load(rows);
  update.pins.side_valid_i = true;
  update.pins.side_plane_i = 0;
  update.edge();
  update.pins.clear_i = true;
  EXPECT_THROW(update.edge(), std::runtime_error);
}

}  // namespace
}  // namespace cigsim
