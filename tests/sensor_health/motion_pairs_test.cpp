// Motions of a laser whose scans a scripted matcher lays over each other.
#include "sensor_health/motion_pairs.hpp"

#include <catch2/catch.hpp>

#include <functional>

using namespace opal;

namespace {

/// Answers as a test tells it, and keeps what it was asked.
struct ScriptedMatcher : ScanMatcher {
  struct Question {
    Pose2 guess;
    Eigen::Vector3d sigma;
  };
  mutable std::vector<Question> asked;
  /// Share of the points that agree near a guess; the match is where it was guessed.
  std::function<double(const Pose2& guess)> inliers = [](const Pose2&) { return 1.0; };
  std::function<void(ScanMatch&)> change = [](ScanMatch&) {};

  ScanMatch match(std::span<const Point>, std::span<const Point>, const Pose2& guess,
                  const Eigen::Vector3d& sigma) const override {
    asked.push_back({guess, sigma});
    ScanMatch match{guess, 1e-4 * Eigen::Matrix3d::Identity(), inliers(guess), true};
    change(match);
    return match;
  }
};

Scan scan_at(double stamp_s, std::size_t points = 20) {
  Scan scan;
  scan.stamp_s = stamp_s;
  scan.points.resize(points);
  return scan;
}

struct Drive {
  std::shared_ptr<ScriptedMatcher> matcher = std::make_shared<ScriptedMatcher>();
  MotionPairs pairs;

  explicit Drive(const Pose2& T_base_laser = Pose2()) : pairs(matcher, T_base_laser) {}
  /// The one motion from the origin.
  std::optional<MotionPair> to(const Pose2& T_odom_base, double after_s = 0.1) {
    pairs.clear();
    pairs.add(scan_at(10), Pose2());
    matcher->asked.clear();
    return pairs.add(scan_at(10 + after_s), T_odom_base);
  }
};

bool is_near(const Pose2& a, const Pose2& b) { return distance_m(a, b) < 1e-9 && angle_between_rad(a, b) < 1e-9; }
/// A guess of no motion is where all motions are tried from.
bool is_any_way(const Pose2& guess) { return is_near(guess, Pose2()); }

}  // namespace

TEST_CASE("a motion ends after a quarter of a metre, a quarter of a radian or half a second") {
  Drive drive;
  CHECK_FALSE(drive.to({0.24, 0, 0}));
  CHECK_FALSE(drive.to({0, 0, 0.24}));
  CHECK_FALSE(drive.to({0.2, 0, 0}, 0.45));
  CHECK(drive.to({0, -0.26, 0}));
  CHECK(drive.to({0, 0, -0.26}));
  CHECK(drive.to({0.2, 0, 0}, 0.55));
}

TEST_CASE("a robot stands in a crowd if a search for any motion finds none, though most points are others") {
  const Pose2 stands, moves(0.3, 0, 0);
  for (const double inliers : {0.25, 0.45, 0.65}) {
    Drive drive;
    drive.matcher->inliers = [&](const Pose2&) { return inliers; };
    CHECK(drive.to(stands, 0.55).has_value() == (inliers > 0.3));
    CHECK(drive.to(moves).has_value() == (inliers > 0.6));
    drive.matcher->change = [](ScanMatch& match) { match.T_reference_scan = Pose2(0.05, 0, 0); };
    CHECK(drive.to(stands, 0.55).has_value() == (inliers > 0.6));
  }
}

TEST_CASE("a motion from end to end is odometry and scans, the laser's in its own frame") {
  const Pose2 T_base_laser(0.3, 0.1, 1), T_motion(0.3, 0.02, 0.2);
  Drive drive(T_base_laser);
  const auto pair = drive.to(T_motion);
  REQUIRE(pair);
  CHECK(is_near(pair->T_odometry, T_motion));
  CHECK(is_near(pair->T_scans, T_base_laser.inverse() * T_motion * T_base_laser));
  CHECK(pair->as_described);
}

