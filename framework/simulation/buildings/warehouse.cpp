#include "simulation/buildings/kinds.hpp"

#include <algorithm>
#include <cmath>

namespace opal::simulation {
namespace {

constexpr int kDockRecess_cm = 20;
constexpr int kBackAisle_cm = 400;
constexpr int kSidesOfRacks_cm = 300;  // aisles along the west and east wall
constexpr int kLongestRack_cm = 3000;  // without a cross aisle
constexpr int kCrossAisle_cm = 350;
constexpr int kOffice_cm = 500;  // its length
constexpr int kFrame_cm = 550;   // between pilasters of the west and east walls

class Warehouse {
 public:
  Warehouse(Variation& vary, double size_m2)
      : vary_(vary),
        rack_depth_(vary.between(110, 250)),
        aisle_(vary.between(280, 360)),
        dock_zone_(vary.between(700, 1200)) {
    const double width = 100 * std::sqrt(1.5 * size_m2);
    const int racks = std::max(2, static_cast<int>(std::lround((width - 2 * kSidesOfRacks_cm) / pitch())));
    height_ = std::max(dock_zone_ + kBackAisle_cm + 600,
                       static_cast<int>(std::lround(100 * std::sqrt(size_m2 / 1.5) / 5)) * 5);
    usual_door_ = vary.between(240, 360);
    usual_door_ = std::min(usual_door_, pitch() - 60);
    has_pillars_ = vary.chance(0.6);
    draw_rows(racks);
    building_.module = pitch();
  }

  PlannedBuilding run() {
    const int width = rows_.back() + kSidesOfRacks_cm;
    building_.plan.room({0, 0, width, height_});
    const bool has_office = vary_.yes(false, 0.7), is_west = vary_.chance(0.5);
    if (has_office)
      office_ = is_west ? Box{0, 0, kOffice_cm, office_depth()} : Box{width - kOffice_cm, 0, width, office_depth()};
    for (std::size_t k = 0; k + 1 < rows_.size(); k += 2) {
      add_row(rows_[k], rows_[k + 1]);
      add_dock(rows_[k], rows_[k + 1], width);
    }
    add_pilasters(width);
    if (has_office) add_office();
    return std::move(building_);
  }

 private:
  int pitch() const { return rack_depth_ + aisle_; }

  /// West and east side of each row of racks.
  void draw_rows(int count) {
    int x = kSidesOfRacks_cm;
    for (int k = 0; k < count; ++k) {
      const int depth = vary_.length(rack_depth_, 110, 250);
      rows_.insert(rows_.end(), {x, x + depth});
      x += depth + vary_.length(aisle_, 280, 450);
    }
  }

  void add_row(int left, int right) {
    const bool is_there = vary_.yes(true, 0.85);
    const int bottom = dock_zone_ + vary_.length(0, 0, 300), top = height_ - kBackAisle_cm - vary_.length(0, 0, 300);
    const int aisle = bottom + rounded_to_grid((top - bottom) * vary_.length(50, 25, 75) / 100);
    if (!is_there) return;
    const bool is_divided = vary_.yes(top - bottom > kLongestRack_cm, 0.5) && top - bottom > 3 * kCrossAisle_cm;
    if (!is_divided) return building_.plan.thing({left, bottom, right, top}, "opal:Rack");
    building_.plan.thing({left, bottom, right, aisle - kCrossAisle_cm / 2}, "opal:Rack");
    building_.plan.thing({left, aisle + kCrossAisle_cm / 2, right, top}, "opal:Rack");
  }

  /// A gate in the south wall before each row, and a pillar between.
  void add_dock(int left, int right, int width) {
    const bool has_gate = vary_.yes(true, 0.6), has_pillar = vary_.yes(has_pillars_, 0.5);
    const int door = vary_.length(usual_door_, 240, 360), shift = vary_.length(0, -60, 60);
    const int middle = (left + right) / 10 * 5;
    const int from = std::max(50, middle + shift - door / 10 * 5), to = std::min(width - 50, from + door);
    if (has_gate && !is_at_office(from, to)) {
      building_.plan.open({from, -kDockRecess_cm, to, 0});
      building_.plan.thing({from, -kDockRecess_cm - 5, to, -kDockRecess_cm}, "opal:Door");
    }
    const int y = rounded_to_grid(dock_zone_ * 11 / 20);
    if (has_pillar) building_.plan.wall({middle - 20, y - 20, middle + 20, y + 20});
  }

  /// Of the frame that carries the roof.
  void add_pilasters(int width) {
    for (std::size_t k = 0; k + 1 < rows_.size(); k += 2)
      if (vary_.yes(true, 0.6)) building_.plan.wall({rows_[k], height_ - 30, rows_[k] + 40, height_});
    for (int y = kFrame_cm; y + kFrame_cm < height_; y += kFrame_cm) {
      if (vary_.yes(true, 0.6)) building_.plan.wall({0, y, 30, y + 40});
      if (vary_.yes(true, 0.6)) building_.plan.wall({width - 30, y, width, y + 40});
    }
  }

  /// In a corner of the dock zone, with a door and a window towards the gates.
  void add_office() {
    const auto [left, bottom, right, top] = office_;
    FloorPlan& plan = building_.plan;
    plan.wall({left - kPartition_cm, bottom, right + kPartition_cm, top + kPartition_cm});
    plan.room(office_);
    plan.door({left + 80, top, left + 180, top + kPartition_cm});
    plan.pane({left + 240, top, left + 440, top + kPartition_cm});
  }
  int office_depth() const { return std::min(dock_zone_ - 250, 450); }
  bool is_at_office(int from, int to) const {
    constexpr int kBeside_cm = 40;
    return office_.width() > 0 && from < office_.right + kBeside_cm && office_.left - kBeside_cm < to;
  }

  Variation& vary_;
  PlannedBuilding building_;
  int rack_depth_, aisle_, dock_zone_, height_ = 0, usual_door_ = 0;
  bool has_pillars_ = true;
  std::vector<int> rows_;
  Box office_;  // without width: none
};

}  // namespace

PlannedBuilding plan_warehouse(Variation& vary, double size_m2) { return Warehouse(vary, size_m2).run(); }

}  // namespace opal::simulation
