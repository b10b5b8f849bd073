#include "simulation/buildings/kinds.hpp"

#include <algorithm>
#include <cmath>

namespace opal::simulation {
namespace {

constexpr int kLongestWing_cm = 5000;  // between cross corridors
constexpr int kNarrowestRoom_cm = 250;

/// A room as drawn: lengths from its west wall, along the corridor.
struct Room {
  int width = 0;
  int door = 0, door_width = 0;
  bool has_glass = false;   ///< beside the door
  bool has_window = false;  ///< down to the floor, where there is a facade
  int shaft = 0;            ///< side of a square shaft in a back corner; below 30: none
  bool shaft_is_west = true;
  int buttress = 0;      ///< how far the wall's end stands out into the corridor; below 15: not
  bool is_open = false;  ///< towards the corridor, no door
};

/// Rooms along one side of a corridor, all of one depth.
struct Band {
  int front = 0;           ///< y of the corridor's wall, on the corridor's side
  int inwards = 1;         ///< 1: the rooms are north of it; -1: south
  bool is_facade = false;  ///< outdoors behind the rear wall

  /// A box from `near` to `far` behind the corridor's wall.
  Box box(int left, int right, int near, int far) const {
    const int a = front + inwards * near, b = front + inwards * far;
    return {left, std::min(a, b), right, std::max(a, b)};
  }
};

class Office {
 public:
  Office(Variation& vary, double size_m2)
      : vary_(vary), depth_(vary.between(400, 600)), corridor_(vary.between(170, 260)), cross_(vary.between(200, 300)) {
    usual_ = drawn_room(vary.between(300, 450));
    const int wing = 2 * depth_ + corridor_ + 2 * kPartition_cm;
    const double area = 1e4 * size_m2;
    corridors_ = std::max(1, static_cast<int>(std::lround(std::sqrt(area / 1.8) / wing)));
    const int rooms = std::max(3, static_cast<int>(std::lround(area / corridors_ / wing / pitch())));
    const int most = std::max(1, kLongestWing_cm / pitch());
    wings_ = corridors_ == 1 ? 1 : (rooms + most - 1) / most;
    rooms_ = std::max(2, rooms / wings_);
    building_.module = pitch();
  }

  PlannedBuilding run() {
    const int wing_height = 2 * depth_ + corridor_ + 3 * kPartition_cm;
    for (int k = 0; k < corridors_; ++k) add_corridor(k * wing_height, k == 0, k + 1 == corridors_);
    if (corridors_ > 1)
      for (int k = 0; k <= wings_; ++k)
        add_cross_corridor(left_of_wing(k) - cross_, corridors_ * wing_height - kPartition_cm);
    for (const Box& stub : buttresses_) building_.plan.wall(stub);
    return std::move(building_);
  }

 private:
  int pitch() const { return usual_.width + kPartition_cm; }
  int wing_length() const { return rooms_ * pitch(); }
  int left_of_wing(int wing) const { return wing * (wing_length() + cross_); }

  Room drawn_room(int width) {
    Room room;
    room.width = width;
    room.door_width = vary_.between(90, 120);
    room.door = vary_.between(20, width - 20 - room.door_width);
    room.has_glass = vary_.chance(0.4);
    room.has_window = vary_.chance(0.4);
    room.shaft = vary_.between(0, 90);
    room.shaft_is_west = vary_.chance(0.5);
    room.buttress = vary_.between(0, 30);
    room.is_open = vary_.chance(0.1);
    return room;
  }

  void add_corridor(int bottom, bool is_lowest, bool is_highest) {
    const int front = bottom + depth_ + kPartition_cm;
    const Band south{front, -1, is_lowest}, north{front + corridor_, 1, is_highest};
    for (int wing = 0; wing < wings_; ++wing) {
      const int left = left_of_wing(wing);
      building_.plan.room({left, front, left + wing_length(), front + corridor_});
      for (const Band& band : {south, north}) add_rooms(band, left);
    }
  }

  /// With daylight at its ends; against the outer wall, pillars stand half in it.
  void add_cross_corridor(int left, int top) {
    FloorPlan& plan = building_.plan;
    plan.room({left, 0, left + cross_, top});
    if (vary_.yes(usual_.has_window, 0.5)) plan.facade_glass({left + 40, -10, left + cross_ - 40, 0});
    if (vary_.yes(usual_.has_window, 0.5)) plan.facade_glass({left + 40, top, left + cross_ - 40, top + 10});
    const bool is_first = left<0, is_last = left + cross_> wings_ * (wing_length() + cross_) - cross_;
    for (int y = depth_; (is_first || is_last) && y + 100 < top; y += depth_) {
      const int at = y + vary_.length(0, -100, 100), out = vary_.length(30, 0, 40);
      if (out >= 15 && is_first) plan.wall({left, at, left + out, at + 40});
      if (out >= 15 && is_last) plan.wall({left + cross_ - out, at, left + cross_, at + 40});
    }
  }

  void add_rooms(const Band& band, int left) {
    const int end = left + wing_length() - kPartition_cm / 2;
    int x = left + kPartition_cm / 2;
    while (end - x >= kNarrowestRoom_cm) {
      Room room = vary_.is_usual() ? usual_ : drawn_room(vary_.between(kNarrowestRoom_cm, 900));
      if (end - x - room.width < kPartition_cm + kNarrowestRoom_cm) room.width = end - x;
      room.door = std::min(room.door, room.width - 20 - room.door_width);
      add_room(band, room, left, x);
      x += room.width + kPartition_cm;
    }
  }

  void add_room(const Band& band, const Room& room, int left, int x) {
    FloorPlan& plan = building_.plan;
    plan.room(band.box(x, x + room.width, kPartition_cm, kPartition_cm + depth_));
    add_front(band, room, x);
    const int far = kPartition_cm + depth_;
    if (room.shaft >= 30) {
      const int west = room.shaft_is_west ? x : x + room.width - room.shaft;
      plan.wall(band.box(west, west + room.shaft, far - room.shaft, far));
    }
    if (band.is_facade && room.has_window && room.width >= 250)
      plan.facade_glass(band.box(x + 100, x + room.width - 100, far, far + 10));
    if (room.width >= 600) {
      const int middle = x + room.width / 2, pillar = kPartition_cm + depth_ / 2;
      plan.wall(band.box(middle - 20, middle + 20, pillar - 20, pillar + 20));
    }
    if (room.buttress >= 15 && x > left + kPartition_cm)
      buttresses_.push_back(band.box(x - 25, x + 15, -room.buttress, 0));
  }

  void add_front(const Band& band, const Room& room, int x) {
    FloorPlan& plan = building_.plan;
    if (room.is_open) return plan.open(band.box(x + 30, x + room.width - 30, 0, kPartition_cm));
    const int door_end = room.door + room.door_width;
    plan.door(band.box(x + room.door, x + door_end, 0, kPartition_cm));
    const int east = room.width - 30 - door_end - 20, west = room.door - 20 - 30;
    if (!room.has_glass || std::max(east, west) < 60) return;
    const int from = east >= west ? door_end + 20 : 30;
    plan.pane(band.box(x + from, x + from + std::max(east, west), 0, kPartition_cm));
  }

  Variation& vary_;
  PlannedBuilding building_;
  int depth_, corridor_, cross_;
  Room usual_;
  int corridors_ = 1, wings_ = 1, rooms_ = 1;  ///< rooms: as usual, along one side of a wing
  std::vector<Box> buttresses_;
};

}  // namespace

PlannedBuilding plan_office(Variation& vary, double size_m2) { return Office(vary, size_m2).run(); }

}  // namespace opal::simulation
