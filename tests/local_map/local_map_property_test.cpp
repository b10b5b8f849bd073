#include <opal/local_map/local_map.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <optional>
#include <random>

using namespace opal;

namespace {

double uniform(std::mt19937& random, double extent) {
  return std::uniform_real_distribution<double>(-extent, extent)(random);
}

/// Drives through a drawn world of all shapes and records what was read and detected.
struct Drive {
  std::vector<Pose2> T_odom_base;
  std::vector<std::vector<Feature>> detected;  ///< in the sensor frame
  std::vector<Scan> scans;
};

const Pose2 kT_base_laser(0.3, 0.05, 0.02);

std::vector<Feature> random_world(std::mt19937& random) {
  const Eigen::Matrix3d covariance = Eigen::Vector3d(0.02, 0.02, 0.01).cwiseAbs2().asDiagonal();
  std::vector<Feature> world;
  for (int i = 0; i < 4; ++i) {
    const Point a(6 * i, 4 + uniform(random, 1)), b{uniform(random, 6), uniform(random, 6)};
    world.push_back({"opal:Wall", Segment{a, a + Point(3, uniform(random, 0.5))}, covariance, {false, true}, 3});
    world.push_back({"opal:Pillar", Circle{Point(6 * i, -4) + b, 0.2 + 0.1 * i}, covariance, {}, 0});
    world.push_back(
        {"opal:Corner", OrientedPoint{Point(6 * i + 3, -8) + b, uniform(random, 3), 1.6}, covariance, {}, 0});
    world.push_back({"acme:Pole", Point(Point(6 * i + 3, -16) + b), covariance, {}, 0});
  }
  return world;
}

/// Moved a little; of a segment, some part, so that no two detections have exactly the same length.
Feature noisy(std::mt19937& random, Feature feature) {
  if (auto* segment = std::get_if<Segment>(&feature.geometry)) {
    const Point along = segment->end - segment->begin;
    segment->begin += std::abs(uniform(random, 0.2)) * along;
    segment->end -= std::abs(uniform(random, 0.2)) * along;
  }
  return transformed(Pose2{uniform(random, 0.02), uniform(random, 0.02), uniform(random, 0.004)}, feature);
}

Drive random_drive(std::mt19937& random, int steps) {
  const std::vector<Feature> world = random_world(random);
  Drive drive;
  Pose2 truth, T_odom_base;
  for (int i = 0; i < steps; ++i) {
    const Pose2 step{0.4, uniform(random, 0.1), uniform(random, 0.2)};
    truth = i ? truth * step : truth;
    T_odom_base =
        i ? T_odom_base * step * Pose2{uniform(random, 0.02), uniform(random, 0.02), uniform(random, 0.02)} : truth;
    drive.T_odom_base.push_back(T_odom_base);
    auto& detected = drive.detected.emplace_back();
    for (const Feature& feature : world)
      if (uniform(random, 1) < 0.4) detected.push_back(noisy(random, transformed(truth.inverse(), feature)));
    drive.scans.emplace_back().stamp_s = 0.1 * i;
  }
  return drive;
}

LocalMap replay(const Drive& drive, const Pose2& T_new_odom, LocalMapOptions options) {
  LocalMap map(options, nullptr);
  for (std::size_t i = 0; i < drive.scans.size(); ++i)
    map.add(sample_of(drive.scans[i], T_new_odom * drive.T_odom_base[i], kT_base_laser), drive.detected[i]);
  return map;
}

double apart_m(const LocalFeature& a, const LocalFeature& b) {
  return (anchor_of(a.feature.geometry) - anchor_of(b.feature.geometry)).norm();
}

/// The feature of this type nearest to another one, taken out of `features`; nothing: there is none of this type.
std::optional<LocalFeature> take_counterpart(const LocalFeature& other, std::vector<LocalFeature>& features) {
  auto nearest = features.end();
  for (auto it = features.begin(); it != features.end(); ++it)
    if (it->feature.type == other.feature.type &&
        (nearest == features.end() || apart_m(*it, other) < apart_m(*nearest, other)))
      nearest = it;
  if (nearest == features.end()) return std::nullopt;
  const LocalFeature taken = *nearest;
  features.erase(nearest);
  return taken;
}

void check_same(const LocalMap& a, const LocalMap& b) {
  // The solver stops where a step gains nothing, which depends on the order of its sums.
  CHECK(distance_m(a.T_local_base(), b.T_local_base()) < 3e-3);
  CHECK(angle_between_rad(a.T_local_base(), b.T_local_base()) < 1e-3);
  std::vector<LocalFeature> in_b = b.features();
  REQUIRE(a.features().size() == in_b.size());
  for (const LocalFeature& feature : a.features()) {
    CAPTURE(feature.id, feature.feature.type);
    const auto same = take_counterpart(feature, in_b);
    REQUIRE(same);
    CHECK(feature.measurements.size() == same->measurements.size());
    CHECK(feature.stable == same->stable);
    CHECK(apart_m(feature, *same) < 1e-2);
  }
}

LocalMapOptions options_of(int optimize_every) {
  LocalMapOptions options;
  options.optimize_every = optimize_every;
  return options;
}

}  // namespace

