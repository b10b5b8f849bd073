#include "synthetic_scan.hpp"

#include "plugins/boxes/detector.hpp"
#include "plugins/circles/detector.hpp"
#include "plugins/corners/detector.hpp"

#include <Eigen/LU>
#include <catch2/catch.hpp>

namespace {

using namespace opal;
using namespace opal::test;

constexpr double kPi = std::numbers::pi;

std::vector<Feature> corners_in(const Scan& scan) { return corners::CornerDetector({}).detect(scan); }
std::vector<Feature> columns_in(const Scan& scan) { return circles::CircleDetector({}).detect(scan); }
std::vector<Feature> pillars_in(const Scan& scan) { return boxes::BoxDetector({}).detect(scan); }
const OrientedPoint& corner(const Feature& feature) { return std::get<OrientedPoint>(feature.geometry); }
const Circle& circle(const Feature& feature) { return std::get<Circle>(feature.geometry); }

std::vector<Segment> square(const Pose2& T, double side) {
  const double h = side / 2;
  return outline({T * Point(-h, -h), T * Point(h, -h), T * Point(h, h), T * Point(-h, h)});
}

}  // namespace

TEST_CASE("a corner of a room is concave and heads to the middle of what is open") {
  const auto found = corners_in(scan_of({{{{3, -2}, {3, 1}}, {{3, 1}, {0, 1}}}, {}}, Scanner{}));
  REQUIRE(found.size() == 1);
  CHECK(found[0].type == "opal:Corner");
  CHECK(corner(found[0]).position.isApprox(Point(3, 1), 1e-3));
  CHECK(corner(found[0]).opening_rad == Approx(kPi / 2).margin(1e-3));
  CHECK(corner(found[0]).heading_rad == Approx(-3 * kPi / 4).margin(1e-3));
}

TEST_CASE("a protruding corner is convex and heads away from the wall") {
  const auto found = corners_in(scan_of({{{{3, -2}, {1.5, -0.5}}, {{1.5, -0.5}, {3, 1}}}, {}}, Scanner{}));
  REQUIRE(found.size() == 1);
  CHECK(corner(found[0]).position.isApprox(Point(1.5, -0.5), 1e-3));
  CHECK(corner(found[0]).opening_rad == Approx(3 * kPi / 2).margin(1e-3));
  CHECK(std::abs(wrap_angle(corner(found[0]).heading_rad - kPi)) < 1e-3);
}

TEST_CASE("one wall that hides another makes no corner") {
  CHECK(corners_in(scan_of({{{{2, -2}, {2, 0}}, {{4, -1}, {4, 3}}}, {}}, Scanner{})).empty());
}

TEST_CASE("a rounded edge is no corner") { CHECK(corners_in(scan_of({{}, {{{2, 0}, 0.6}}}, Scanner{})).empty()); }

TEST_CASE("a corner's error agrees with its covariance") {
  std::mt19937 random(GENERATE(5, 6));
  const double turn = GENERATE(-0.4, 0.0, 0.5);
  const Pose2 T(3, 0.3, turn);
  const Scene scene{{{T * Point(-0.3, -2), T * Point(0, 0)}, {T * Point(0, 0), T * Point(-1, 1.3)}}, {}};
  Scanner scanner;
  scanner.sigma_m = 0.02;
  const auto exact = corners_in(scan_of(scene, Scanner{}));
  REQUIRE(exact.size() == 1);
  Point mean = Point::Zero();
  double nees = 0;
  int found_in = 0;
  for (int i = 0; i < 200; ++i) {
    const auto found = corners_in(scan_of(scene, scanner, random));
    if (found.size() != 1) continue;
    const Point miss = corner(found[0]).position - T.position();
    const Eigen::Vector3d error(miss.x(), miss.y(),
                                wrap_angle(corner(found[0]).heading_rad - corner(exact[0]).heading_rad));
    nees += error.dot(found[0].covariance.inverse() * error);
    mean += miss;
    ++found_in;
  }
  CAPTURE(turn, found_in);
  REQUIRE(found_in > 180);
  CHECK((mean / found_in).norm() < 0.005);
  CHECK(nees / found_in > 1.5);  // three degrees of freedom
  CHECK(nees / found_in < 4.5);
}

