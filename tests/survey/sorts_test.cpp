// SPDX-License-Identifier: MIT
// The sorts against the standard library, and step by step as Sandor 1979 prints them.
#include "models/survey/sorting/sorts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "models/environment/random.hpp"
#include "models/survey/sorting/scene_lists.hpp"

namespace cigsim::survey {
namespace {

using Keys = std::vector<std::uint32_t>;

std::vector<Record> records_of(const Keys& keys) {
  std::vector<Record> records;
  for (std::uint32_t i = 0; i < keys.size(); ++i) records.push_back({keys[i], i});
  return records;
}
Keys keys_of(std::span<const Record> records) {
  Keys keys;
  for (const Record& r : records) keys.push_back(r.key);
  return keys;
}

// The ten keys of sec. 5.3 (275 and 703 are lost in the scan's first line, not in later ones).
const Keys kExample{503, 512, 908, 897, 275, 426, 154, 509, 677, 703};

TEST(Sandor, QuicksortExampleSec53) {
  struct Step {
    Keys keys;
    bool right_moves;
  };
  std::vector<Step> steps;
  std::vector<Record> records = records_of(kExample);
  SortWork work;
  quicksort(records, work, [&](const Exchange& exchange) {
    steps.push_back({keys_of(exchange.records), exchange.right_moves});
  });
  const std::vector<Step> printed{{{154, 512, 908, 897, 275, 426, 503, 509, 677, 703}, true},
                                  {{154, 503, 908, 897, 275, 426, 512, 509, 677, 703}, false},
                                  {{154, 426, 908, 897, 275, 503, 512, 509, 677, 703}, true},
                                  {{154, 426, 503, 897, 275, 908, 512, 509, 677, 703}, false},
                                  {{154, 426, 275, 897, 503, 908, 512, 509, 677, 703}, true},
                                  {{154, 426, 275, 503, 897, 908, 512, 509, 677, 703}, false}};
  ASSERT_GE(steps.size(), printed.size());
  for (std::size_t i = 0; i < printed.size(); ++i) {
    EXPECT_EQ(steps[i].keys, printed[i].keys) << "exchange " << i + 1;
    EXPECT_EQ(steps[i].right_moves, printed[i].right_moves) << "exchange " << i + 1;
  }
  Keys sorted = kExample;
  std::sort(sorted.begin(), sorted.end());
  EXPECT_EQ(keys_of(records), sorted);
}

TEST(Sandor, RadixExampleSec53) {
  struct Pass {
    Keys counts, allocated, keys;
  };
  std::vector<Pass> passes;
  std::vector<Record> records = records_of(kExample);
  SortWork work;
  radix_sort(records, 10, work, [&](const RadixPass& pass) {
    passes.push_back({pass.counts, pass.allocated, keys_of(pass.records)});
  });
  const std::vector<Pass> printed{{{0, 0, 1, 2, 1, 1, 1, 2, 1, 1},
                                   {0, 0, 1, 3, 4, 5, 6, 8, 9, 10},
                                   {512, 503, 703, 154, 275, 426, 897, 677, 908, 509}},
                                  {{4, 1, 1, 0, 0, 1, 0, 2, 0, 1},
                                   {4, 5, 6, 6, 6, 7, 7, 9, 9, 10},
                                   {503, 703, 908, 509, 512, 426, 154, 275, 677, 897}},
                                  {{0, 1, 1, 0, 1, 3, 1, 1, 1, 1},
                                   {0, 1, 2, 2, 3, 6, 7, 8, 9, 10},
                                   {154, 275, 426, 503, 509, 512, 677, 703, 897, 908}}};
  ASSERT_EQ(passes.size(), printed.size());
  for (std::size_t i = 0; i < printed.size(); ++i) {
    EXPECT_EQ(passes[i].counts, printed[i].counts) << "pass " << i + 1;
    EXPECT_EQ(passes[i].allocated, printed[i].allocated) << "pass " << i + 1;
    EXPECT_EQ(passes[i].keys, printed[i].keys) << "pass " << i + 1;
  }
  EXPECT_EQ(work.comparisons, 0u);
  EXPECT_EQ(work.passes, 3u);
}

TEST(Sandor, BubbleSec53) {
  // The first pass carries the largest key to the end; a list in order takes one pass; a pair of
  // neighbours out of order takes one exchange.
  SortWork work;
  std::vector<Record> records = records_of({1, 2, 3, 5, 4, 6, 7});
  bubble_sort(records, work);
  EXPECT_EQ(keys_of(records), (Keys{1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(work.exchanges, 1u);
  EXPECT_LE(work.passes, 2u);
  work = {};
  bubble_sort(records, work);
  EXPECT_EQ(work.passes, 1u);
  EXPECT_EQ(work.comparisons, 6u);
  EXPECT_EQ(work.exchanges, 0u);
}

// Sizes and kinds of keys that sorts stumble over.
Keys random_keys(Random& random, int kind, std::size_t size) {
  Keys keys(size);
  for (std::size_t i = 0; i < size; ++i) switch (kind) {
      case 0:
        keys[i] = static_cast<std::uint32_t>(random.below(std::uint64_t{1} << 32));
        break;
      case 1:
        keys[i] = static_cast<std::uint32_t>(random.below(8));
        break;
      case 2:
        keys[i] = static_cast<std::uint32_t>(i);
        break;
      case 3:
        keys[i] = static_cast<std::uint32_t>(size - i);
        break;
      case 4:
        keys[i] = 0xffffffffu - static_cast<std::uint32_t>(random.below(3));
        break;
      default:
        keys[i] = 0;
    }
  return keys;
}

TEST(Sorts, AsTheStandardLibrary) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const int kind = static_cast<int>(seed % 6);
    const std::vector<Record> given =
        records_of(random_keys(random, kind, random.below(seed < 20 ? 5 : 400)));
    std::vector<Record> want = given;
    std::stable_sort(want.begin(), want.end(),
                     [](const Record& a, const Record& b) { return a.key < b.key; });
    SortWork work;
    std::vector<Record> got = given;
    bubble_sort(got, work);
    EXPECT_EQ(got, want);
    for (const unsigned radix : {2u, 10u, 32u, 65536u}) {
      got = given;
      radix_sort(got, radix, work);
      EXPECT_EQ(got, want) << "radix " << radix;
    }
    got = given;
    quicksort(got, work);
    EXPECT_EQ(keys_of(got), keys_of(want));
    std::sort(got.begin(), got.end(), [](const Record& a, const Record& b) {
      return std::pair(a.key, a.index) < std::pair(b.key, b.index);
    });
    EXPECT_EQ(got, want);  // no record is lost
  }
}

TEST(Sandor, QuicksortIsWorseForAListInOrder) {
  // Of the order of N^2 for a list in order, of N log N for one in none.
  Random random(1);
  const std::size_t n = 1000;
  SortWork ordered, none;
  std::vector<Record> records = records_of(random_keys(random, 2, n));
  quicksort(records, ordered);
  EXPECT_EQ(ordered.comparisons, n * (n - 1) / 2);
  records = records_of(random_keys(random, 0, n));
  quicksort(records, none);
  EXPECT_LT(none.comparisons, 30 * n);
}

TEST(Sorts, ListsOfAScene) {
  // One face of two edges over three lines, and one that begins on the second.
  FaceList list;
  list.raster = {8, 4};
  list.rows = {{1, 5}, {1, 5}, {1, 5}, {0, 2}, {3, 6}};
  SurveyFace face;
  face.first_line = 0;
  face.end_line = 3;
  list.faces.push_back(face);
  face.first_line = 1;
  face.first_row = 3;
  list.faces.push_back(face);
  list.rounded.resize(1);
  list.edges = {{0, 0, 3, true}, {0, 0, 3, false}, {1, 1, 3, true}, {1, 1, 3, false}};
  const std::vector<SortLists> lists = scene_lists(list);
  ASSERT_EQ(lists.size(), 4u);
  EXPECT_EQ(keys_of(lists[0].lists[0]), (Keys{0, 0, 1, 1}));
  EXPECT_EQ(keys_of(lists[1].lists[1]), (Keys{0, 1, 2, 5}));
  EXPECT_EQ(keys_of(lists[2].lists[1]), (Keys{1, 5, 0, 2}));
  EXPECT_EQ(keys_of(lists[1].lists[2]), (Keys{3, 1, 6, 5}));  // as ordered on line 1
  EXPECT_TRUE(lists[1].lists[3].empty());
  EXPECT_EQ(lists[1].records, 10u);
  EXPECT_EQ(lists[3].records, 2u);
}

}  // namespace
}  // namespace cigsim::survey