TEST_CASE("the local map does not depend on where the odometry frame lies") {
  const int seed = GENERATE(range(1, 16));
  const LocalMapOptions options = options_of(GENERATE(0, 3));
  std::mt19937 random(static_cast<unsigned>(seed));
  CAPTURE(seed, options.optimize_every);
  const Drive drive = random_drive(random, 25);
  const Pose2 T_new_odom{uniform(random, 1000), uniform(random, 1000), uniform(random, 3)};
  check_same(replay(drive, Pose2(), options), replay(drive, T_new_odom, options));
}

TEST_CASE("the order of the detected features changes nothing but ids") {
  const int seed = GENERATE(range(1, 16));
  const LocalMapOptions options = options_of(GENERATE(0, 3));
  std::mt19937 random(static_cast<unsigned>(seed));
  CAPTURE(seed, options.optimize_every);
  const Drive drive = random_drive(random, 25);
  Drive shuffled = drive;
  for (auto& detected : shuffled.detected) std::shuffle(detected.begin(), detected.end(), random);
  check_same(replay(drive, Pose2(), options), replay(shuffled, Pose2(), options));
}

TEST_CASE("an empty scan within the horizon changes nothing but the pose") {
  std::mt19937 random(5);
  const Drive drive = random_drive(random, 8);
  LocalMap map = replay(drive, Pose2(), options_of(0));
  const std::vector<LocalFeature> before = map.features();
  const Pose2 T_local_base = map.T_local_base();
  const Pose2 step(0.1, 0, 0.02);
  map.add(sample_of({}, drive.T_odom_base.back() * step, kT_base_laser), {});
  CHECK(distance_m(map.T_local_base(), T_local_base * step) < 1e-9);
  CHECK(map.last_associations().empty());
  REQUIRE(map.features().size() == before.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    CHECK(map.features()[i].id == before[i].id);
    CHECK(map.features()[i].measurements.size() == before[i].measurements.size());
    CHECK(anchor_of(map.features()[i].feature.geometry) == anchor_of(before[i].feature.geometry));
  }
}

TEST_CASE("every association names a local feature that holds the measurement") {
  std::mt19937 random(6);
  const Drive drive = random_drive(random, 40);
  LocalMap map({}, nullptr);
  LocalFeatureId newest_id;
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    map.add(sample_of(drive.scans[i], drive.T_odom_base[i], kT_base_laser), drive.detected[i]);
    REQUIRE(map.last_associations().size() == drive.detected[i].size());
    for (std::size_t k = 0; k < drive.detected[i].size(); ++k) {
      const LocalFeatureId id = map.last_associations()[k];
      const auto found = std::find_if(map.features().begin(), map.features().end(),
                                      [&](const LocalFeature& local) { return local.id == id; });
      CAPTURE(i, k, id);
      REQUIRE(found != map.features().end());
      CHECK(found->measurements.back().keyframe == map.keyframes().back().id);
      CHECK(found->feature.type == drive.detected[i][k].type);
    }
    for (std::size_t k = 1; k < map.features().size(); ++k) CHECK(map.features()[k - 1].id < map.features()[k].id);
    const LocalFeatureId last_id = map.features().empty() ? LocalFeatureId() : map.features().back().id;
    if (last_id > newest_id) newest_id = last_id;
    CHECK(map.keyframes().back().driven_m - map.keyframes().front().driven_m <= LocalMapOptions().horizon_m);
  }
}

TEST_CASE("features stay finite and covariances positive whatever is detected") {
  std::mt19937 random(9);
  LocalMap map({}, nullptr);
  for (int i = 0; i < 100; ++i) {
    std::vector<Feature> detected;
    for (int k = 0; k < 8; ++k) {
      const Point a{uniform(random, 2), uniform(random, 2)};
      detected.push_back({"opal:Wall", Segment{a, a + Point{uniform(random, 1), uniform(random, 1)}}, {}, {}, 0});
      detected.back().covariance.setZero();
      detected.push_back({"opal:Pillar", Circle{Point{uniform(random, 2), uniform(random, 2)}, 0.2}, {}, {}, 0});
      detected.back().covariance.setConstant(uniform(random, 1));  // not even a covariance
    }
    map.add(sample_of({}, Pose2{0.1 * i, uniform(random, 0.1), uniform(random, 1)}), detected);
    for (const LocalFeature& local : map.features()) {
      REQUIRE(anchor_of(local.feature.geometry).allFinite());
      REQUIRE(local.feature.covariance.allFinite());
    }
    REQUIRE(map.T_local_base().position().allFinite());
  }
}
