#include "simulation/buildings/kinds.hpp"

#include <algorithm>
#include <cmath>

namespace opal::simulation {
namespace {

/// What one bay of a wall has: a place for it, seen from the hall, is cut behind the wall.
enum class Feature { plain, niche, side_room, glass, shut_door };

struct WallBay {
  Feature feature = Feature::plain;
  int offset = 0, width = 0, depth = 0;
  int pilaster = 0;  ///< how far it stands out at the bay's begin
};

/// One side of the hall: how a box along the wall (from, to) and behind it (near, far; negative: in the hall) lies in
/// the plan.
struct Side {
  int quarter = 0;  ///< 0: south wall, 1: east, 2: north, 3: west
  int width = 0, height = 0;

  Box box(int from, int to, int near, int far) const {
    if (quarter == 0) return {from, -far, to, -near};
    if (quarter == 1) return {width + near, from, width + far, to};
    if (quarter == 2) return {from, height + near, to, height + far};
    return {-far, from, -near, to};
  }
};

constexpr int kDoor_cm = 100, kHallRecess_cm = 15, kHallDoor_cm = 180;

class Hall {
 public:
  Hall(Variation& vary, double size_m2) : vary_(vary) {
    const int pitch_x = vary.between(500, 850), pitch_y = vary.between(500, 850);
    const double width = 100 * std::sqrt(1.6 * size_m2), height = 100 * std::sqrt(size_m2 / 1.6);
    lines_x_ = bays(pitch_x, static_cast<int>(std::lround(width / pitch_x)));
    lines_y_ = bays(pitch_y, static_cast<int>(std::lround(height / pitch_y)));
    building_.module = pitch_x;
    usual_ = drawn_bay(std::min(pitch_x, pitch_y));
    usual_radius_ = vary.between(20, 45);
    usual_is_round_ = vary.chance(0.6);
  }

  PlannedBuilding run() {
    building_.plan.room({0, 0, lines_x_.back(), lines_y_.back()});
    for (int quarter = 0; quarter < 4; ++quarter) add_wall({quarter, lines_x_.back(), lines_y_.back()});
    for (std::size_t row = 1; row + 1 < lines_y_.size(); ++row)
      for (std::size_t column = 1; column + 1 < lines_x_.size(); ++column) add_column(lines_x_[column], lines_y_[row]);
    for (std::size_t row = 0; row + 1 < lines_y_.size(); ++row)
      for (std::size_t column = 0; column + 1 < lines_x_.size(); ++column) add_kiosk(column, row);
    return std::move(building_);
  }

 private:
  std::vector<int> bays(int pitch, int count) {
    std::vector<int> lines{0};
    for (int k = 0; k < std::max(2, count); ++k)
      lines.push_back(lines.back() +
                      vary_.length(pitch, rounded_to_grid(pitch * 3 / 4), rounded_to_grid(pitch * 5 / 4)));
    return lines;
  }

  WallBay drawn_bay(int pitch) {
    WallBay bay;
    bay.feature = static_cast<Feature>(vary_.between(0, 20) / 5);
    bay.width = vary_.between(100, pitch - 200);
    bay.offset = vary_.between(60, pitch - 60 - bay.width);
    bay.depth = bay.feature == Feature::side_room ? vary_.between(250, 450) : vary_.between(40, 160);
    bay.pilaster = vary_.between(0, 40);
    return bay;
  }

  void add_wall(const Side& side) {
    const std::vector<int>& lines = side.quarter % 2 == 0 ? lines_x_ : lines_y_;
    for (std::size_t k = 0; k + 1 < lines.size(); ++k) {
      const int pitch = lines[k + 1] - lines[k];
      WallBay bay = vary_.is_usual() ? usual_ : drawn_bay(pitch);
      bay.width = std::min(bay.width, pitch - 120);
      bay.offset = std::min(bay.offset, pitch - 60 - bay.width);
      add_bay(side, lines[k], bay);
      if (k > 0 && bay.pilaster >= 15) building_.plan.wall(side.box(lines[k] - 25, lines[k] + 25, -bay.pilaster, 0));
    }
  }

  void add_bay(const Side& side, int begin, const WallBay& bay) {
    const int from = begin + bay.offset, to = from + bay.width;
    FloorPlan& plan = building_.plan;
    if (bay.feature == Feature::niche) plan.open(side.box(from, to, 0, bay.depth));
    if (bay.feature == Feature::glass) plan.facade_glass(side.box(from, to, 0, 10));
    if (bay.feature == Feature::shut_door) {
      const int end = std::min(to, from + kHallDoor_cm);
      plan.open(side.box(from, end, 0, kHallRecess_cm));
      plan.thing(side.box(from, end, kHallRecess_cm, kHallRecess_cm + 5), "opal:Door");
    }
    if (bay.feature == Feature::side_room) add_side_room(side, from, std::max(to, from + 180), bay.depth);
  }

  void add_side_room(const Side& side, int from, int to, int depth) {
    building_.plan.room(side.box(from, to, kPartition_cm, kPartition_cm + depth));
    building_.plan.door(side.box(from + 20, from + 20 + kDoor_cm, 0, kPartition_cm));
    if (to - from >= 280) building_.plan.pane(side.box(from + 160, to - 30, 0, kPartition_cm));
  }

  void add_column(int x, int y) {
    const bool is_there = vary_.yes(true, 0.8), is_round = vary_.yes(usual_is_round_, 0.5);
    const int radius = vary_.length(usual_radius_, 20, 45);
    if (!is_there) return;
    if (is_round)
      building_.plan.column(x, y, radius);
    else
      building_.plan.wall({x - radius, y - radius, x + radius, y + radius});
  }

  /// A counter or lift in the middle of a bay; none is usual.
  void add_kiosk(std::size_t column, std::size_t row) {
    const bool is_there = vary_.yes(false, 0.12);
    const int width = lines_x_[column + 1] - lines_x_[column], height = lines_y_[row + 1] - lines_y_[row];
    const int room_x = vary_.between(140, width / 2 - 60), room_y = vary_.between(140, height / 2 - 60);
    if (!is_there) return;
    building_.plan.wall(
        {lines_x_[column] + room_x, lines_y_[row] + room_y, lines_x_[column + 1] - room_x, lines_y_[row + 1] - room_y});
  }

  Variation& vary_;
  PlannedBuilding building_;
  std::vector<int> lines_x_, lines_y_;
  WallBay usual_;
  int usual_radius_ = 0;
  bool usual_is_round_ = true;
};

}  // namespace

PlannedBuilding plan_hall(Variation& vary, double size_m2) { return Hall(vary, size_m2).run(); }

}  // namespace opal::simulation
