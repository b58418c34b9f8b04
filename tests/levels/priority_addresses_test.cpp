// SPDX-License-Identifier: MIT
// The priority processor's RTL with memories of all 32 address bits, which no vector holds: the
// words of a frame are moved to addresses, and its items to numbers, anywhere; the list must be
// that of the definition, and everything but addresses and numbers as before, in every cycle. And
// counts of 32 bits, which no frame has the time for: reset ends them.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <string>
#include <unordered_map>
#include <vector>

#include "firmware/programs.hpp"
#include "models/boundary/rtl_model.hpp"
#include "rtl/priority_processor/priority_processor.pins.hpp"
#include "tests/levels/priority_random_case.hpp"

namespace cigsim::priority_processor {
namespace {

using rtl::priority_processor::Pins;
using SparseWords = std::unordered_map<std::uint32_t, std::uint32_t>;

constexpr std::uint32_t kBankMask = 0x7fff'ffff;  // of addresses of records and lists

/// The module and what it reads. A word that is not there is zero, or of any value.
class Processor {
 public:
  Processor(unsigned members, unsigned levels, std::uint32_t seed)
      : model_(std::filesystem::path(CIGSIM_RTL_LIBRARIES) /
                   ("priority_processor-Members=" + std::to_string(members) +
                    "-Levels=" + std::to_string(levels) + ".so"),
               sizeof(Pins), seed) {
    const firmware::Program program = firmware::stage_program("priority_processor");
    pins().rst_i = true;
    pins().image_write_i = true;
    model_.settle();
    for (const firmware::Microword& word : program.words) {
      pins().image_word_i = word.low;
      edge();
      ++pins().image_address_i;
    }
    pins().image_write_i = false;
    reset(0);
  }

  Pins& pins() { return model_.pins<Pins>(); }
  void reset(std::uint32_t capacity) {
    pins().rst_i = true;
    pins().cfg_object_capacity_i = capacity;
    edge();
    edge();
    pins().rst_i = false;
  }
  void edge() {
    model_.edge();
    pins().memory_word_i = read(memory, pins().memory_address_o);
    pins().bank_word_i = read(bank, pins().bank_address_o);
  }

  SparseWords memory, bank;
  bool any_value = false;

 private:
  std::uint32_t read(const SparseWords& words, std::uint32_t address) const {
    const auto found = words.find(address);
    if (found != words.end()) return found->second;
    return any_value ? static_cast<std::uint32_t>(Random(address).bits()) : 0;
  }

  RtlModel model_;
};

/// A frame, and the same one with its words and numbers elsewhere.
class MovedFrame {
 public:
  MovedFrame(std::uint64_t seed, const test::PriorityLimits& limits) : random_(seed) {
    std::uint32_t items = 0;
    const PriorityHierarchy h = test::random_hierarchy(random_, items, limits);
    const MachineDescription machine;
    const PriorityMemory memory(h, items, 24, machine);
    const ActiveEnvironment active = test::random_frame(h, items, random_);
    const ViewWords view = test::eye_words(active.view.eye, 24, machine.formats);
    PriorityBank bank(memory);
    bank.fill(active, view, ground);
    expected = test::ListByDefinition(h, active, view, 24, machine.formats).list(ground);
    for (std::uint32_t a = 0; a < memory.words.size(); ++a) low_memory[a] = memory.words[a];
    for (std::uint32_t a = 0; a < bank.words().size(); ++a) low_bank[a] = bank.words()[a];
    low_record = bank.first_record();
    for (unsigned set = 0; set < 2; ++set) {
      factor_[set] = static_cast<std::uint32_t>(random_.bits()) | 1;
      first_[set] = static_cast<std::uint32_t>(random_.bits());
    }
    move_memory(h, memory);
    move_bank(active, bank);
  }