TEST_CASE("a jump is no motion, and the next motion begins where it ended") {
  Drive drive;
  CHECK_FALSE(drive.to({1.1, 0, 0}));
  CHECK(is_near(drive.pairs.add(scan_at(11), Pose2(1.4, 0, 0))->T_odometry, {0.3, 0, 0}));
  CHECK_FALSE(drive.to({0, 0, 0.9}));
  CHECK(drive.to({0.9, 0, 0.7}));
}

TEST_CASE("scans of fewer than twenty points are passed by") {
  Drive drive;
  CHECK_FALSE(drive.pairs.add(scan_at(1, 19), Pose2()));
  drive.pairs.add(scan_at(1), Pose2(5, 0, 0));
  CHECK_FALSE(drive.pairs.add(scan_at(2, 19), Pose2(5.3, 0, 0)));
  CHECK(is_near(drive.pairs.add(scan_at(2), Pose2(5.4, 0, 0))->T_odometry, {0.4, 0, 0}));
}

TEST_CASE("so many motions as one skips are not looked at, unless it begins anew") {
  Drive drive;
  drive.to({0.3, 0, 0});
  drive.pairs.skip(2);
  drive.matcher->asked.clear();
  CHECK_FALSE(drive.pairs.add(scan_at(11), Pose2(0.6, 0, 0)));
  CHECK_FALSE(drive.pairs.add(scan_at(12), Pose2(0.9, 0, 0)));
  CHECK(drive.matcher->asked.empty());
  CHECK(is_near(drive.pairs.add(scan_at(13), Pose2(1.2, 0, 0))->T_odometry, {0.3, 0, 0}));
  CHECK(drive.pairs.add(scan_at(14), Pose2(1.5, 0, 0)));
  drive.pairs.skip(2);
  CHECK(drive.to({0.3, 0, 0}));
}

TEST_CASE("the described motion is looked for near by, and the more loosely the longer it was") {
  Drive drive;
  drive.to({0.5, 0, 0.3});
  REQUIRE_FALSE(drive.matcher->asked.empty());
  CHECK(is_near(drive.matcher->asked[0].guess, {0.5, 0, 0.3}));
  CHECK(drive.matcher->asked[0].sigma.isApprox(Eigen::Vector3d(0.08, 0.08, 0.06)));
}

TEST_CASE("all motions are tried about no motion, two thirds of what odometry has beyond a least") {
  Drive drive;
  drive.matcher->inliers = [](const Pose2&) { return 0.7; };
  drive.to({0, 0.6, -0.3});
  REQUIRE(drive.matcher->asked.size() > 1);
  CHECK(is_any_way(drive.matcher->asked[1].guess));
  CHECK(drive.matcher->asked[1].sigma.isApprox(Eigen::Vector3d(0.55, 0.55, 0.28)));
}

TEST_CASE("another motion is taken where the described one fits badly and the other one clearly better") {
  Drive drive;
  double described = 0.7, other = 0.95;
  drive.matcher->inliers = [&](const Pose2& guess) { return is_any_way(guess) ? other : described; };
  const auto taken = drive.to({0, 0, 0.3});
  REQUIRE(taken);
  CHECK_FALSE(taken->as_described);
  CHECK(is_any_way(taken->T_scans));
  other = 0.88;
  CHECK(drive.to({0, 0, 0.3})->as_described);
  described = 0.5;
  other = 0.68;
  CHECK_FALSE(drive.to({0, 0, 0.3}));
  described = 0.78;
  other = 1;
  CHECK_FALSE(drive.to({0, 0, 0.3})->as_described);
  described = 0.87;
  CHECK(drive.to({0, 0, 0.3})->as_described);
  CHECK(drive.matcher->asked.size() == 1);
}

TEST_CASE("scans that do not lie over each other are no motion") {
  Drive drive;
  drive.matcher->inliers = [](const Pose2&) { return 0.55; };
  CHECK_FALSE(drive.to({0.3, 0, 0}));
  drive.matcher->inliers = [](const Pose2&) { return 0.65; };
  CHECK(drive.to({0.3, 0, 0}));
  drive.matcher->change = [](ScanMatch& match) { match.converged = false; };
  CHECK_FALSE(drive.to({0.3, 0, 0}));
  drive.matcher->change = [](ScanMatch& match) { match.covariance(1, 1) = NAN; };
  CHECK_FALSE(drive.to({0.3, 0, 0}));
}

