// SPDX-License-Identifier: MIT
#include "models/database/partition.hpp"

#include <algorithm>
#include <optional>

#include "models/database/detail/hindrance.hpp"
#include "models/database/separation.hpp"
#include "models/database/sweep.hpp"
#include "models/environment/random.hpp"

namespace cigsim {
namespace {

using ItemList = std::vector<std::uint32_t>;

// How many face planes are examined of a set; all of them when it has no more.
constexpr std::size_t kFaceCandidates = 48;
// Sets up to this size are also examined with planes between pairs of items.
constexpr std::size_t kPairSetSize = 256;
constexpr std::size_t kPairCandidates = 24;
// Eighths of the items' ends at which planes across the axes are examined.
constexpr std::size_t kShares[] = {2, 3, 4, 5, 6};
// A set up to this size takes a plane that cuts nothing even if it parts off a single item; larger
// ones weigh it against cuts. Polygons of surfaces part one by one for ever, bodies seldom do.
constexpr std::size_t kFreeBodies = 8192, kFreePolygons = 64;
// What one cut counts against one item of imbalance.
constexpr std::uint64_t kCutWeight = 8;

struct Counts {
  std::uint64_t positive = 0, negative = 0, flat = 0, cut = 0;
};

struct Candidate {
  Plane plane;
  Counts counts;
  std::uint32_t face_plane = WorkSet::kNothing;  // index, when it is a face's plane

  std::uint64_t imbalance() const {
    const std::uint64_t p = counts.positive, n = counts.negative;
    const std::uint64_t larger = std::max(p, n), smaller = std::min(p, n) + counts.flat;
    return larger > smaller ? larger - smaller : smaller - larger;
  }
  std::uint64_t cost() const { return kCutWeight * counts.cut + imbalance(); }
  bool free() const { return counts.cut == 0; }
};

// Where a subtree hangs.
struct Slot {
  std::int32_t node = -1;  // -1: the root, or below a choice
  bool true_side = false;
  std::int32_t choice = -1;  // leaf of a choice, and which description
  std::size_t description = 0;
};

struct Task {
  ItemList items;
  Slot slot;
};

class Partitioner {
 public:
  Partitioner(WorkSet& set, Composites& composites,
              const std::function<void(std::uint64_t, std::uint64_t)>& progress)
      : set_(set), composites_(composites), progress_(progress), random_(set.items.size()) {}

  Partition run(ItemList all) {
    total_ = all.size();
    if (!all.empty()) tasks_.push_back({std::move(all), {}});
    while (!tasks_.empty()) {
      Task task = std::move(tasks_.back());
      tasks_.pop_back();
      step(std::move(task));
    }
    return std::move(result_);
  }

 private:
  void step(Task task) {
    if (task.items.size() == 1) {
      leaf(std::move(task.items), task.slot);
      return;
    }
    const Sweep sweep = best_sweep(set_, task.items);
    if (sweep.starts.size() > 1)
      split_by_sweep(sweep, task.slot);
    else if (const auto candidate = choose(task.items))
      split_or_give_up(*candidate, std::move(task));
    else if (const auto composite = first_composite(task.items))
      give_up({*composite}, std::move(task));
    else
      explode_or_sheet(std::move(task));
  }

  void attach(Slot slot, std::int32_t child) {
    if (slot.choice >= 0) {
      result_.choices[static_cast<std::size_t>(slot.choice)].roots[slot.description] = child;
      return;
    }
    if (slot.node < 0) {
      result_.root = child;
      return;
    }
    PartitionNode& node = result_.nodes[static_cast<std::size_t>(slot.node)];
    (slot.true_side ? node.true_child : node.false_child) = child;
  }

  std::int32_t node(const Plane& plane, Slot slot) {
    const auto index = static_cast<std::int32_t>(result_.nodes.size());
    result_.planes.push_back(plane);
    result_.nodes.push_back({static_cast<std::uint32_t>(result_.planes.size() - 1), 0, 0});
    attach(slot, index);
    return index;
  }

  void leaf(ItemList items, Slot slot) {
    if (const Composite* composite = composites_.find(items.front())) {
      choice_leaf(Composite(*composite), slot);  // it stands alone
      return;
    }
    std::sort(items.begin(), items.end(),
              [&](std::uint32_t a, std::uint32_t b) { return order_of(a) < order_of(b); });
    done_ += items.size();
    attach(slot, ~static_cast<std::int32_t>(result_.leaves.size()));
    result_.leaves.push_back(std::move(items));
    if (progress_) progress_(done_, total_);
  }

