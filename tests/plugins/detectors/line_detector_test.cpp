#include "synthetic_scan.hpp"

#include "plugins/lines/detector.hpp"

#include <Eigen/LU>
#include <catch2/catch.hpp>

namespace {

using namespace opal;
using namespace opal::test;

std::vector<Feature> walls_in(const Scan& scan) { return lines::LineDetector({}).detect(scan); }
const Segment& segment(const Feature& feature) { return std::get<Segment>(feature.geometry); }

}  // namespace

TEST_CASE("a wall ahead is one segment with the sensor on its left") {
  const auto walls = walls_in(scan_of({{{{2, -1.5}, {2, 1.5}}}, {}}, Scanner{}));
  REQUIRE(walls.size() == 1);
  CHECK(walls[0].type == "opal:Wall");
  CHECK(segment(walls[0]).begin.isApprox(Point(2, -1.5), 0.02));
  CHECK(segment(walls[0]).end.isApprox(Point(2, 1.5), 0.02));
  CHECK(segment(walls[0]).normal().x() == Approx(-1));
  CHECK(walls[0].support_m == Approx(3).margin(0.05));
  CHECK(walls[0].true_end == std::array{true, true});
}

TEST_CASE("a wall behind a pillar stays one wall, and its support leaves out what is hidden") {
  const Scene scene{{{{4, -3}, {4, 3}}, {{2, -0.3}, {2, 0.3}}}, {}};
  const auto walls = walls_in(scan_of(scene, Scanner{}));
  REQUIRE(walls.size() == 2);
  const Feature& wall = segment(walls[0]).length_m() > 1 ? walls[0] : walls[1];
  CHECK(segment(wall).length_m() == Approx(6).margin(0.1));
  CHECK(wall.support_m == Approx(4.8).margin(0.15));
  CHECK(wall.true_end == std::array{true, true});
}

TEST_CASE("an end behind something nearer is not a true end, and neither is the edge of the view") {
  const Scene scene{{{{4, -60}, {4, 3}}, {{2, 0.5}, {2, 3}}}, {}};
  Scanner narrow;
  narrow.angle_min_rad = -0.5;
  narrow.beams = 241;
  for (const Feature& wall : walls_in(scan_of(scene, narrow))) {
    const bool far = segment(wall).begin.x() > 3;
    CAPTURE(segment(wall).begin.transpose(), segment(wall).end.transpose());
    CHECK(wall.true_end == (far ? std::array{false, false} : std::array{true, true}));
  }
}

TEST_CASE("a wide doorway that is seen through ends both walls, a narrow slit does not") {
  const auto with_gap = [](double gap) {
    return walls_in(scan_of({{{{3, -3}, {3, -gap / 2}}, {{3, gap / 2}, {3, 3}}}, {}}, Scanner{}));
  };
  const auto doorway = with_gap(0.9);
  REQUIRE(doorway.size() == 2);
  CHECK(doorway[0].true_end[1]);
  CHECK(doorway[1].true_end[0]);
  CHECK(with_gap(0.15).size() == 1);
}

TEST_CASE("chair legs in front of a wall do not cut it") {
  Scene scene{{{{3, -3}, {3, 3}}}, {}};
  for (double y = -1; y <= 1; y += 0.5) scene.columns.push_back({{1.5, y}, 0.015});
  const auto walls = walls_in(scan_of(scene, Scanner{}));
  REQUIRE(walls.size() == 1);
  CHECK(segment(walls[0]).length_m() == Approx(6).margin(0.1));
}

TEST_CASE("walls of a room meet: both ends are true and lie on the corner") {
  const Scene room{outline({{-2, -3}, {5, -3}, {5, 2}, {-2, 2}}), {}};
  const auto walls = walls_in(scan_of(room, all_around()));
  REQUIRE(walls.size() == 4);
  for (const Feature& wall : walls) {
    CAPTURE(segment(wall).begin.transpose(), segment(wall).end.transpose());
    CHECK(wall.true_end == std::array{true, true});
    double nearest = 1;
    for (const Segment& side : room.walls) nearest = std::min(nearest, (side.begin - segment(wall).begin).norm());
    CHECK(nearest < 1e-3);
  }
}

TEST_CASE("round columns are not walls") {
  for (double range : {1.0, 1.5, 2.0, 3.0}) {
    CAPTURE(range);
    std::mt19937 random(3);
    Scanner scanner;
    scanner.sigma_m = 0.005;
    CHECK(walls_in(scan_of({{}, {{{range, 0.4}, 0.3}}}, scanner, random)).empty());
  }
}

TEST_CASE("the fit is unbiased and its covariance is the truth") {
  std::mt19937 random(GENERATE(1, 2, 3));
  const double heading = GENERATE(-1.0, 0.0, 0.7);
  const Pose2 T(3, 0.5, heading);
  const Segment truth = transformed(T, Segment{{0, -2}, {0, 2}});
  const Point normal = truth.normal();
  Scanner scanner;
  scanner.sigma_m = 0.02;
  LineExtractionOptions options;
  options.noise = {.range_sigma_m = 0.02, .bearing_sigma_rad = 0, .surface_sigma_m = 0};
  const lines::LineDetector detector(options);
  constexpr int kScans = 150;
  double mean_offset = 0;
  double mean_nees = 0;
  for (int i = 0; i < kScans; ++i) {
    const auto walls = detector.detect(scan_of({{truth}, {}}, scanner, random));
    REQUIRE(walls.size() == 1);
    const Segment& wall = segment(walls[0]);
    const Eigen::Vector2d error(normal.dot(wall.midpoint() - truth.begin),
                                wrap_angle(wall.heading_rad() - truth.heading_rad()));
    mean_offset += error.x() / kScans;
    mean_nees += error.dot(walls[0].covariance.topLeftCorner<2, 2>().inverse() * error) / kScans;
  }
  CAPTURE(heading);
  CHECK(std::abs(mean_offset) < 0.005);
  CHECK(mean_nees > 1.4);  // two degrees of freedom; its standard error is 0.16
  CHECK(mean_nees < 2.6);
}
