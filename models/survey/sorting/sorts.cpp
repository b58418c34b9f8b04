// SPDX-License-Identifier: MIT
#include "models/survey/sorting/sorts.hpp"

#include <algorithm>
#include <utility>

namespace cigsim::survey {
namespace {

// One pass of quicksort over [begin, end), which holds two records at least. Returns where the
// first record came to lie, with no greater key left of it and no smaller one right.
std::size_t part(std::span<Record> records, std::size_t begin, std::size_t end, SortWork& work,
                 const ExchangeTrace& trace) {
  std::size_t i = begin, j = end - 1;
  bool right_moves = true;
  ++work.passes;
  while (i < j) {
    ++work.comparisons;
    if (records[i].key > records[j].key) {
      std::swap(records[i], records[j]);
      ++work.exchanges;
      if (trace) trace({records, i, j, right_moves});
      right_moves = !right_moves;
    }
    if (right_moves)
      --j;
    else
      ++i;
  }
  return i;
}

}  // namespace

void quicksort(std::span<Record> records, SortWork& work, const ExchangeTrace& trace) {
  struct Part {
    std::size_t begin, end;
  };
  std::vector<Part> waiting{{0, records.size()}};
  while (!waiting.empty()) {
    const Part now = waiting.back();
    waiting.pop_back();
    if (now.end - now.begin < 2) continue;
    const std::size_t middle = part(records, now.begin, now.end, work, trace);
    Part shorter{now.begin, middle}, longer{middle + 1, now.end};
    if (shorter.end - shorter.begin > longer.end - longer.begin) std::swap(shorter, longer);
    waiting.push_back(longer);
    waiting.push_back(shorter);
  }
}

void radix_sort(std::vector<Record>& records, unsigned radix, SortWork& work,
                const PassTrace& trace) {
  std::uint32_t largest = 0;
  for (const Record& r : records) largest = std::max(largest, r.key);
  std::vector<Record> auxiliary(records.size());
  std::vector<Record>*from = &records, *to = &auxiliary;
  std::uint64_t weight = 1;
  for (unsigned digit = 0; digit == 0 || largest / weight > 0; ++digit, weight *= radix) {
    const auto value = [&](const Record& r) {
      return static_cast<std::size_t>(r.key / weight % radix);
    };
    RadixPass pass{digit, std::vector<std::uint32_t>(radix, 0), {}, {}};
    for (const Record& r : *from) ++pass.counts[value(r)];
    pass.allocated = pass.counts;
    for (unsigned v = 1; v < radix; ++v) pass.allocated[v] += pass.allocated[v - 1];
    std::vector<std::uint32_t> next(pass.allocated);
    for (auto r = from->rbegin(); r != from->rend(); ++r) (*to)[--next[value(*r)]] = *r;
    work.moves += from->size();
    ++work.passes;
    std::swap(from, to);
    if (trace) {
      pass.records = *from;
      trace(pass);
    }
  }
  if (from != &records) records = std::move(auxiliary);
}

void bubble_sort(std::span<Record> records, SortWork& work) {
  std::size_t end = records.size();
  while (end > 1) {
    std::size_t last = 0;
    ++work.passes;
    for (std::size_t i = 1; i < end; ++i) {
      ++work.comparisons;
      if (records[i - 1].key <= records[i].key) continue;
      std::swap(records[i - 1], records[i]);
      ++work.exchanges;
      last = i;
    }
    end = last;
  }
}

}  // namespace cigsim::survey
