#include "synthetic_scene.hpp"

#include "localization/alignment/registration.hpp"
#include "localization/observation/observation.hpp"

#include <array>
#include <numbers>

namespace opal::synthetic {
namespace {

constexpr double kWidth_m = 10, kDepth_m = 7, kRange_m = 25;
constexpr int kBeams = 720;

Feature wall(const Point& begin, const Point& end) { return {"opal:Wall", Segment{begin, end}}; }
Feature corner(const Point& at, double heading_rad) {
  return {"opal:Corner", OrientedPoint{at, heading_rad, 0.5 * std::numbers::pi}};
}

/// The graph would move poses that are right already.
LocalMapOptions without_graph() {
  LocalMapOptions options;
  options.optimize_every = 0;
  return options;
}

}  // namespace

Features room() {
  const std::array<Point, 4> at{Point(0, 0), Point(kWidth_m, 0), Point(kWidth_m, kDepth_m), Point(0, kDepth_m)};
  Features features{{"opal:Column", Circle{{3, 2.2}, 0.4}}};
  for (int k = 0; k < 4; ++k) {
    features.push_back(wall(at[k], at[(k + 1) % 4]));
    features.push_back(corner(at[k], (0.25 + 0.5 * k) * std::numbers::pi));
  }
  return features;
}

Feature seen_wall(const Point& begin, const Point& end) {
  Feature seen = wall(begin, end);
  seen.support_m = (end - begin).norm();
  return seen;
}

Features moved(const Pose2& motion, const Features& features) {
  Features all;
  for (const Feature& feature : features) all.push_back(transformed(motion, feature));
  return all;
}

std::shared_ptr<const MapView> view_of(const Features& features) {
  std::vector<MapObject> objects;
  std::vector<MapFeature> mapped;
  for (std::size_t k = 0; k < features.size(); ++k) {
    const std::string id = "k" + std::to_string(k);
    objects.push_back({id, features[k].type});
    mapped.push_back({id + "-shape", MapObjectNumber(k), features[k].type, "lidar", features[k].geometry});
  }
  return std::make_shared<MapView>(SemanticMap::make("synthetic", std::move(objects), std::move(mapped)), "lidar");
}

Scan scan_from(const MapView& map, const Pose2& T_map_base) {
  const Pose2 T_map_laser = T_map_base * T_base_laser;
  const double step_rad = 2 * std::numbers::pi / kBeams;
  Scan scan{0, step_rad, kRange_m, {}, {}};
  for (int beam = 0; beam < kBeams; ++beam) {
    const double bearing = -std::numbers::pi + beam * step_rad;
    const auto met =
        map.first_crossing(T_map_laser.position(), T_map_laser * Point(kRange_m * unit_vector(bearing)), 0);
    if (met.feature.exists())
      scan.points.push_back({met.range_m * unit_vector(bearing), met.range_m, bearing, beam});
    else
      scan.free_bearings_rad.push_back(bearing);
  }
  return scan;
}

Features detected_from(const MapView& map, const Pose2& T_map_base) {
  const Pose2 T_laser_map = (T_map_base * T_base_laser).inverse();
  Features features;
  for (const MapFeatureNumber number : map.features()) {
    const MapFeature& mapped = map.feature(number);
    if (kind_of(mapped.geometry) != GeometryKind::segment)
      features.push_back(transformed(T_laser_map, Feature{mapped.type, mapped.geometry}));
  }
  return features;
}

Robot::Robot(std::shared_ptr<const MapView> map, const Pose2& T_map_base)
    : map_(std::move(map)), local_map_(without_graph(), nullptr) {
  drive_to(T_map_base);
}

void Robot::drive_to(const Pose2& T_map_base) {
  add(T_map_base, scan_from(*map_, T_map_base), detected_from(*map_, T_map_base));
}

void Robot::drive_blind_to(const Pose2& T_map_base) { add(T_map_base, Scan{}, {}); }

void Robot::add(const Pose2& T_map_base, Scan scan, const Features& features) {
  scan_ = std::move(scan);
  features_ = features;
  T_map_base_ = T_map_base;
  local_map_.add(sample(), seen().features);
}

Sample Robot::sample() const { return sample_of(scan_, T_map_base_, T_base_laser); }

SeenFeatures Robot::seen() const {
  SeenFeatures seen;
  for (const Feature& feature : features_) seen.features.push_back(transformed(T_base_laser, feature));
  seen.views.assign(seen.features.size(), 0);
  return seen;
}

Observation Robot::observation() const { return observe(local_map_, sample(), seen()); }

Hypothesis Robot::at(const Pose2& T_map_base) const {
  Hypothesis hypothesis;
  hypothesis.T_map_local = T_map_base * local_map_.T_local_base().inverse();
  return hypothesis;
}

Score CountingScorer::score(const Hypothesis&, const Observation&, const MapView&, const ScorerMemory* memory) const {
  auto seen = std::make_shared<CountMemory>();
  seen->count = 1;
  return {static_cast<const CountMemory*>(memory)->count, {}, {}, std::move(seen)};
}

void CountingScorer::remember(ScorerMemory& memory, const ScorerMemory& seen, double weight) const {
  static_cast<CountMemory&>(memory).count += weight * static_cast<const CountMemory&>(seen).count;
}

void CountingScorer::fade(ScorerMemory& memory, double weight) const {
  static_cast<CountMemory&>(memory).count *= 1 - 0.5 * weight;
}

double count_of(const Hypothesis& hypothesis, std::size_t scorer) {
  return static_cast<const CountMemory*>(hypothesis.memories.of(scorer))->count;
}

namespace {

struct FitScorer : HypothesisScorer {
  Score score(const Hypothesis& hypothesis, const Observation& observation, const MapView& map,
              const ScorerMemory*) const override {
    const Pose2 T_map_base = observation.T_map_base(hypothesis.T_map_local);
    return {6 * (likelihood_field_score(map, observation.scans.front().points, T_map_base) - 0.5), {}, {}};
  }
  bool judges_associations() const override { return false; }
};

}  // namespace

std::shared_ptr<const HypothesisScorer> fit_scorer() { return std::make_shared<FitScorer>(); }

std::shared_ptr<const HypothesisScorer> constant_scorer(double nat, const std::string& veto) {
  return std::make_shared<ToldScorer>([=](const Hypothesis&, const Observation&) { return Score{nat, veto, {}}; });
}

VerificationOptions no_earlier_scans() {
  VerificationOptions options;
  options.scans = 0;
  return options;
}

std::vector<const LocalFeature*> all_features_of(const LocalMap& local_map) {
  std::vector<const LocalFeature*> all;
  for (const LocalFeature& feature : local_map.features()) all.push_back(&feature);
  return all;
}

std::optional<PatternInstance> CornerTemplate::match(std::span<const Feature* const> features) const {
  const auto& corner = std::get<OrientedPoint>(features[0]->geometry);
  PatternInstance instance;
  instance.members = {0};
  instance.invariants = {{corner.opening_rad, 0.2, Comparison::equal}};
  instance.frame = {corner.position, corner.heading_rad};
  return instance;
}

std::optional<PatternInstance> WallTemplate::match(std::span<const Feature* const> features) const {
  const auto& face = std::get<Segment>(features[0]->geometry);
  PatternInstance instance;
  instance.members = {0};
  instance.overhang_m = 0.3;
  instance.invariants = {{face.length_m(), instance.overhang_m, Comparison::mapped_at_least}};
  instance.frame = {face.midpoint(), face.heading_rad()};
  instance.extent_min_m = -0.5 * face.length_m();
  instance.extent_max_m = 0.5 * face.length_m();
  return instance;
}

}  // namespace opal::synthetic
