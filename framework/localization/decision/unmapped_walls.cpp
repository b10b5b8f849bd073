#include "localization/decision/unmapped_walls.hpp"

#include <cmath>

namespace opal {
namespace {

constexpr double kShortestWall_m = 2.5, kBeside_m = 0.3, kStep_m = 0.2;

/// Sampled in the middle of pieces of about kStep_m.
double unmapped_m(const Segment& wall, const MapView& map) {
  const int pieces = static_cast<int>(std::ceil(wall.length_m() / kStep_m));
  int unmapped = 0;
  for (int k = 0; k < pieces; ++k) {
    const Point middle = wall.begin + (k + 0.5) / pieces * (wall.end - wall.begin);
    if (map.clearance_m(middle) > kBeside_m) ++unmapped;
  }
  return wall.length_m() * unmapped / pieces;
}

}  // namespace

double unmapped_walls_m(const LocalMap& local_map, const MapView& map, const Pose2& T_map_local) {
  double sum_m = 0;
  for (const LocalFeature& local : local_map.features()) {
    const auto* wall = std::get_if<Segment>(&local.feature.geometry);
    if (!wall || !local.stable || wall->length_m() < kShortestWall_m) continue;
    sum_m += unmapped_m(transformed(T_map_local, *wall), map);
  }
  return sum_m;
}

}  // namespace opal