TEST_CASE("where the described motion cannot be found at all, another one is taken") {
  Drive drive;
  drive.matcher->inliers = [](const Pose2&) { return 0.9; };
  drive.matcher->change = [](ScanMatch& match) { match.converged = is_any_way(match.T_reference_scan); };
  const auto taken = drive.to({0, 0, 0.3});
  REQUIRE(taken);
  CHECK_FALSE(taken->as_described);
}

TEST_CASE("a robot that stands by odometry moved if another motion fits a little better") {
  Drive drive;
  double other = 0.95;
  drive.matcher->inliers = [&](const Pose2& guess) { return is_any_way(guess) ? other : 0.9; };
  drive.matcher->change = [&](ScanMatch& match) {
    if (drive.matcher->asked.size() > 1) match.T_reference_scan = Pose2(0.3, 0, 0);
  };
  const auto moved = drive.to({0.015, 0, 0.015}, 0.6);
  REQUIRE(moved);
  CHECK_FALSE(moved->as_described);
  CHECK(moved->T_scans.x() == 0.3);
  other = 0.92;
  CHECK(drive.to({0.015, 0, 0.015}, 0.6)->as_described);
  other = 0.95;
  CHECK(drive.to({0.025, 0, 0}, 0.6)->as_described);
  CHECK(drive.to({0, 0, 0.025}, 0.6)->as_described);
}

TEST_CASE("the way back is taken where more of the points lie over each other that way") {
  Drive drive;
  double back = 0.95;
  drive.matcher->inliers = [&](const Pose2& guess) { return guess.x() < 0 ? back : 0.9; };
  const auto taken = drive.to({0.3, 0.1, 0.2});
  REQUIRE(taken);
  CHECK_FALSE(taken->as_described);
  CHECK(is_near(taken->T_scans, {-0.3, -0.1, 0.2}));
  CHECK(taken->covariance(0, 0) == Approx(1e-4));
  back = 0.85;
  const auto forwards = drive.to({0.3, 0.1, 0.2});
  CHECK(forwards->as_described);
  CHECK(forwards->covariance(0, 0) == Approx(1e-4));
}

TEST_CASE("where scans lie over each other either way, nothing tells how far the laser went along it") {
  Drive drive;
  const double back = GENERATE(0.88, 0.92);
  drive.matcher->inliers = [&](const Pose2& guess) { return guess.x() < 0 ? back : 0.9; };
  const auto pair = drive.to({0.3, 0, 0.1});
  REQUIRE(pair);
  CHECK(pair->as_described);
  CHECK(pair->covariance(0, 0) == Approx(1e-4 + 100 * 0.09));
  CHECK(pair->covariance(1, 1) == Approx(1e-4));
  const auto near_by = drive.to({0.09, 0, 0.3});  // too short a way to tell
  CHECK(near_by->covariance(0, 0) == Approx(1e-4));
}

TEST_CASE("both ways that lead to one place are one way") {
  Drive drive;
  drive.matcher->change = [](ScanMatch& match) { match.T_reference_scan = Pose2(0.25, 0, 0); };
  const auto pair = drive.to({0.3, 0, 0});
  REQUIRE(pair);
  CHECK(pair->as_described);
  CHECK(pair->covariance(0, 0) == Approx(1e-4));
}

TEST_CASE("a robot that stands by its odometry is looked at, though motions are passed by") {
  Drive drive;
  drive.pairs.skip(2);
  drive.pairs.add(scan_at(10), Pose2());
  CHECK(drive.pairs.add(scan_at(10.6), Pose2()));
  CHECK(drive.pairs.add(scan_at(11.2), Pose2()));
  CHECK_FALSE(drive.pairs.add(scan_at(11.3), Pose2(0.3, 0, 0)));
  CHECK_FALSE(drive.pairs.add(scan_at(11.4), Pose2(0.6, 0, 0)));
  CHECK(drive.pairs.add(scan_at(11.5), Pose2(0.9, 0, 0)));
}