  /// The number that an item has in the moved frame.
  std::uint32_t number(SetId set, std::uint32_t item) const {
    if (set == SetId::kGround) return item;
    const unsigned s = set == SetId::kMoving;
    return (item * factor_[s] + first_[s]) & kItemMask;
  }

  static constexpr std::uint32_t ground = 2;
  SparseWords low_memory, low_bank, memory, bank;
  std::uint32_t low_record = 0;        ///< the first one; others follow
  std::vector<std::uint32_t> records;  ///< addresses
  test::ExpectedItems expected;

 private:
  /// Begin of `size` words that are free, often across a power of two.
  std::uint32_t place(const SparseWords& words, std::uint32_t size, std::uint32_t mask) {
    for (;;) {
      std::uint32_t begin = static_cast<std::uint32_t>(random_.bits());
      if (random_.below(2)) begin = (1u << (12 + random_.below(20))) - random_.below(size + 1);
      begin &= mask;
      bool free = begin >= kDirectoryBegin && begin <= mask - size;
      for (std::uint32_t a = 0; free && a < size; ++a) free = !words.contains(begin + a);
      if (free) return begin;
    }
  }
  std::uint32_t item_word(std::uint32_t word) const {
    const SetId set = word & kMovingBit ? SetId::kMoving : SetId::kStatic;
    return (word & ~kItemMask) | number(set, word & kItemMask);
  }

  void move_memory(const PriorityHierarchy& h, const PriorityMemory& low) {
    for (std::size_t g = 0; g < h.groups.size(); ++g) {
      const std::uint32_t record = low.group_address[g], members = low.words[record];
      const std::uint32_t count = h.groups[g].member_count;
      const std::uint32_t to = place(memory, members - record, ~0u);
      groups_.push_back(to);
      for (std::uint32_t a = record; a < members; ++a) memory[to + a - record] = low.words[a];
      const std::uint32_t members_to = memory[to] = place(memory, count, ~0u);
      for (std::uint32_t m = 0; m < count; ++m) {
        const std::uint32_t word = low.words[members + m];
        // Of a group's word only bit 31 counts.
        memory[members_to + m] = word & kGroupBit
                                     ? kGroupBit | static_cast<std::uint32_t>(random_.bits())
                                     : item_word(word);
      }
    }
  }

  void move_bank(const ActiveEnvironment& active, const PriorityBank& low) {
    for (std::uint32_t a = 0; a < kDirectoryBegin; ++a) bank[a] = low.at(a);
    // A group's children follow each other.
    const auto count = static_cast<std::uint32_t>(active.groups.size());
    if (count != 0) bank[kRootAt] = move_records(1);
    for (std::uint32_t g = 0; g < count; ++g) {
      const ActiveGroup& group = active.groups[g];
      const std::uint32_t end = g + 1 < count ? active.groups[g + 1].first_child : count;
      const std::uint32_t high = static_cast<std::uint32_t>(random_.bits()) & ~kBankMask;
      const std::uint32_t child = move_records(end - group.first_child);
      bank[records[g]] = groups_[group.group];
      bank[records[g] + 1] = static_cast<std::uint32_t>(group.active);
      bank[records[g] + 2] = static_cast<std::uint32_t>(group.active >> 32);
      bank[records[g] + 3] = child | high;  // bit 31 does not count
    }
    if (low.at(kPiecesAt) != 0) bank[kPiecesAt] = move_list(low, low.at(kPiecesAt));
    move_directory(low);
  }
  std::uint32_t move_records(std::uint32_t count) {
    const std::uint32_t begin = place(bank, kRecordWords * count, kBankMask);
    for (std::uint32_t i = 0; i < count; ++i) {
      records.push_back(begin + kRecordWords * i);
      for (std::uint32_t w = 0; w < kRecordWords; ++w) bank[records.back() + w] = 0;
    }
    return begin;
  }
  std::uint32_t move_list(const PriorityBank& low, std::uint32_t from) {
    std::uint32_t end = from;
    while (!(low.at(end++) & kLastBit)) {
    }
    const std::uint32_t to = place(bank, end - from, kBankMask);
    for (std::uint32_t a = from; a < end; ++a) bank[to + a - from] = item_word(low.at(a));
    return to;
  }
  void move_directory(const PriorityBank& low) {
    const std::uint32_t items = low.first_record() - kDirectoryBegin;
    std::unordered_map<std::uint32_t, std::uint32_t> lists;
    for (std::uint32_t i = 0; i < items; ++i) {
      const std::uint32_t list = low.at(kDirectoryBegin + i);
      lists[number(SetId::kStatic, i)] = list == 0 ? 0 : move_list(low, list);
    }
    for (bool free = false; !free;) {
      bank[kDirectoryAt] = static_cast<std::uint32_t>(random_.bits());
      free = true;
      for (const auto& [item, list] : lists)
        free = free && !bank.contains(bank[kDirectoryAt] + item);
    }
    for (const auto& [item, list] : lists) bank[bank[kDirectoryAt] + item] = list;
  }

