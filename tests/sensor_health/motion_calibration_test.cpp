#include "sensor_health/motion_calibration.hpp"

#include <catch2/catch.hpp>

#include <random>

using namespace opal;

namespace {

struct Robot {
  Pose2 T_base_laser;
  double distance_scale = 1, turn_scale = 1;
  bool mirrored = false;
};

/// Motions of a robot that drives curves, with a centimetre of noise; `gone_wrong` of them are nonsense.
std::vector<MotionPair> drive(const Robot& robot, std::uint32_t seed, int motions = 60, double gone_wrong = 0) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise_m(0, 0.01), noise_rad(0, 0.005);
  std::uniform_real_distribution<double> step_m(0.1, 0.3), turn_rad(-0.3, 0.3), share(0, 1);
  std::vector<MotionPair> pairs;
  for (int k = 0; k < motions; ++k) {
    const Pose2 T_true{step_m(random), 0, turn_rad(random)};
    Pose2 T_laser = robot.T_base_laser.inverse() * T_true * robot.T_base_laser;
    T_laser =
        Pose2{T_laser.x() + noise_m(random), T_laser.y() + noise_m(random), T_laser.heading_rad() + noise_rad(random)};
    if (robot.mirrored) T_laser = Pose2(T_laser.x(), -T_laser.y(), -T_laser.heading_rad());
    if (share(random) < gone_wrong) T_laser = Pose2{turn_rad(random), turn_rad(random), turn_rad(random)};
    MotionPair pair;
    pair.T_odometry = Pose2(T_true.position() / robot.distance_scale, T_true.heading_rad() / robot.turn_scale);
    pair.T_scans = T_laser;
    pair.covariance = Eigen::Vector3d(1e-4, 1e-4, 2.5e-5).asDiagonal();
    pairs.push_back(pair);
  }
  return pairs;
}

void expect(const MotionCalibration& found, const Robot& robot, double scale_margin = 0.03) {
  INFO("heading " << found.mount_heading_rad.value << " +- " << found.mount_heading_rad.sigma << ", position "
                  << found.mount_position_m.transpose() << " +- " << found.mount_position_sigma_m << ", scales "
                  << found.distance_scale.value << ", " << found.turn_scale.value);
  CHECK(std::abs(wrap_angle(found.mount_heading_rad.value - robot.T_base_laser.heading_rad())) < 0.03);
  CHECK((found.mount_position_m - robot.T_base_laser.position()).norm() < 0.05);
  CHECK(found.distance_scale.value == Approx(robot.distance_scale).margin(scale_margin));
  CHECK(found.turn_scale.value == Approx((robot.mirrored ? -1 : 1) * robot.turn_scale).margin(scale_margin));
}

/// Motions of a robot that drives so far and turns so much each time, seen without an error.
std::vector<MotionPair> exact(const Pose2& T_motion, const Pose2& T_base_laser, int motions) {
  MotionPair pair;
  pair.T_odometry = T_motion;
  pair.T_scans = T_base_laser.inverse() * T_motion * T_base_laser;
  pair.covariance *= 1e-4;
  return std::vector<MotionPair>(static_cast<std::size_t>(motions), pair);
}

}  // namespace

TEST_CASE("mount and scales are found from motions, wherever the laser sits") {
  const auto robot =
      GENERATE(Robot{{0, 0, 0}}, Robot{{0.3, -0.1, 0.2}}, Robot{{-0.2, 0, std::numbers::pi}},
               Robot{{0.1, 0.2, -1.5}, 1.2, 0.9}, Robot{{0.2, 0, 0}, 0.6, 1.4}, Robot{{0.2, 0.1, 0.1}, 1, 1, true});
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    const auto found = calibrate_motion(drive(robot, seed), Pose2());
    REQUIRE(found);
    expect(*found, robot);
  }
}

TEST_CASE("a fifth of the motions may have gone wrong") {
  const Robot robot{{0.3, 0, 0.5}};
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    const auto found = calibrate_motion(drive(robot, seed, 100, 0.2), Pose2());
    REQUIRE(found);
    expect(*found, robot, 0.08);
  }
}

TEST_CASE("the order of the motions does not matter") {
  auto pairs = drive(Robot{{0.3, 0, 0.5}}, 1);
  const auto there = calibrate_motion(pairs, Pose2());
  std::reverse(pairs.begin(), pairs.end());
  const auto back = calibrate_motion(pairs, Pose2());
  CHECK(there->mount_heading_rad.value == Approx(back->mount_heading_rad.value).margin(1e-9));
  CHECK(there->distance_scale.value == Approx(back->distance_scale.value).margin(1e-9));
}

TEST_CASE("the uncertainty covers the error") {
  const Robot robot{{0.3, -0.1, 0.2}};
  int within = 0;
  for (std::uint32_t seed = 1; seed <= 50; ++seed) {
    const auto found = calibrate_motion(drive(robot, seed, 20), Pose2());
    within += std::abs(found->mount_heading_rad.value - 0.2) < 2 * found->mount_heading_rad.sigma;
  }
  CHECK(within >= 45);
}

