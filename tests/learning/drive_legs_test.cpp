#include "made_drives.hpp"

#include "learning/landmarks.hpp"
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

TEST_CASE("a face that the map lacks holds legs together where the map does not") {
  const auto map = made::room();
  const MapView view(map, made::kSensor);
  const Segment lacking{{3, 3}, {5, 3}};
  const auto leg_at = [&](const Pose2& truth, const Pose2& thought) {
    DriveLeg leg;
    leg.track.push_back(keyframe(thought, *map, {}));
    leg.views.push_back({{{transformed(truth.inverse(), lacking)}}, {}, {}});
    return leg;
  };
  std::vector<DriveLeg> legs;
  for (const double x : {3.0, 4.0}) legs.push_back(leg_at({x, 4.5, 0}, {x, 4.5, 0}));
  legs.push_back(leg_at({3.5, 4, 0}, {3.5, 4.05, 0}));
  legs[0].track[0].measurements = keyframe({3, 4.5, 0}, *map, {0, 0, 0, 0}).measurements;
  legs[1].track[0].measurements = keyframe({4, 4.5, 0}, *map, {0, 0, 0, 0}).measurements;
  std::vector<std::vector<Pose2>> poses;
  std::vector<TrackLeg> parts;
  for (const DriveLeg& leg : legs) poses.push_back({leg.track[0].T_map_base});
  const Landmarks landmarks = landmarks_of(view, MapBelief(map->features().size()), legs, poses);
  REQUIRE(landmarks.faces.size() == 1);
  for (std::size_t k = 0; k < legs.size(); ++k)
    parts.push_back({legs[k].track, {1, 1, 0.2}, std::nullopt, std::nullopt, landmarks.sights[k]});
  const SolvedLegs solved = TrackingGraph(view, PoseTrackerOptions{}).solve_together(parts, landmarks.faces);
  REQUIRE(solved.usable);
  CHECK(solved.T_map_base[2][0].y() == Approx(4).margin(0.01));
}
