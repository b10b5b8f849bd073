#include "plugin/testing/visit.hpp"

#include "plugin/testing/scene.hpp"

namespace opal::testing {

Visit::Visit(const MapView& view, const Pose2& T_map_base) : local_map_(LocalMapOptions{}, nullptr) {
  std::vector<Geometry> surfaces;
  for (const MapFeatureNumber number : view.features()) surfaces.push_back(view.feature(number).geometry);
  const int steps = 4;
  for (int step = 0; step < steps; ++step) {
    const Pose2 T_odom_base(0.1 * (step - steps + 1), 0, 0);
    scan_ = simulated_scan(surfaces, T_map_base * T_odom_base, static_cast<unsigned>(step));
    see_features(view, T_map_base * T_odom_base);
    local_map_.add(sample_of(scan_, T_odom_base), features_);
  }
  associate(T_map_base);
}

Observation Visit::observation() const {
  ObservedScan seen{.range_max_m = scan_.range_max_m};
  for (std::size_t i = 0; i < scan_.points.size(); i += 4) {
    seen.points.push_back(scan_.points[i].position);
    seen.beams.push_back(scan_.points[i].beam);
  }
  seen.evidence_cells = local_map_.evidence_cells(seen.points);
  for (std::size_t i = 0; i < scan_.free_bearings_rad.size(); i += 4)
    seen.free_bearings_rad.push_back(scan_.free_bearings_rad[i]);
  return {local_map_, {std::move(seen)}, features_, std::vector<int>(features_.size(), 0)};
}

void Visit::see_features(const MapView& view, const Pose2& T_map_base) {
  features_.clear();
  numbers_.clear();
  for (const MapFeatureNumber number : view.within(T_map_base.position(), 6.0)) {
    Feature feature;
    feature.type = view.feature(number).type;
    feature.geometry = transformed(T_map_base.inverse(), view.feature(number).geometry);
    const bool two =
        kind_of(feature.geometry) == GeometryKind::point || kind_of(feature.geometry) == GeometryKind::segment;
    feature.covariance = Eigen::Vector3d(1e-4, 1e-4, two ? 0.0 : 1e-4).asDiagonal();
    if (const auto* face = std::get_if<Segment>(&feature.geometry)) feature.support_m = face->length_m();
    features_.push_back(feature);
    numbers_.push_back(number);
  }
}

void Visit::associate(const Pose2& T_map_base) {
  truth_.id = HypothesisId(1);
  truth_.T_map_local = T_map_base * local_map_.T_local_base().inverse();
  const std::vector<LocalFeatureId>& local = local_map_.last_associations();
  for (std::size_t i = 0; i < local.size() && i < numbers_.size(); ++i)
    if (local[i].exists()) truth_.associations.push_back({local[i], numbers_[i]});
}

std::vector<NamedHypothesis> hypotheses_near(const Hypothesis& truth) {
  const auto with_pose = [&](const Pose2& T) {
    Hypothesis other = truth;
    other.T_map_local = T;
    return other;
  };
  Hypothesis alone = truth, denied = truth, unknown = truth;
  alone.associations.clear();
  for (Association& association : denied.associations) association.map_feature = {};
  for (Association& association : unknown.associations)
    association.local_feature = LocalFeatureId(association.local_feature.number() + 100000);
  return {{"the true hypothesis", truth},
          {"a hypothesis 0.3 m off", with_pose(truth.T_map_local * Pose2(0.3, 0, 0.05))},
          {"a hypothesis that is turned round", with_pose(truth.T_map_local * Pose2(0, 0, 3))},
          {"a hypothesis 10 km outside the map", with_pose(Pose2(1e4, -1e4, 1))},
          {"a hypothesis without associations", alone},
          {"a hypothesis that associates everything with nothing on the map", denied},
          {"a hypothesis whose local features are forgotten", unknown}};
}

}  // namespace opal::testing
