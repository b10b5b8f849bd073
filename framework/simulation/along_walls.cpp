#include "simulation/along_walls.hpp"

#include <algorithm>

namespace opal::simulation {
namespace {

constexpr double kWay_m = 1.1;         // that stays free between what stands on both sides
constexpr double kBeforeDoor_m = 0.8;  // that stays free around a door
constexpr double kLeastDepth_m = 0.15;

/// Walls and shut doors, and where the doors are.
struct Rooms {
  explicit Rooms(const SemanticMap& map) : walls(shut_solids(map)) {
    for (const MapFeature& feature : map.features())
      if (map.object(feature.object).type == "opal:Door") doors.push_back(feature.geometry);
  }

  /// How deep something before a face may be, so that the same opposite leaves a way.
  double depth_m(const Point& on_face, const Point& away) const {
    constexpr double kReach_m = 4, kClear_m = 0.05;  // of the face itself
    return (kClear_m + room_m(walls, on_face + kClear_m * away, away, kReach_m - kClear_m) - kWay_m) / 2;
  }

  bool is_before_door(const Point& place) const {
    return std::ranges::any_of(doors, [&](const Geometry& door) { return distance_m(door, place) < kBeforeDoor_m; });
  }

  RayCaster walls;
  std::vector<Geometry> doors;
};

/// A closed thing, one on legs, or a round one.
Piece thing(const Pose2& center, double length_m, double depth_m, Random& random) {
  const double kind = random.uniform(0, 1);
  if (kind < 0.75) return box(center, length_m, depth_m);
  if (kind < 0.9) return legs(center, length_m - 0.1, depth_m - 0.1, 0.025);
  return {round_post(center.position(), std::min(depth_m, 0.5) / 2)};
}

/// Along one face from its begin to its end, with gaps between the things.
void line_face(const Rooms& rooms, const Segment& face, double share, Random& random, std::vector<Piece>& pieces) {
  const double gap_m = 1.1 * (1 / share - 1);  // a thing is 1.1 m long on average
  const Point away = face.normal();
  for (double u = random.uniform(0, gap_m + 0.1); u < face.length_m();) {
    const double length_m = random.uniform(0.4, 1.8), wished_m = random.uniform(0.3, 0.8);
    const double off_m = random.uniform(0.02, 0.1), end = u + length_m;
    const auto at = [&](double along) { return Point(face.begin + along * face.direction()); };
    if (end > face.length_m()) return;
    const double room_m = std::min({rooms.depth_m(at(u), away), rooms.depth_m(at(u + length_m / 2), away),
                                    rooms.depth_m(at(end), away)}) -
                          off_m;
    const double depth_m = std::min(wished_m, room_m);
    const Point middle = at(u + length_m / 2) + (off_m + depth_m / 2) * away;
    const bool free = !rooms.is_before_door(at(u) + depth_m * away) && !rooms.is_before_door(middle) &&
                      !rooms.is_before_door(at(end) + depth_m * away);
    if (depth_m > kLeastDepth_m && free)
      pieces.push_back(thing({middle, face.heading_rad()}, length_m, depth_m, random));
    u = end + random.uniform(0, 2 * gap_m);
  }
}

}  // namespace

std::vector<Piece> pieces_along_walls(const SemanticMap& map, double share, Random& random) {
  std::vector<Piece> pieces;
  if (share <= 0) return pieces;
  constexpr double kShortest_m = 0.6;
  const Rooms rooms(map);
  for (const Segment& face : long_faces(map, kShortest_m)) line_face(rooms, face, share, random, pieces);
  return pieces;
}

}  // namespace opal::simulation