TEST_CASE("columns are found with their radius, near and far") {
  const double range = GENERATE(1.0, 2.5, 4.0, 8.0);
  const double radius = GENERATE(0.15, 0.3, 0.45);
  std::mt19937 random(11);
  Scanner scanner;
  scanner.sigma_m = 0.01;
  const Scene scene{{{{12, -20}, {12, 20}}}, {{{range * std::cos(0.3), range * std::sin(0.3)}, radius}}};
  const double beams = 2 * std::asin(std::min(0.9, radius / range)) / scanner.angle_increment_rad;
  if (beams < 9) return;
  CAPTURE(range, radius, beams);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  double nees = 0;
  int found_in = 0;
  for (int i = 0; i < 100; ++i) {
    const auto found = columns_in(scan_of(scene, scanner, random));
    if (found.size() != 1) continue;
    Eigen::Vector3d error;
    error << circle(found[0]).center - scene.columns[0].center, circle(found[0]).radius_m - radius;
    mean += error;
    nees += error.dot(found[0].covariance.inverse() * error);
    ++found_in;
  }
  CAPTURE(found_in, (mean / found_in).transpose());
  REQUIRE(found_in >= 85);
  CHECK(std::abs(mean.z() / found_in) < 0.01);
  CHECK(nees / found_in < 4.5);  // three degrees of freedom
}

TEST_CASE("square pillars, boards, legs and columns that are half hidden are no round columns") {
  std::mt19937 random(7);
  Scanner scanner;
  scanner.sigma_m = 0.01;
  const std::vector<Scene> scenes{{square({3, 0, 0.5}, 0.5), {}},
                                  {square({3, 0, 0.0}, 0.5), {}},
                                  {{{{3, -0.3}, {3, 0.3}}}, {}},
                                  {{}, {{{2, 0}, 0.04}}},
                                  {{{{1.5, -0.6}, {1.5, 0}}}, {{{3, 0}, 0.3}}},
                                  {outline({{-1, -2}, {4, -2}, {4, 2}, {-1, 2}}), {}}};
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    CAPTURE(i);
    for (int k = 0; k < 20; ++k) CHECK(columns_in(scan_of(scenes[i], scanner, random)).empty());
  }
}

TEST_CASE("a free-standing square pillar shows its near edge") {
  const Scene scene{square({3, 0.5, kPi / 4}, 0.6), {}};
  const auto found = pillars_in(scan_of(scene, Scanner{}));
  REQUIRE(found.size() == 1);
  CHECK(found[0].type == "opal:PillarCorner");
  CHECK(corner(found[0]).position.isApprox(Point(3 - 0.3 * std::sqrt(2.0), 0.5), 0.01));
  CHECK(corner(found[0]).opening_rad == Approx(3 * kPi / 2).margin(0.02));
}

TEST_CASE("corners of walls, half hidden pillars and pillars at a wall are no free-standing pillars") {
  Scene hidden{square({3, 0, kPi / 4}, 0.6), {}};
  hidden.walls.push_back({{1.5, 0.1}, {1.5, 1}});
  Scene attached{square({3, 0, kPi / 4}, 0.6), {}};
  attached.walls.push_back({{3, 0.2}, {3, 3}});
  const Scene room{outline({{-2, -3}, {6, -3}, {6, 3}, {2, 3}, {2, 1.5}, {-2, 1.5}}), {}};
  CHECK(pillars_in(scan_of(hidden, Scanner{})).empty());
  CHECK(pillars_in(scan_of(attached, Scanner{})).empty());
  CHECK(pillars_in(scan_of(room, all_around())).empty());
}