  void choice_leaf(Composite composite, Slot slot) {
    ++done_;
    const auto leaf = static_cast<std::uint32_t>(result_.leaves.size());
    attach(slot, ~static_cast<std::int32_t>(leaf));
    result_.leaves.emplace_back();
    const auto place = static_cast<std::int32_t>(result_.choices.size());
    const std::size_t descriptions = composite.descriptions.size();
    result_.choices.push_back({leaf, composite.choice, {}});
    result_.choices.back().roots.resize(descriptions);
    for (std::size_t d = 0; d < descriptions; ++d) {
      if (composite.descriptions[d].empty()) continue;
      total_ += composite.descriptions[d].size();
      tasks_.push_back({std::move(composite.descriptions[d]), {-1, false, place, d}});
    }
  }

  std::uint32_t order_of(std::uint32_t item) const {
    return set_.polygons[set_.items[item].first_polygon].origin.order;
  }

  // A balanced tree over the runs of a sweep.
  void split_by_sweep(const Sweep& sweep, Slot slot) {
    struct Range {
      std::size_t first, last;  // runs
      Slot slot;
    };
    const auto start = [&](std::size_t run) {
      return run < sweep.starts.size() ? sweep.starts[run] : sweep.order.size();
    };
    std::vector<Range> ranges{{0, sweep.starts.size(), slot}};
    while (!ranges.empty()) {
      const Range range = ranges.back();
      ranges.pop_back();
      if (range.last - range.first == 1) {
        tasks_.push_back(
            {ItemList(sweep.order.begin() + static_cast<std::ptrdiff_t>(start(range.first)),
                      sweep.order.begin() + static_cast<std::ptrdiff_t>(start(range.last))),
             range.slot});
        continue;
      }
      const std::size_t middle = (start(range.first) + start(range.last)) / 2;
      const auto above = std::lower_bound(
          sweep.starts.begin() + static_cast<std::ptrdiff_t>(range.first) + 1,
          sweep.starts.begin() + static_cast<std::ptrdiff_t>(range.last) - 1, middle);
      const auto cut = static_cast<std::size_t>(above - sweep.starts.begin());
      const std::int32_t at = node(axis_plane(sweep.axis, sweep.positions[cut - 1]), range.slot);
      ranges.push_back({range.first, cut, {at, false}});
      ranges.push_back({cut, range.last, {at, true}});
    }
  }

  std::optional<Candidate> evaluate(const Plane& plane, const ItemList& items,
                                    std::uint32_t face_plane,
                                    const std::optional<Candidate>& best) const {
    Candidate c{plane, {}, face_plane};
    for (const std::uint32_t i : items) {
      switch (set_.classify(plane, set_.items[i], face_plane)) {
        case 1:
          ++c.counts.positive;
          break;
        case -1:
          ++c.counts.negative;
          break;
        case 0:
          ++c.counts.flat;
          break;
        default:
          c.counts.cut += cut_weight(i);
      }
      if (best && best->free() && c.counts.cut > 0 && accepts_free(*best, items.size()))
        return std::nullopt;
      if (best && kCutWeight * c.counts.cut > best->cost()) return std::nullopt;
    }
    const Counts& n = c.counts;
    // A face's plane makes progress when it parts the set at all: nothing lies across it again.
    const int sides = (n.positive + n.cut > 0) + (n.negative + n.cut > 0) + (n.flat > 0);
    const bool progress =
        face_plane != WorkSet::kNothing ? sides > 1 : n.positive > 0 && n.negative > 0;
    if (!progress) return std::nullopt;
    return c;
  }

  // A choice that is cut stands twice with all of its descriptions.
  std::uint64_t cut_weight(std::uint32_t item) const {
    const Composite* composite = composites_.find(item);
    return composite == nullptr ? 1 : 2 + composite->descriptions.size();
  }

  bool accepts_free(const Candidate& c, std::size_t size) const {
    return c.free() && (size <= free_size_ || c.imbalance() < size - size / 32);
  }

  bool better(const Candidate& a, const Candidate& b, std::size_t size) const {
    const bool fa = accepts_free(a, size), fb = accepts_free(b, size);
    if (fa != fb) return fa;
    return a.cost() < b.cost();
  }