  Random random_;
  std::uint32_t factor_[2], first_[2];
  std::vector<std::uint32_t> groups_;  // addresses of their records in the memory
};

struct Heard {
  std::vector<ItemWord> items;
  std::vector<std::uint32_t> faults;  ///< records
};

/// A frame at both places, cycle by cycle, until its end word is taken.
void list_frame(const MovedFrame& frame, Processor& low, Processor& high, Random& random,
                std::size_t& items) {
  const auto number = static_cast<std::uint32_t>(random.bits());
  low.memory = frame.low_memory;
  low.bank = frame.low_bank;
  high.memory = frame.memory;
  high.bank = frame.bank;
  Heard heard;
  bool started = false;
  for (int cycle = 0;; ++cycle) {
    ASSERT_LT(cycle, 1'000'000);
    const bool ready = random.below(4) != 0;
    for (Processor* p : {&low, &high}) {
      p->pins().start_valid_i = !started;
      p->pins().start_frame_i = number;
      p->pins().items_ready_i = ready;
    }
    const Pins& h = high.pins();
    started = started || h.start_ready_o;
    const bool end = ready && h.items_valid_o && h.items_end_o;
    if (ready && h.items_valid_o)
      heard.items.push_back({static_cast<SetId>(h.items_set_o), h.items_item_o, h.items_end_o});
    low.edge();
    high.edge();
    const Pins& l = low.pins();
    SCOPED_TRACE("cycle " + std::to_string(cycle));
    ASSERT_EQ(h.start_ready_o, l.start_ready_o);
    ASSERT_EQ(h.items_valid_o, l.items_valid_o);
    if (h.items_valid_o) {
      ASSERT_EQ(h.items_set_o, l.items_set_o);
      ASSERT_EQ(h.items_end_o, l.items_end_o);
      ASSERT_EQ(
          h.items_item_o,
          l.items_end_o ? 0 : frame.number(static_cast<SetId>(l.items_set_o), l.items_item_o));
    }
    for (const auto monitor : {&Pins::mon_stalled_o, &Pins::mon_dropped_o, &Pins::mon_group_o,
                               &Pins::mon_plane_o, &Pins::mon_pair_o, &Pins::mon_fault_o})
      ASSERT_EQ(h.*monitor, l.*monitor);
    if (h.mon_fault_o) heard.faults.push_back(h.mon_record_o);
    if (started) {
      ASSERT_EQ(h.mon_frame_o, number);
      ASSERT_EQ(h.bank_o, number & 1);
    }
    if (end) break;
  }
  ASSERT_EQ(heard.items.size(), frame.expected.items.size());
  for (std::size_t i = 0; i < heard.items.size(); ++i) {
    ItemWord word = frame.expected.items[i];
    if (!word.end) word.item = frame.number(word.set, word.item);
    ASSERT_EQ(heard.items[i], word);
  }
  ASSERT_EQ(heard.faults.size(), frame.expected.faults.size());
  for (std::size_t i = 0; i < heard.faults.size(); ++i)
    ASSERT_EQ(heard.faults[i], frame.records[frame.expected.faults[i]]);
  items += heard.items.size();
}

void addresses(unsigned members, unsigned levels, std::uint64_t first_seed, std::uint64_t frames) {
  // The larger size is an exact stand-in.
  Processor low(64, 64, 1), high(members, levels, 2);
  high.any_value = true;
  Random random(first_seed);
  std::size_t items = 0;
  for (std::uint64_t seed = first_seed; seed < first_seed + frames; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    // No limit, or one that is far, and the same in its low bits as a small one.
    const std::uint32_t capacity =
        random.below(3) == 0
            ? 0
            : (1u << (12 + random.below(20))) | random.below(random.below(2) ? 32 : 4096);
    for (Processor* p : {&low, &high}) p->reset(capacity);
    const MovedFrame frame(seed, {members, std::min(levels, 4u)});
    ASSERT_NO_FATAL_FAILURE(list_frame(frame, low, high, random, items));
  }
  EXPECT_GT(items, 10 * frames);
}

TEST(PriorityProcessorRtl, AddressesAreOf32BitsAtASmallSize) { addresses(8, 4, 1, 150); }
TEST(PriorityProcessorRtl, AddressesAreOf32BitsAtAnotherSize) { addresses(64, 4, 1000, 40); }

/// The items of a frame of the processor's words, and when each is there.
struct Listed {
  std::vector<std::uint32_t> items;
  std::vector<int> cycles;  ///< and of the end word
};
Listed list(Processor& p) {
  p.reset(0);
  p.pins().start_valid_i = true;
  p.pins().items_ready_i = true;
  Listed listed;
  for (int cycle = 0; cycle < 1'000'000; ++cycle) {
    if (p.pins().items_valid_o) {
      listed.cycles.push_back(cycle);
      if (p.pins().items_end_o) return listed;
      listed.items.push_back(p.pins().items_item_o);
    }
    p.edge();
  }
  return {};
}

// Which members are active: all that can be of a group of 8.
TEST(PriorityProcessorRtl, AnyMembersOfAGroup) {
  constexpr std::uint32_t kMembers = 8;
  Processor whole(64, 64, 7), small(kMembers, 4, 8);
  whole.bank = {{kDirectoryAt, 1000}, {kRootAt, 100}, {100, 200}};
  whole.memory = {{200, 300}, {201, 1}, {207, kMembers * (kMembers - 1) / 2 - 1}};
  std::uint32_t at = 208;
  for (std::uint32_t f = 0; f < kMembers; ++f)
    for (std::uint32_t t = 0; t < f; ++t) whole.memory[at++] = t | f << 8;
  for (std::uint32_t m = 0; m < kMembers; ++m) whole.memory[300 + m] = m;
  small.memory = whole.memory;
  for (std::uint32_t mask = 0; mask < 1u << kMembers; ++mask) {
    whole.bank[101] = mask;
    small.bank = whole.bank;
    std::vector<std::uint32_t> expected;
    for (std::uint32_t m = 0; m < kMembers; ++m)
      if (mask >> m & 1) expected.push_back(m);
    const Listed listed = list(small);
    ASSERT_EQ(listed.items, expected);
    ASSERT_EQ(listed.cycles, list(whole).cycles);
  }
}

// Groups below each other, each with 64 members, all of them active and all counts different.
void full_groups(unsigned levels) {
  constexpr std::uint32_t kMembers = 64, kApart = 0x1000;
  Processor p(kMembers, levels, 5);
  std::vector<std::uint32_t> expected;
  p.bank = {{kDirectoryAt, 0x4000'0000}, {kRootAt, kApart}};
  for (std::uint32_t level = 0; level < levels; ++level) {
    const std::uint32_t at = kApart * (level + 1), members = at + kApart / 2 + 256;
    p.bank.insert({{at, at}, {at + 1, ~0u}, {at + 2, ~0u}, {at + 3, at + kApart}});
    p.memory.insert({{at, members}, {at + 1, 1}});
    // The eye is on the TRUE side of a plane of zeros: the FALSE member counts.
    std::uint32_t pairs = 0;
    const bool up = level % 2 == 0;
    for (std::uint32_t m = 0; m < kMembers; ++m)
      for (std::uint32_t n = 0; n < (up ? m : kMembers - 1 - m); ++n)
        p.memory[at + 8 + pairs++] = (m == 0 ? 1 : 0) | m << 8;
    p.memory[at + 7] = pairs - 1;
    for (std::uint32_t m = 0; m < kMembers; ++m) p.memory[members + m] = kMembers * level + m;
    // The last member that is listed is the group below.
    const std::uint32_t last = up ? kMembers - 1 : 0;
    for (std::uint32_t i = 0; i < kMembers; ++i)
      expected.push_back(kMembers * level + (up ? i : kMembers - 1 - i));
    if (level + 1 == levels) break;
    expected.pop_back();
    p.memory[members + last] = kGroupBit;
  }
  EXPECT_EQ(list(p).items, expected);
}

TEST(PriorityProcessorRtl, FullGroupsAtTheShippedSize) { full_groups(64); }
TEST(PriorityProcessorRtl, FullGroupsInFourLevels) { full_groups(4); }

TEST(PriorityProcessorRtl, MuchGround) {
  constexpr std::uint32_t kGround = 70'000;
  Processor p(8, 4, 6);
  p.bank = {{kGroundAt, kGround}};
  const std::vector<std::uint32_t> items = list(p).items;
  ASSERT_EQ(items.size(), kGround);
  for (std::uint32_t i = 0; i < kGround; ++i) ASSERT_EQ(items[i], i);
}

/// The beginning of a frame of the processor's words, cycle by cycle.
void begin(Processor& p, const std::function<void(const Pins&)>& see) {
  p.reset(0);
  p.pins().start_valid_i = true;
  p.pins().items_ready_i = true;
  for (int cycle = 0; cycle < 60; ++cycle) {
    see(p.pins());
    p.edge();
  }
}

// One more than a power of two, so that the next number hangs on one bit, and the one after it on
// the borrow.
TEST(PriorityProcessorRtl, GroundIsCountedIn32Bits) {
  Processor p(8, 4, 3);
  for (unsigned bit = 4; bit < 32; ++bit) {
    p.bank = {{kGroundAt, (1u << bit) + 1}};
    std::uint32_t items = 0;
    begin(p, [&](const Pins& pins) {
      if (!pins.items_valid_o) return;
      ASSERT_EQ(pins.items_set_o, 2);
      ASSERT_EQ(pins.items_item_o, items++);
      ASSERT_FALSE(pins.items_end_o);
    });
    EXPECT_GT(items, 12u);
  }
}

TEST(PriorityProcessorRtl, PlanesAreCountedIn32Bits) {
  Processor p(8, 4, 4);
  p.bank = {{kRootAt, 100}, {100, 200}, {101, 3}};  // two members of a group
  for (unsigned bit = 4; bit < 32; ++bit) {
    p.memory = {{201, (1u << bit) + 1}};
    for (std::uint32_t plane = 0; plane < 10; ++plane)
      p.memory[208 + 7 * plane] = 0x0100;  // a pair
    int planes = 0;
    begin(p, [&](const Pins& pins) {
      planes += pins.mon_plane_o;
      ASSERT_FALSE(pins.mon_group_o);
    });
    EXPECT_GT(planes, 3);
  }
}

}  // namespace
}  // namespace cigsim::priority_processor
