// SPDX-License-Identifier: MIT
// The three sorts that Sandor 1979 (sec. 5.3, after Knuth 1973) finds in hidden-surface algorithms:
// quicksort, radix sort and bubble sort, with their work counted. Keys are whole numbers; records
// end in ascending order of their keys.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace cigsim::survey {

struct Record {
  std::uint32_t key = 0;
  std::uint32_t index = 0;  ///< what the key belongs to
  friend bool operator==(const Record&, const Record&) = default;
};

struct SortWork {
  std::uint64_t comparisons = 0;  ///< of keys
  std::uint64_t exchanges = 0;    ///< of two records
  std::uint64_t moves = 0;        ///< of one record, from memory to memory
  std::uint64_t passes = 0;       ///< over a list, or over a part of it (quicksort)
};

/// An exchange of quicksort, just made: the records, the two that were exchanged, and whether the
/// right pointer is moving (j decreases) or the left one (i increases).
struct Exchange {
  std::span<const Record> records;
  std::size_t i, j;
  bool right_moves;
};
using ExchangeTrace = std::function<void(const Exchange&)>;

/// Quicksort by comparison and exchange of the records under two pointers, which move towards each
/// other by turns; the parts left and right of where they meet are sorted likewise, the shorter
/// first. About N log N comparisons for keys in no order, N^2 / 2 for keys in order or alike.
void quicksort(std::span<Record> records, SortWork& work, const ExchangeTrace& trace = {});

/// A pass of the radix sort, just made.
struct RadixPass {
  unsigned digit;                        ///< 0: the least significant
  std::vector<std::uint32_t> counts;     ///< of records, by the digit's value
  std::vector<std::uint32_t> allocated;  ///< running sums: where each segment ends
  std::span<const Record> records;       ///< in the area that the pass filled
};
using PassTrace = std::function<void(const RadixPass&)>;

/// Distribution by the digits of the keys in base `radix` (at least 2), the least significant
/// first, between the records' memory and another as large. Makes as many passes as the largest key
/// has digits, one at least, and never compares keys. Equal keys keep their order.
void radix_sort(std::vector<Record>& records, unsigned radix, SortWork& work,
                const PassTrace& trace = {});

/// Passes over the list that exchange neighbours which are out of order, until a pass finds none.
/// Each pass stops where the last exchange of the one before was made. Equal keys keep their order.
void bubble_sort(std::span<Record> records, SortWork& work);

}  // namespace cigsim::survey