TEST_CASE("a drive straight ahead says nothing of where the laser sits") {
  std::vector<MotionPair> pairs(20);
  for (MotionPair& pair : pairs) {
    pair.T_odometry = pair.T_scans = Pose2(0.2, 0, 0);
    pair.covariance *= 1e-4;
  }
  const auto found = calibrate_motion(pairs, Pose2(0.4, 0.1, 0));
  REQUIRE(found);
  CHECK(found->mount_position_sigma_m > 0.5);
  CHECK(found->mount_heading_rad.sigma < 0.05);
  CHECK_FALSE(calibrate_motion({}, Pose2()));
}

TEST_CASE("a calibration counts its motions, and what odometry has of them") {
  auto pairs = exact(Pose2(0.2, 0, 0.1), Pose2(), 3);
  CHECK_FALSE(calibrate_motion(std::span(pairs).first(2), Pose2()));
  pairs.push_back({Pose2(-0.3, 0.4, -0.2), Pose2(-0.3, 0.4, -0.2)});
  const auto found = calibrate_motion(pairs, Pose2());
  REQUIRE(found);
  CHECK(found->pairs == 4);
  CHECK(found->driven_m == Approx(1.1));
  CHECK(found->turned_rad == Approx(0.5));
}

TEST_CASE("scales and heading are known as well as the motions are, and better the more there are of them") {
  const int motions = GENERATE(9, 36);
  const auto found = calibrate_motion(exact(Pose2(0.4, 0, 0), Pose2(), motions), Pose2());
  // A motion of 0.4 m is known to 0.01 m by the scans, and to 0.02 m and a tenth of it by odometry.
  const double sigma_m = std::sqrt(0.01 * 0.01 + 0.02 * 0.02 + 0.04 * 0.04);
  CHECK(found->distance_scale.sigma == Approx(sigma_m / 0.4 / std::sqrt(motions)).epsilon(1e-3));
  CHECK(found->mount_heading_rad.sigma == Approx(sigma_m / 0.4 / std::sqrt(motions)).epsilon(1e-3));
  const auto turned = calibrate_motion(exact(Pose2(0, 0, 0.2), Pose2(), motions), Pose2());
  const double sigma_rad = std::sqrt(0.01 * 0.01 + 0.02 * 0.02 + 0.02 * 0.02);
  CHECK(turned->turn_scale.sigma == Approx(sigma_rad / 0.2 / std::sqrt(motions)).epsilon(1e-3));
}

TEST_CASE("motions that scatter more than they should make the estimates as much less certain") {
  auto scattered = exact(Pose2(0.4, 0, 0), Pose2(), 20);
  const double usual = calibrate_motion(scattered, Pose2())->distance_scale.sigma;
  for (std::size_t k = 0; k < scattered.size(); ++k)
    scattered[k].T_scans = Pose2(k % 2 == 0 ? 0.6 : 0.2, 0, 0);  // 0.2 m off, and 0.046 are usual
  const double more = calibrate_motion(scattered, Pose2())->distance_scale.sigma;
  // All are 4.36 standard deviations off, where half of pairs of normal numbers are 1.177; beyond 1.5 their weight
  // falls.
  const double off = 0.2 / std::sqrt(0.01 * 0.01 + 0.02 * 0.02 + 0.04 * 0.04);
  CHECK(more / usual == Approx(off / 1.177 * std::sqrt(off / 1.5)).epsilon(0.01));
}

TEST_CASE("what a drive says nothing of stays as it is described") {
  const Pose2 described(0.4, 0.1, 0.5);
  const auto found = calibrate_motion(exact(Pose2(0.2, 0, 0), described, 20), described);
  CHECK((found->mount_position_m - described.position()).norm() < 1e-6);
  CHECK(found->mount_position_sigma_m == Approx(1).epsilon(0.01));
}

TEST_CASE("motions speak against a description that is wrong, and none against one that is right") {
  const Pose2 mount(0.3, 0.1, 0.5);
  auto pairs = exact(Pose2(0.3, 0, 0.2), mount, 10);
  const auto right = calibrate_motion(pairs, mount), wrong = calibrate_motion(pairs, Pose2());
  CHECK(right->distances_better == 0);
  CHECK(wrong->distances_better == 1);
  CHECK(wrong->turns_better < 0.5);
  for (MotionPair& pair : pairs) pair.T_odometry = Pose2(pair.T_odometry.position(), 0.1);
  CHECK(calibrate_motion(pairs, mount)->turns_better == 1);
  for (const double turn_rad : {0.0, 0.04}) {  // too small a turn tells nothing of a scale
    for (MotionPair& pair : pairs) pair.T_odometry = Pose2(pair.T_odometry.position(), turn_rad);
    CHECK(calibrate_motion(pairs, mount)->turns_better == 0);
  }
}

TEST_CASE("two motions are no calibration, three are") {
  const std::vector<MotionPair> motions = drive({{0.3, 0, 0.5}}, 1, 3);
  CHECK_FALSE(calibrate_motion(std::span(motions).first(2), Pose2()));
  CHECK(calibrate_motion(motions, Pose2()));
}

TEST_CASE("motions that are too short tell nothing of a mount") {
  const auto pairs = exact(Pose2(0.08, 0, 0.2), Pose2(0, 0, 3), 10);
  CHECK(calibrate_motion(pairs, Pose2())->distances_better == 0);
}
