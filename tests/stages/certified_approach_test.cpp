// SPDX-License-Identifier: MIT
// The approach to the airfield, with its moving models, in certified numbers: all 300 pictures are
// those in exact numbers, in every element's colour and number.
#include <gtest/gtest.h>

#include <filesystem>

#include "models/database/prepare.hpp"
#include "models/environment/read.hpp"
#include "sim/path.hpp"
#include "tests/stages/certified_pair.hpp"

namespace cigsim::test {
namespace {

TEST(CertifiedApproach, ShowsTheExactPictures) {
  const std::filesystem::path scenes = std::filesystem::path(CIGSIM_SOURCE_DIR) / "scenes";
  const Database database = prepare(read_environment(scenes / "airfield.json").environment);
  const std::vector<PathRow> path = read_path(scenes / "airfield-approach.csv");
  ASSERT_GE(path.size(), 300u);
  Pair small(database, {160, 120}, ResolverMethod::kAuto);
  Pair large(database, {1024, 1023}, ResolverMethod::kAuto);
  for (std::size_t f = 0; f < path.size(); ++f) {
    const Viewpoint viewpoint{path[f].eye, path[f].fov.value_or(database.view.fov)};
    small.check(viewpoint, static_cast<double>(f));
    if (f % 60 == 0) large.check(viewpoint, static_cast<double>(f));
  }
  small.tell();
  large.tell();
}

}  // namespace
}  // namespace cigsim::test
