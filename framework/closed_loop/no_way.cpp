#include "closed_loop/no_way.hpp"

#include "map_tools/building_ground.hpp"

#include <opal/common/letter_case.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <queue>

namespace opal {
namespace {

struct NearObject {
  const MapObject* object = nullptr;
  double distance_m = std::numeric_limits<double>::infinity();
};

/// The object that lies nearest as mapped: a door's leaf is in its opening.
NearObject nearest_object(const SemanticMap& map, const Point& p, const char* type = nullptr) {
  NearObject nearest;
  for (const MapFeature& feature : map.features()) {
    if (!feature.object.exists()) continue;
    const MapObject& object = map.object(feature.object);
    if (type && object.type != type) continue;
    if (const double off_m = distance_m(feature.geometry, p); off_m < nearest.distance_m) nearest = {&object, off_m};
  }
  return nearest;
}

std::string name_of(const MapObject& object) {
  const std::string type = object.type.rfind("opal:", 0) == 0 ? object.type.substr(5) : object.type;
  return "the " + lower_case_letters(type) + " '" + object.id + "'" +
         (object.notes.name.empty() ? "" : " (" + object.notes.name + ")");
}

double width_m(const SemanticMap& map, const MapObject& door) {
  const auto leaf = leaf_of(map, door);
  return leaf ? leaf->length_m() : 0;
}

/// Looks for the way that meets least, through things, and says what it meets.
class Barrier {
 public:
  explicit Barrier(const simulation::Simulation& simulation) : simulation_(simulation), map_(simulation.building()) {}

  /// @param place  with room for the robot.
  std::string between_floor_and(const Point& place) {
    search(place);
    const Point at = worst_place();
    const NearObject door = nearest_object(map_, at, "opal:Door"), any = nearest_object(map_, at);
    const double needed_m = 2 * simulation_.clearance_m();
    if (door.object && door.distance_m < simulation_.clearance_m() + 0.2) {
      const std::string name = name_of(*door.object);
      const double wide_m = width_m(map_, *door.object);
      if (simulation_.ground().is_shut_outer_door(map_, *door.object)) return name + ", an outer one, is shut";
      if (wide_m < needed_m)
        return name +
               fmt::format(", {:.2f} m wide, is narrower than the robot with its margin, {:.2f} m", wide_m, needed_m);
      return name + " is shut (--doors-open 1 opens all)";
    }
    if (any.object && any.distance_m < simulation_.clearance_m())
      return fmt::format("at ({:.1f}, {:.1f}) ", at.x(), at.y()) + name_of(*any.object) +
             fmt::format(" leaves less room than the robot needs with its margin, {:.2f} m", needed_m);
    return fmt::format("what stands at ({:.1f}, {:.1f}) and is not on the map bars the way", at.x(), at.y());
  }

 private:
  static constexpr double kCell_m = 0.1;
  using Cell = std::array<int, 2>;
  struct Reached {
    double cost;
    Cell cell;
    bool operator>(const Reached& other) const { return cost > other.cost; }
  };

  Point center_of(const Cell& cell) const { return start_ + kCell_m * Point(cell[0], cell[1]); }

  double price(const Point& p) const {
    constexpr double kFree = 1, kTight = 50, kSolid = 2000, kOutdoors = 5000;
    if (simulation_.ground().is_outside(p)) return kOutdoors;
    if (!simulation_.solids().touches(p, simulation_.clearance_m())) return kFree;
    return simulation_.solids().touches(p, kCell_m) ? kSolid : kTight;
  }

  bool is_beyond(const Point& p) const {
    const auto [low, high] = simulation_.solids().bounds();
    return !((p - low).minCoeff() > -1 && (high - p).minCoeff() > -1);
  }

  /// From the place until the floor is met (Dijkstra 1959).
  void search(const Point& place) {
    start_ = place;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<Reached>> open;
    std::map<Cell, double> cost{{Cell{0, 0}, 0}};
    for (open.push({0, {0, 0}}); !open.empty();) {
      const Reached here = open.top();
      open.pop();
      if (here.cost > cost[here.cell]) continue;
      end_ = here.cell;
      if (simulation_.floor().holds(center_of(end_))) return;
      for (const Cell& step : std::array<Cell, 4>{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}}) {
        const Cell next{here.cell[0] + step[0], here.cell[1] + step[1]};
        if (is_beyond(center_of(next))) continue;
        const double next_cost = here.cost + price(center_of(next));
        if (const auto known = cost.find(next); known != cost.end() && known->second <= next_cost) continue;
        cost[next] = next_cost;
        before_[next] = here.cell;
        open.push({next_cost, next});
      }
    }
  }

  /// The middle of the places on the way that are as bad as the worst.
  Point worst_place() const {
    std::vector<Cell> worst;
    double most = 0;
    for (Cell cell = end_; before_.contains(cell); cell = before_.at(cell)) {
      const double bad = price(center_of(cell));
      if (bad > most) worst.clear();
      most = std::max(most, bad);
      if (bad == most) worst.push_back(cell);
    }
    return worst.empty() ? start_ : center_of(worst[worst.size() / 2]);
  }

  const simulation::Simulation& simulation_;
  const SemanticMap& map_;
  Point start_ = Point::Zero();
  Cell end_{0, 0};
  std::map<Cell, Cell> before_;
};

}  // namespace

std::string why_not_at(const simulation::Simulation& simulation, const Point& place) {
  if (simulation.floor().holds(place)) return "";
  const auto [low, high] = simulation.solids().bounds();
  if (!((place - low).minCoeff() >= 0 && (high - place).minCoeff() >= 0))
    return fmt::format("it lies beyond the building, which reaches from ({:.1f}, {:.1f}) to ({:.1f}, {:.1f})", low.x(),
                       low.y(), high.x(), high.y());
  if (simulation.ground().is_outside(place)) return "it lies outdoors, and robots stay inside without --outdoors";
  if (simulation.solids().touches(place, simulation.clearance_m())) {
    const NearObject near = nearest_object(simulation.building(), place);
    const double needed_m = simulation.clearance_m();
    if (near.object && near.distance_m <= needed_m)
      return name_of(*near.object) +
             fmt::format(" is {:.2f} m away, and the robot needs {:.2f} m with its margin", near.distance_m, needed_m);
    return fmt::format("something that is not on the map stands nearer than the {:.2f} m that the robot needs",
                       needed_m);
  }
  return Barrier(simulation).between_floor_and(place);
}

}  // namespace opal
