#include "made_drives.hpp"

#include "survey/tracking_graph.hpp"

#include <catch2/catch.hpp>

using namespace opal;

namespace {

/// A keyframe that sees faces where the building has them.
TrackedKeyframe keyframe(const Pose2& T_map_base, const SemanticMap& map, const std::vector<double>& offsets_m) {
  TrackedKeyframe made;
  made.T_map_base = T_map_base;
  made.motion_covariance = Eigen::Vector3d(0.01, 0.01, 0.005).cwiseAbs2().asDiagonal();
  for (std::size_t k = 0; k < offsets_m.size(); ++k) {
    const auto& face = std::get<Segment>(map.features()[k].geometry);
    const Pose2 T_base_map = T_map_base.inverse() * Pose2(offsets_m[k] * face.normal(), 0);
    made.measurements.push_back({MapFeatureNumber(static_cast<int>(k)), transformed(T_base_map, face),
                                 Eigen::Vector2d(0.02, 0.01).cwiseAbs2().asDiagonal()});
  }
  return made;
}

}  // namespace

TEST_CASE("legs that begin at one keyframe are one chain, and a wall that is off moves, not the robot") {
  const auto map = made::room();
  const MapView view(map, made::kSensor);
  const std::vector<TrackedKeyframe> on{keyframe({2, 3, 0}, *map, {0, 0.3, 0, 0})};
  TrackedKeyframe off;
  off.T_map_base = Pose2(2.5, 3.4, 0.05);
  const std::vector<TrackedKeyframe> back{off};
  const std::vector<TrackLeg> legs{{on, {0.05, 0.05, 0.02}}, {back, {1, 1, 0.2}, LegPlace{0, 0}}};
  const SolvedLegs solved = TrackingGraph(view, PoseTrackerOptions{}).solve_together(legs);
  REQUIRE(solved.usable);
  CHECK(distance_m(solved.T_map_base[0][0], solved.T_map_base[1][0]) < 0.001);
  CHECK(distance_m(solved.T_map_base[0][0], Pose2(2, 3, 0)) < 0.05);
  CHECK(solved.offsets.at(MapFeatureNumber(1)).moved.norm() == Approx(0.3).margin(0.05));
  CHECK(solved.offsets.at(MapFeatureNumber(0)).moved.norm() < 0.05);
}
