// SPDX-License-Identifier: MIT
// Priority in machine words, from the memories to the list (Stump 1986, ch. II and III): the
// arithmetic that the functional and the timed level share. A Pace is told of every step on the way
// and receives the items; what a step costs is the timed level's business.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "models/priority_processor/figures.hpp"
#include "models/priority_processor/memory.hpp"

namespace cigsim::priority_processor {

/// The steps, by the names of the costs in the microprogram.
enum class Step : std::uint8_t {
  kInView,
  kNothing,
  kPiecesOnly,
  kGroupOfOne,
  kGroupBare,
  kGroup,
  kPlane,
  kPair,
  kNextPlane,
  kLastPlane,
  kOrder,
  kMember,
  kOrdered,
  kFault,
  kRank,
  kRanked,
  kNextRank,
  kLastRank,
  kToGroup,
  kToItem,
  kToList,
  kItem,
  kUp,
  kOut,
  kList,
  kListOn,
  kListUp,
  kListOut,
  kToGround,
  kGround,
  kToEnd,
  kCount
};

template <class Pace>
class ListWalk {
 public:
  explicit ListWalk(Pace& pace) : pace_(pace) {}

  /// Gives the frame's items to pace.put(ItemWord), without the end word; at most `capacity` of
  /// them (0: all), the rest is counted as dropped. pace.spend(Step, times) hears of the steps.
  void run(const PriorityBank& bank, std::uint32_t capacity, Figures& figures) {
    bank_ = &bank;
    figures_ = &figures;
    capacity_ = capacity;
    if (const std::uint32_t root = bank.at(kRootAt)) {
      pace_.spend(Step::kInView);
      walk_groups(root);
    } else if (const std::uint32_t pieces = bank.at(kPiecesAt)) {
      pace_.spend(Step::kPiecesOnly);
      put_list(pieces, Step::kListOut);
    } else {
      pace_.spend(Step::kNothing);
    }
    for (std::uint32_t i = 0; i < bank.at(kGroundAt); ++i) {
      pace_.spend(Step::kToGround);
      put({SetId::kGround, i, false}, Step::kGround);
    }
    pace_.spend(Step::kToEnd);
  }

 private:
  /// A group's members in order: an item, or with kGroupBit the record of a group.
  struct Level {
    std::array<std::uint32_t, kGroupCapacity> entry;
    std::uint32_t place = 0, number = 0;
  };
  using Counts = std::array<std::uint8_t, kGroupCapacity>;

  static constexpr std::uint8_t kMostCount = 63;  ///< counters of 6 bits saturate

  std::uint32_t memory(std::uint32_t address) const { return bank_->memory().words[address]; }

  // Depth first (PP4).
  void walk_groups(std::uint32_t root) {
    depth_ = 0;
    order_group(root);
    while (depth_ > 0) {
      Level& level = levels_[depth_ - 1];
      if (level.place == level.number) {
        --depth_;
        pace_.spend(depth_ > 0 ? Step::kUp : Step::kOut);
        continue;
      }
      const std::uint32_t entry = level.entry[level.place++];
      if (entry & kGroupBit) {
        pace_.spend(Step::kToGroup);
        order_group(entry & ~kGroupBit);
      } else if (const std::uint32_t list = bank_->at(bank_->at(kDirectoryAt) + entry)) {
        pace_.spend(Step::kToList);
        put_list(list, Step::kListUp);
      } else {
        pace_.spend(Step::kToItem);
        put({SetId::kStatic, entry, false}, Step::kItem);
      }
    }
  }

  // Opens a level with the group's members in order (PP2).
  void order_group(std::uint32_t record) {
    const std::uint64_t active =
        bank_->at(record + 1) | static_cast<std::uint64_t>(bank_->at(record + 2)) << 32;
    std::uint32_t address = bank_->at(record);
    const std::uint32_t members = memory(address);
    const std::uint32_t planes = memory(address + 1);
    address += 2;
    Counts counts{};
    if (std::popcount(active) < 2) {
      pace_.spend(Step::kGroupOfOne);
    } else if (planes == 0) {
      pace_.spend(Step::kGroupBare);
    } else {
      pace_.spend(Step::kGroup);
      for (std::uint32_t p = 0; p < planes; ++p) address = count_plane(address, active, counts);
      pace_.spend(Step::kNextPlane, planes - 1);
      pace_.spend(Step::kLastPlane);
    }
    ++figures_->groups;
    if (levels_.size() == depth_) levels_.emplace_back();
    Level& level = levels_[depth_++];
    level.place = 0;
    level.number = static_cast<std::uint32_t>(std::popcount(active));
    fill_level(record, members, active, counts, level);
  }