  std::optional<Candidate> choose(const ItemList& items) {
    const auto singles = std::count_if(items.begin(), items.end(), [&](std::uint32_t i) {
      return set_.items[i].polygon_count == 1;
    });
    free_size_ = 2 * static_cast<std::size_t>(singles) > items.size() ? kFreePolygons : kFreeBodies;
    std::optional<Candidate> best;
    const auto consider = [&](const Plane& plane, std::uint32_t face_plane = WorkSet::kNothing) {
      auto c = evaluate(plane, items, face_plane, best);
      if (c && (!best || better(*c, *best, items.size()))) best = std::move(c);
    };
    consider_faces(items, consider);
    if (best && accepts_free(*best, items.size())) return best;
    consider_pairs(items, consider);
    if (best && accepts_free(*best, items.size())) return best;
    if (items.size() > 2)
      for (const Plane& plane : planes_across_axes(set_, items, kShares)) consider(plane);
    return best;
  }

  template <class Consider>
  void consider_faces(const ItemList& items, Consider consider) {
    std::size_t polygons = 0;
    for (const std::uint32_t i : items) polygons += set_.items[i].polygon_count;
    if (polygons <= kFaceCandidates) {
      for (const std::uint32_t i : items)
        for (std::uint32_t p = 0; p < set_.items[i].polygon_count; ++p) {
          const std::uint32_t plane = set_.polygons[set_.items[i].first_polygon + p].plane;
          consider(set_.planes[plane], plane);
        }
      return;
    }
    for (std::size_t k = 0; k < kFaceCandidates; ++k) {
      const WorkItem& item = set_.items[items[random_.below(items.size())]];
      const WorkPolygon& polygon =
          set_.polygons[item.first_polygon + random_.below(item.polygon_count)];
      consider(set_.planes[polygon.plane], polygon.plane);
    }
  }

  template <class Consider>
  void consider_pairs(const ItemList& items, Consider consider) {
    const std::size_t n = items.size();
    if (n > kPairSetSize) return;
    const auto pair = [&](std::uint32_t a, std::uint32_t b) {
      if (const auto plane = separating_plane(set_, set_.items[a], set_.items[b])) consider(*plane);
    };
    if (n * (n - 1) / 2 <= kPairCandidates) {
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 1; j < n; ++j) pair(items[i], items[j]);
      return;
    }
    for (std::size_t k = 0; k < kPairCandidates; ++k) {
      const std::size_t i = random_.below(n), j = random_.below(n - 1);
      pair(items[i], items[j < i ? j : j + 1]);
    }
  }

  // Planes across the axes at the ends of the middle items.
  void split(const Candidate& chosen, const Task& task) {
    ItemList positive, flat, negative;
    for (const std::uint32_t i : task.items) {
      bool tolerated = false;
      const int where = set_.classify(chosen.plane, set_.items[i], chosen.face_plane, &tolerated);
      result_.tolerated += tolerated;
      switch (where) {
        case 1:
          positive.push_back(i);
          break;
        case -1:
          negative.push_back(i);
          break;
        case 0:
          flat.push_back(i);
          break;
        default:
          cut(chosen.plane, i, positive, negative);
      }
    }
    if (!flat.empty()) {
      unsigned sides = 0;
      for (const std::uint32_t i : flat) sides |= set_.seen_from(chosen.plane, set_.items[i]);
      detach_coplanar(chosen.plane, sides, positive, flat);
      detach_coplanar(chosen.plane, sides, negative, flat);
    }
    // Polygons in the plane come between the two sides; the same plane parts them from both.
    Slot slot = task.slot;
    if (!positive.empty() && !(flat.empty() && negative.empty())) {
      const std::int32_t at = node(chosen.plane, slot);
      tasks_.push_back({std::move(positive), {at, true}});
      slot = {at, false};
    } else if (!positive.empty()) {
      tasks_.push_back({std::move(positive), slot});
      return;
    }
    if (!flat.empty() && !negative.empty()) {
      const std::int32_t at = node(chosen.plane, slot);
      sheet(std::move(flat), {at, true});
      tasks_.push_back({std::move(negative), {at, false}});
    } else if (!flat.empty()) {
      sheet(std::move(flat), slot);
    } else {
      tasks_.push_back({std::move(negative), slot});
    }
  }

