// SPDX-License-Identifier: MIT
#include "models/edge_orderer/line_orderer.hpp"

#include <algorithm>
#include <cassert>

namespace cigsim::edge_orderer {
namespace {

constexpr int kElementShift = 1 + kFaceBits + kPlaceBits;
constexpr std::uint64_t kBelowElement = (std::uint64_t{1} << kElementShift) - 1;

}  // namespace

void LineOrderer::begin(EdgeBank& bank) {
  bank_ = &bank;
  line_ = 0;
  active_.clear();
  figures_ = {};
  figures_.edges = bank.size();
}

const OrderedLine& LineOrderer::next() {
  step_active();
  enter_new();
  limit_line();
  ++line_;
  return ordered_;
}

// EO2, in the key's place.
std::uint64_t LineOrderer::element_key(Word x) const {
  const std::int64_t up = (std::int64_t{x} + ((1 << kRasterFraction) - 1)) >> kRasterFraction;
  return static_cast<std::uint64_t>(std::clamp<std::int64_t>(up, 0, width_)) << kElementShift;
}

// EO1. Edges that ended leave the list; the others are stepped and put in their new order.
void LineOrderer::step_active() {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < active_.size(); ++i) {
    ActiveEdge edge = active_[i];
    if (edge.end_line == line_) continue;
    edge.x = static_cast<Word>(
        saturate(Accumulator{edge.x} + edge.slope, 8 * sizeof(Word), figures_.overflows));
    edge.key = element_key(edge.x) | (edge.key & kBelowElement);
    std::size_t at = kept++;
    for (; at > 0 && active_[at - 1].key > edge.key; --at) active_[at] = active_[at - 1];
    active_[at] = edge;
  }
  active_.resize(kept);
}

void LineOrderer::enter_new() {
  new_.clear();
  bank_->empty_bucket(static_cast<int>(line_), [&](std::uint32_t place) {
    const EdgeWord& edge = bank_->edge(place);
    assert(edge.face >> kFaceBits == 0 && place >> kPlaceBits == 0);
    new_.push_back({element_key(edge.x) | std::uint64_t{edge.left} << (kFaceBits + kPlaceBits) |
                        std::uint64_t{edge.face} << kPlaceBits | place,
                    edge.x, edge.slope, edge.end_line});
  });
  std::sort(new_.begin(), new_.end(),
            [](const ActiveEdge& a, const ActiveEdge& b) { return a.key < b.key; });
  std::size_t old = active_.size(), fresh = new_.size(), to = old + fresh;
  active_.resize(to);
  while (fresh > 0)
    active_[--to] =
        old > 0 && active_[old - 1].key > new_[fresh - 1].key ? active_[--old] : new_[--fresh];
}

// EO4.
void LineOrderer::limit_line() {
  const auto n = static_cast<std::uint32_t>(active_.size());
  ordered_ = {};
  ordered_.crossings = active_;
  ordered_.count = n;
  figures_.crossings += n;
  if (n > figures_.worst_line_crossings) {
    figures_.worst_line_crossings = n;
    figures_.worst_line = line_;
  }
  ++figures_.passes;
  if (capacity_ == 0 || n <= capacity_) return;
  ++figures_.overfull_lines;
  switch (policy_) {
    case OverloadPolicy::kDrop:
      faces_.clear();
      for (const ActiveEdge& edge : active_) faces_.push_back(edge.face());
      std::nth_element(faces_.begin(), faces_.begin() + capacity_, faces_.end());
      ordered_.face_limit = faces_[capacity_];
      figures_.dropped += static_cast<std::uint64_t>(
          std::count_if(faces_.begin(), faces_.end(),
                        [&](std::uint32_t face) { return face >= ordered_.face_limit; }));
      break;
    case OverloadPolicy::kCut:
      ordered_.count = capacity_;
      ordered_.cut = true;
      ordered_.cut_element = active_[capacity_].element();
      figures_.dropped += n - capacity_;
      break;
    case OverloadPolicy::kExtend:
      figures_.passes += (n - 1) / capacity_;
      break;
  }
}

}  // namespace cigsim::edge_orderer
