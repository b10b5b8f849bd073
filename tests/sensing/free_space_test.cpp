#include <opal/sensing/free_space.hpp>

#include <catch2/catch.hpp>

using namespace opal;

namespace {

double area_m2(const std::vector<Point>& outline) {
  double twice = 0;
  for (std::size_t k = 0; k < outline.size(); ++k) twice += cross(outline[k], outline[(k + 1) % outline.size()]);
  return twice / 2;
}

/// A laser in the middle of a round room, beams between two bearings.
Scan round_room(double radius_m, double from_rad, double to_rad, int beams) {
  Scan scan;
  scan.range_max_m = 30;
  for (int k = 0; k < beams; ++k) {
    const double bearing = from_rad + (to_rad - from_rad) * k / (beams - 1);
    scan.points.push_back({radius_m * unit_vector(bearing), radius_m, bearing, k});
  }
  return scan;
}

}  // namespace

TEST_CASE("free space reaches from the laser to where its beams end") {
  const Scan half = round_room(4, -std::numbers::pi / 2, std::numbers::pi / 2, 361);
  const auto outline = free_space_outline(half, Pose2());
  CHECK(area_m2(outline) == Approx(0.5 * std::numbers::pi * 16).epsilon(0.02));
  CHECK(outline.size() < 60);  // simplified
  CHECK(std::count(outline.begin(), outline.end(), Point(0, 0)) == 1);
}

TEST_CASE("free space of a laser that sees all round does not run through the laser") {
  const Scan full = round_room(4, -std::numbers::pi, std::numbers::pi - 0.01, 629);
  const auto outline = free_space_outline(full, Pose2());
  CHECK(area_m2(outline) == Approx(std::numbers::pi * 16).epsilon(0.02));
  CHECK(std::count(outline.begin(), outline.end(), Point(0, 0)) == 0);
}

TEST_CASE("beams that met nothing are free as far as is asked, and missing beams leave a gap") {
  Scan scan;
  scan.range_max_m = 30;
  for (double bearing = -0.5; bearing <= -0.1; bearing += 0.01) scan.free_bearings_rad.push_back(bearing);
  for (double bearing = 0.1; bearing <= 0.5; bearing += 0.01) scan.free_bearings_rad.push_back(bearing);
  FreeSpaceOptions options;
  options.reach_m = 5;
  CHECK(area_m2(free_space_outline(scan, Pose2(), options)) == Approx(0.8 * 0.5 * 25).epsilon(0.04));
}

TEST_CASE("free space moves with the laser's mount") {
  const Scan scan = round_room(3, -1, 1, 100);
  const Pose2 T_base_laser(0.3, -0.2, 2);
  const auto at_laser = free_space_outline(scan, Pose2()), at_base = free_space_outline(scan, T_base_laser);
  REQUIRE(at_laser.size() == at_base.size());
  for (std::size_t k = 0; k < at_base.size(); ++k) CHECK((T_base_laser * at_laser[k] - at_base[k]).norm() < 1e-12);
}

TEST_CASE("a scan with hardly a beam has no free space") {
  CHECK(free_space_outline(Scan(), Pose2()).empty());
  Scan one = round_room(3, 0, 1, 2);
  one.points.resize(1);
  CHECK(free_space_outline(one, Pose2()).empty());
}

TEST_CASE("two neighbouring beams have a triangle between them") {
  const auto outline = free_space_outline(round_room(4, 0.2, 0.24, 2), Pose2());
  CHECK(outline.size() == 3);
  CHECK(area_m2(outline) == Approx(0.5 * 16 * std::sin(0.04)));
}