  void cut(const Plane& plane, std::uint32_t item, ItemList& positive, ItemList& negative) {
    ++total_;
    if (composites_.find(item) == nullptr) {
      const auto [p, n] = set_.cut(plane, item);
      positive.push_back(p);
      negative.push_back(n);
      ++result_.cuts;
      return;
    }
    const Composites::Cut made = composites_.cut(set_, plane, item);
    if (made.items[0] != WorkSet::kNothing) positive.push_back(made.items[0]);
    if (made.items[1] != WorkSet::kNothing) negative.push_back(made.items[1]);
    result_.cuts += made.cuts;
    result_.tolerated += made.tolerated;
  }

  std::optional<std::uint32_t> first_composite(const ItemList& items) const {
    for (const std::uint32_t i : items)
      if (composites_.find(i) != nullptr) return i;
    return std::nullopt;
  }

  void split_or_give_up(const Candidate& chosen, Task task) {
    ItemList hindered;
    if (first_composite(task.items))
      hindered = hindered_by(set_, composites_, chosen.plane, chosen.face_plane, task.items);
    if (hindered.empty())
      split(chosen, task);
    else
      give_up(hindered, std::move(task));
  }

  // The task again, with the most detailed descriptions in the place of these composites.
  void give_up(const ItemList& composites, Task task) {
    for (const std::uint32_t item : composites) replace_by_most_detailed(item, task.items);
    if (!task.items.empty()) tasks_.push_back(std::move(task));
  }

  void replace_by_most_detailed(std::uint32_t item, ItemList& items) {
    const Composite composite = *composites_.find(item);
    const ItemList& parts = composite.descriptions.back();
    items.erase(std::find(items.begin(), items.end(), item));
    items.insert(items.end(), parts.begin(), parts.end());
    total_ += parts.size();
    --total_;
    result_.given_up.push_back(composite.choice);
  }

  // Beside polygons in the plane, faces of other items in the plane that are seen from the same
  // side belong to the same sheet: only their fixed order decides where they overlap. Composites
  // have none there that meet them.
  void detach_coplanar(const Plane& plane, unsigned sides, ItemList& items, ItemList& flat) {
    for (std::uint32_t& i : items) {
      if (composites_.find(i) != nullptr) continue;
      const auto [rest, coplanar] = set_.detach(plane, i, sides);
      if (coplanar == WorkSet::kNothing) continue;
      i = rest;
      flat.push_back(coplanar);
      ++total_;
    }
  }

  // Coplanar polygons: a sheet in their fixed order, after gaps between them have been used.
  void sheet(ItemList items, Slot slot) {
    const Sweep sweep = best_sweep(set_, items);
    if (sweep.starts.size() > 1) {
      split_by_sweep(sweep, slot);
      return;
    }
    while (items.size() > 1) {
      const auto composite = first_composite(items);
      if (!composite) break;
      replace_by_most_detailed(*composite, items);
    }
    leaf(std::move(items), slot);
  }

  // No plane parts the set: a body within another, say, or polygons all in one plane.
  void explode_or_sheet(Task task) {
    const auto most = std::max_element(
        task.items.begin(), task.items.end(), [&](std::uint32_t a, std::uint32_t b) {
          return set_.items[a].polygon_count < set_.items[b].polygon_count;
        });
    const std::uint32_t item = *most;
    if (set_.items[item].polygon_count == 1) {
      leaf(std::move(task.items), task.slot);
      return;
    }
    task.items.erase(most);
    for (const std::uint32_t single : set_.explode(item)) task.items.push_back(single);
    total_ += set_.items[item].polygon_count - 1;
    tasks_.push_back(std::move(task));
  }

  WorkSet& set_;
  Composites& composites_;
  const std::function<void(std::uint64_t, std::uint64_t)>& progress_;
  Random random_;  // the sampling is the same on every machine
  Partition result_;
  std::vector<Task> tasks_;
  std::size_t free_size_ = 0;
  std::uint64_t done_ = 0, total_ = 0;
};

}  // namespace

Partition partition(WorkSet& set,
                    const std::function<void(std::uint64_t, std::uint64_t)>& progress) {
  Composites none;
  ItemList all(set.items.size());
  for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
  return Partitioner(set, none, progress).run(std::move(all));
}

Partition partition(WorkSet& set, Composites& composites, std::vector<std::uint32_t> items,
                    const std::function<void(std::uint64_t, std::uint64_t)>& progress) {
  return Partitioner(set, composites, progress).run(std::move(items));
}

}  // namespace cigsim
