// SPDX-License-Identifier: MIT
// A map in the manner of brush editors: a plan is divided by walls with doors into rooms; rooms get
// floors, stairs, a block cut into two wedges, and stacks of crates. Solids touch in faces, edges
// and corners but share no volume. All coordinates are whole numbers.
#include <deque>

#include "models/environment/generators.hpp"
#include "models/environment/shapes.hpp"

namespace cigsim {
namespace {

constexpr int kWall = 2, kHeight = 24, kDoorWidth = 8, kDoorHeight = 16;
constexpr int kDivided = 80;  ///< rooms at least this long are divided

struct Room {
  int x0, y0, x1, y1;
};

class BrushMap {
 public:
  BrushMap(Environment& environment, std::uint32_t objects, Random& random)
      : environment_(environment), objects_(objects), random_(random) {}

  void generate() {
    const int side = 64 * static_cast<int>(root_up(objects_ / 12 + 1, 2));
    std::deque<Room> waiting{{0, 0, side, side}};
    std::vector<Room> rooms;
    while (!waiting.empty()) {
      const Room room = waiting.front();
      waiting.pop_front();
      if (room.x1 - room.x0 < kDivided && room.y1 - room.y0 < kDivided)
        rooms.push_back(room);
      else
        divide(room, waiting);
    }
    for (const Room& room : rooms) furnish(room);
    for (int level = 0; !full(); ++level)
      for (const Room& room : rooms)
        add("crate", {room.x0, room.y1 - 6, 6 * level}, {room.x0 + 6, room.y1, 6 * level + 6});
  }

 private:
  struct Point {
    int x, y, z;
  };

  bool full() const { return environment_.objects.size() == objects_; }

  void add(Object object, const char* name) {
    if (full()) return;
    object.name = name + std::string(" ") + std::to_string(environment_.objects.size() + 1);
    environment_.objects.push_back(std::move(object));
  }
  void add(const char* name, Point low, Point high) {
    add(box({double(low.x), double(low.y), double(low.z)},
            {double(high.x), double(high.y), double(high.z)}),
        name);
  }

  int between(int low, int high) {
    return low + static_cast<int>(random_.below(static_cast<std::uint64_t>(high - low + 1)));
  }

  /// A wall with a door across the longer side.
  void divide(const Room& room, std::deque<Room>& waiting) {
    const bool across_x = room.x1 - room.x0 >= room.y1 - room.y0;
    const int begin = across_x ? room.x0 : room.y0, end = across_x ? room.x1 : room.y1;
    const int low = across_x ? room.y0 : room.x0, high = across_x ? room.y1 : room.x1;
    const int at = between(begin + (end - begin) * 2 / 5, begin + (end - begin) * 3 / 5);
    const int door = between(low + 1, high - kDoorWidth - 1);
    const auto piece = [&](int from, int to, int bottom) {
      if (across_x)
        add("wall", {at, from, bottom}, {at + kWall, to, kHeight});
      else
        add("wall", {from, at, bottom}, {to, at + kWall, kHeight});
    };
    piece(low, door, 0);
    piece(door + kDoorWidth, high, 0);
    piece(door, door + kDoorWidth, kDoorHeight);
    Room first = room, second = room;
    (across_x ? first.x1 : first.y1) = at;
    (across_x ? second.x0 : second.y0) = at + kWall;
    waiting.push_back(first);
    waiting.push_back(second);
  }

  void furnish(const Room& room) {
    add("floor", {room.x0, room.y0, -2}, {room.x1, room.y1, 0});
    for (int step = 0; step < 4; ++step)
      add("step", {room.x0 + 4 * step, room.y0, 0},
          {room.x0 + 4 * step + 4, room.y0 + 8, 3 * (step + 1)});
    // A block cut along the diagonal of its south side.
    const double x0 = room.x1 - 8, x1 = room.x1, y0 = room.y1 - 8, top = between(2, 5) * 2;
    const Vec3 north{0, 8, 0};
    add(prism({{x0, y0, 0}, {x1, y0, top}, {x1, y0, 0}}, north), "wedge");
    add(prism({{x0, y0, 0}, {x0, y0, top}, {x1, y0, top}}, north), "wedge");
  }

  Environment& environment_;
  std::uint32_t objects_;
  Random& random_;
};

}  // namespace

void generate_brushes(Environment& environment, std::uint32_t objects, Random& random) {
  BrushMap(environment, objects, random).generate();
}

}  // namespace cigsim
