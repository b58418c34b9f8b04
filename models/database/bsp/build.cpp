// SPDX-License-Identifier: MIT
#include "models/database/bsp/build.hpp"

#include <algorithm>
#include <utility>

namespace cigsim {
namespace {

using Items = std::vector<std::uint32_t>;

// A list that waits for its subtree, and where that hangs.
struct Task {
  Items items;
  std::uint32_t parent;  // kLeaf: the root
  bool positive;
  std::uint64_t depth;  // of the parent
};

class Builder {
 public:
  Builder(BspPolygons polygons, const BspOptions& options)
      : body_(std::move(polygons.body)), options_(options), chooser_(tree_.set, options.root) {
    tree_.set = std::move(polygons.set);
    tree_.polygons = tree_.set.items.size();
  }

  BspTree run() {
    Items all(tree_.set.items.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
    tasks_.push_back({std::move(all), BspNode::kLeaf, false, 0});
    while (!tasks_.empty()) {
      const Task task = std::move(tasks_.back());
      tasks_.pop_back();
      step(task);
    }
    return std::move(tree_);
  }

 private:
  void step(const Task& task) {
    if (task.items.empty()) return;
    if (of_one_body(task.items))
      chain(task);
    else
      divide(task, chooser_.choose(task.items));
    if (options_.progress)
      options_.progress(static_cast<double>(tree_.members.size()) /
                        static_cast<double>(tree_.polygons + tree_.splits));
  }

  std::uint32_t body_of(std::uint32_t item) const {
    return body_[tree_.polygon(item).origin.order];
  }

  bool of_one_body(const Items& items) const {
    const std::uint32_t body = body_of(items[0]);
    return items.size() == 1 || (body != BspPolygons::kNoBody &&
                                 std::all_of(items.begin(), items.end(),
                                             [&](std::uint32_t i) { return body_of(i) == body; }));
  }

  std::uint32_t add_node(std::uint32_t plane, std::uint32_t parent, bool positive,
                         std::uint64_t depth) {
    const auto index = static_cast<std::uint32_t>(tree_.nodes.size());
    BspNode node;
    node.plane = plane;
    node.first = static_cast<std::uint32_t>(tree_.members.size());
    tree_.nodes.push_back(node);
    if (parent != BspNode::kLeaf)
      (positive ? tree_.nodes[parent].positive : tree_.nodes[parent].negative) = index;
    tree_.depth = std::max(tree_.depth, depth);
    return index;
  }

  void add_member(std::uint32_t node, std::uint32_t item) {
    tree_.members.push_back(item);
    ++tree_.nodes[node].count;
  }

  void chain(const Task& task) {
    std::uint32_t parent = task.parent;
    bool positive = task.positive;
    std::uint64_t depth = task.depth;
    for (const std::uint32_t i : task.items) {
      parent = add_node(tree_.polygon(i).plane, parent, positive, ++depth);
      add_member(parent, i);
      positive = false;
    }
  }

  void divide(const Task& task, std::uint32_t plane_index) {
    const Plane plane = tree_.set.planes[plane_index];
    const std::uint32_t node = add_node(plane_index, task.parent, task.positive, task.depth + 1);
    Items positive, negative;
    for (const std::uint32_t i : task.items) {
      switch (tree_.set.classify(plane, tree_.set.items[i], plane_index)) {
        case 1:
          positive.push_back(i);
          break;
        case -1:
          negative.push_back(i);
          break;
        case 0:
          add_member(node, i);
          break;
        default: {
          const auto [p, n] = tree_.set.cut(plane, i);
          positive.push_back(p);
          negative.push_back(n);
          ++tree_.splits;
        }
      }
    }
    tree_.dividing_planes += tree_.nodes[node].count == 0;
    // The last in is the first out: nodes are numbered root, positive side, negative side.
    tasks_.push_back({std::move(negative), node, false, task.depth + 1});
    tasks_.push_back({std::move(positive), node, true, task.depth + 1});
  }

  BspTree tree_;
  std::vector<std::uint32_t> body_;
  const BspOptions& options_;
  RootChooser chooser_;
  std::vector<Task> tasks_;
};

}  // namespace

BspTree build_bsp(BspPolygons polygons, const BspOptions& options) {
  return Builder(std::move(polygons), options).run();
}

}  // namespace cigsim