  // Returns the address after the plane and its pairs (PP1, PP2).
  std::uint32_t count_plane(std::uint32_t address, std::uint64_t active, Counts& counts) {
    Accumulator sum = 0;
    for (std::uint32_t i = 0; i < 3; ++i)
      sum += static_cast<Accumulator>(static_cast<Word>(memory(address + i))) *
             static_cast<Word>(bank_->at(kEyeAt + i));
    const std::uint64_t distance =
        memory(address + 3) | static_cast<std::uint64_t>(memory(address + 4)) << 32;
    const bool eye_true = sum - static_cast<Accumulator>(distance) >= 0;
    const std::uint32_t pairs = memory(address + 5) + 1;
    const std::uint32_t end = address + 6 + pairs;
    const unsigned far_shift = eye_true ? 8 : 0;  // the member on the side opposite the eye
    for (address += 6; address < end; ++address) {
      const std::uint32_t pair = memory(address);
      const bool both = (active >> (pair & 63)) & (active >> (pair >> 8 & 63)) & 1;
      std::uint8_t& count = counts[pair >> far_shift & 63];
      count = static_cast<std::uint8_t>(count + (both && count < kMostCount));
    }
    ++figures_->planes;
    figures_->pairs += pairs;
    pace_.spend(Step::kPlane);
    pace_.spend(Step::kPair, pairs);
    return end;
  }

  // By count; at a fault by count, then number (PP3).
  void fill_level(std::uint32_t record, std::uint32_t members, std::uint64_t active,
                  const Counts& counts, Level& level) {
    std::array<std::uint32_t, kGroupCapacity> entries;
    std::uint32_t child = bank_->at(record + 3);
    std::uint64_t seen = 0;
    for (std::uint64_t rest = active; rest != 0; rest &= rest - 1) {
      const int m = std::countr_zero(rest);
      const std::uint32_t member = memory(members + static_cast<std::uint32_t>(m));
      const bool group = (member & kGroupBit) != 0;
      entries[m] = group ? kGroupBit | child : member;
      if (group) child += kRecordWords;
      seen |= std::uint64_t{1} << counts[m];
      level.entry[counts[m]] = entries[m];
    }
    pace_.spend(Step::kOrder);
    pace_.spend(Step::kMember, level.number);
    if (std::popcount(seen) == static_cast<int>(level.number) && (seen & (seen + 1)) == 0) {
      pace_.spend(Step::kOrdered);  // 0 to number - 1, each once
      return;
    }
    figures_->faults.push_back((record - bank_->first_record()) / kRecordWords);
    std::uint32_t place = 0;
    for (unsigned rank = 0; rank < kGroupCapacity; ++rank)
      for (std::uint64_t rest = active; rest != 0; rest &= rest - 1) {
        const int m = std::countr_zero(rest);
        if (counts[m] == rank) level.entry[place++] = entries[m];
      }
    pace_.spend(Step::kFault);
    pace_.spend(Step::kRank, kGroupCapacity);
    pace_.spend(Step::kRanked, kGroupCapacity * level.number);
    pace_.spend(Step::kNextRank, kGroupCapacity - 1);
    pace_.spend(Step::kLastRank);
  }

  void put_list(std::uint32_t address, Step then) {
    for (bool last = false; !last; ++address) {
      const std::uint32_t word = bank_->at(address);
      last = (word & kLastBit) != 0;
      pace_.spend(Step::kList);
      put({word & kMovingBit ? SetId::kMoving : SetId::kStatic, word & kItemMask, false},
          last ? then : Step::kListOn);
    }
  }

  // PP6.
  void put(const ItemWord& item, Step then) {
    if (capacity_ != 0 && figures_->items == capacity_) {
      ++figures_->dropped;
    } else {
      pace_.put(item);
      ++figures_->items;
    }
    pace_.spend(then);
  }

  Pace& pace_;
  const PriorityBank* bank_ = nullptr;
  Figures* figures_ = nullptr;
  std::uint32_t capacity_ = 0;
  std::vector<Level> levels_;
  std::uint32_t depth_ = 0;
};

}  // namespace cigsim::priority_processor
