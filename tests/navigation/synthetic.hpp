#pragma once

#include "navigation/blackboard.hpp"
#include "simulation/simulation.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace opal::navigation {

/// A map of faces, each named after its number.
inline std::shared_ptr<const SemanticMap> map_of(const std::vector<Segment>& faces) {
  std::vector<MapObject> objects;
  std::vector<MapFeature> features;
  for (const Segment& face : faces) {
    const std::string name = "wall-" + std::to_string(objects.size());
    features.push_back({name + "/face", MapObjectNumber(objects.size()), "opal:Wall", "PlanarLidar2D", face});
    objects.push_back({name, "opal:Wall"});
  }
  return SemanticMap::make("synthetic", std::move(objects), std::move(features));
}

/// Faces of a polygon, visible from its inside.
inline std::vector<Segment> room_of(const std::vector<Point>& counter_clockwise) {
  std::vector<Segment> faces;
  for (std::size_t k = 0; k < counter_clockwise.size(); ++k)
    faces.push_back({counter_clockwise[k], counter_clockwise[(k + 1) % counter_clockwise.size()]});
  return faces;
}

inline LaserModel wide_laser() { return simulation::SimulationOptions::default_laser(); }

/// What a perfect laser sees of a map.
inline Scan seen(const MapView& map, const LaserModel& laser, const Pose2& T_map_base, double stamp_s = 0) {
  const Pose2 T_map_laser = T_map_base * laser.T_base_laser;
  Scan scan{stamp_s, laser.angle_increment_rad, laser.range_max_m, {}, {}};
  for (int beam = 0; beam < laser.beams; ++beam) {
    const double bearing = laser.angle_min_rad + beam * laser.angle_increment_rad;
    const Point direction = laser.range_max_m * unit_vector(bearing);
    const auto met = map.first_crossing(T_map_laser.position(), T_map_laser * direction, 0);
    if (met.feature.exists()) scan.points.push_back({met.range_m * unit_vector(bearing), met.range_m, bearing, beam});
  }
  return scan;
}

/// Localization that says what it is told to.
struct ToldQueries : LocalizationQueries {
  explicit ToldQueries(std::shared_ptr<const SemanticMap> map_given) : view(std::move(map_given), "PlanarLidar2D") {}

  PoseEstimate estimate() const override { return said; }
  const Scan& newest_scan() const override { return scan; }
  const Pose2& T_odom_base() const override { return odom; }
  const LaserModel& laser() const override { return model; }
  std::vector<Geometry> pattern() const override { return {}; }
  const MapView& map() const override { return view; }

  /// The robot is at `truth`, and takes it for one of `places`, the first one best.
  void stand(const Pose2& truth, const std::vector<Pose2>& places, double stamp_s) {
    odom = truth;
    scan = seen(view, model, truth, stamp_s);
    said = {};
    said.has_pose = !places.empty();
    said.status = places.size() == 1 ? Status::localized : Status::ambiguous;
    said.probability = places.empty() ? 0 : 1.0 / static_cast<double>(places.size());
    if (said.has_pose) said.T_map_base = places.front();
    for (std::size_t k = 1; k < places.size(); ++k)
      said.alternatives.push_back({HypothesisId(k), places[k], said.probability});
  }

  /// Besides, something that is not on the map, where odometry is right. Frame `map`.
  void also_see(const Point& p_map) {
    const Point p = (odom * model.T_base_laser).inverse() * p_map;
    scan.points.push_back({p, p.norm(), std::atan2(p.y(), p.x()), 0});
  }

  MapView view;
  LaserModel model = wide_laser();
  PoseEstimate said;
  Scan scan;
  Pose2 odom;
};

/// A robot in a map, with a goal.
struct SyntheticMoment {
  explicit SyntheticMoment(std::shared_ptr<const SemanticMap> map = map_of(room_of({{0, 0}, {8, 0}, {8, 6}, {0, 6}})),
                           const Point& goal = {2, 2})
      : queries(std::move(map)), floor(mapped_floor(queries.view, 0.25)), blackboard(queries, motion, floor, goal) {}
  ToldQueries queries;
  MotionPrimitives motion;
  FloorGrid floor;
  Blackboard blackboard;
};

}  // namespace opal::navigation
