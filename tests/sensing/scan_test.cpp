#include <opal/sensing/scan.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <limits>

namespace {

using namespace opal;

constexpr float kNanf = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

LaserModel five_beams() {
  LaserModel laser;
  laser.beams = 5;
  laser.angle_min_rad = -std::numbers::pi / 2;
  laser.angle_increment_rad = std::numbers::pi / 4;
  laser.range_min_m = 0.1;
  laser.range_max_m = 30;
  laser.no_return_m = 80;
  return laser;
}

RawScan reading(std::vector<float> ranges_m) {
  RawScan raw;
  raw.stamp_s = 7;
  raw.ranges_m = std::move(ranges_m);
  return raw;
}

std::vector<int> beams_of(const Scan& scan) {
  std::vector<int> beams;
  for (const ScanPoint& point : scan.points) beams.push_back(point.beam);
  return beams;
}

}  // namespace

TEST_CASE("a hit lies on its beam, in the sensor frame") {
  const Scan scan = make_scan(reading({1, 2, 3, 4, 5}), five_beams());
  REQUIRE(scan.points.size() == 5);
  CHECK(scan.stamp_s == 7);
  CHECK((scan.points[0].position - Point(0, -1)).norm() < 1e-9);
  CHECK((scan.points[2].position - Point(3, 0)).norm() < 1e-9);
  CHECK((scan.points[4].position - Point(0, 5)).norm() < 1e-9);
  CHECK(scan.points[3].range_m == 4);
  CHECK(scan.points[3].bearing_rad == Approx(std::numbers::pi / 4));
  CHECK(scan.invalid == 0);
}

TEST_CASE("NaN, zero, negative and too near readings are neither hit nor free") {
  const Scan scan = make_scan(reading({kNanf, 0, -1, 0.05f, -kInf}), five_beams());
  CHECK(scan.points.empty());
  CHECK(scan.free_bearings_rad.empty());
  CHECK(scan.invalid == 5);
}

TEST_CASE("no return, an infinite range, and a hit beyond the usable range leave the beam free") {
  const Scan scan = make_scan(reading({80, 81.91f, kInf, 30.5f, 30}), five_beams());
  CHECK(beams_of(scan) == std::vector<int>{4});  // the usable range itself still counts
  CHECK(scan.free_bearings_rad.size() == 4);
  CHECK(scan.range_max_m == 30);
  CHECK(scan.invalid == 0);
}

TEST_CASE("a scan of nothing but maximum ranges survives as free bearings") {
  const Scan scan = make_scan(reading(std::vector<float>(5, 81.91f)), five_beams());
  CHECK(scan.points.empty());
  CHECK(scan.free_bearings_rad.size() == 5);
}

TEST_CASE("a usable range beyond the no-return value ends there") {
  LaserModel laser = five_beams();
  laser.range_max_m = 100;
  const Scan scan = make_scan(reading({79, 80, 90, 1, 1}), laser);
  CHECK(scan.range_max_m == 80);
  CHECK(scan.points.size() == 3);
  CHECK(scan.free_bearings_rad.size() == 2);
}

TEST_CASE("beams that the model does not describe are counted as invalid, missing ones are missing") {
  const Scan longer = make_scan(reading(std::vector<float>(8, 1.0f)), five_beams());
  CHECK(longer.points.size() == 5);
  CHECK(longer.invalid == 3);
  const Scan shorter = make_scan(reading({1, 1}), five_beams());
  CHECK(shorter.points.size() == 2);
  CHECK(shorter.invalid == 0);
  const Scan none = make_scan(reading({}), five_beams());
  CHECK((none.points.empty() && none.free_bearings_rad.empty() && none.invalid == 0));
}

TEST_CASE("the log's beam geometry counts only if the model says so") {
  RawScan raw = reading(std::vector<float>(7, 2.0f));
  raw.angle_min_rad = 0.5;
  raw.angle_increment_rad = 0.1;
  LaserModel laser = five_beams();
  CHECK(make_scan(raw, laser).points.front().bearing_rad == Approx(laser.angle_min_rad));
  laser.geometry_from_log = true;
  const Scan scan = make_scan(raw, laser);
  REQUIRE(scan.points.size() == 7);
  CHECK(scan.points.front().bearing_rad == Approx(0.5));
  CHECK(scan.points.back().bearing_rad == Approx(1.1));
  CHECK(scan.angle_increment_rad == Approx(0.1));
  raw.angle_increment_rad.reset();
  CHECK(make_scan(raw, laser).points.size() == 5);
}

TEST_CASE("points come by increasing bearing, whichever beam the laser starts with and wherever it turns") {
  LaserModel laser = five_beams();
  laser.beams = 720;
  laser.angle_min_rad = GENERATE(-std::numbers::pi, -3.12414, 0.0, 1.0, 3.0);
  laser.angle_increment_rad = GENERATE(1, -1) * 2 * std::numbers::pi / 720;
  CAPTURE(laser.angle_min_rad, laser.angle_increment_rad);
  std::vector<float> ranges_m(720, 3.0f);
  for (std::size_t i = 0; i < ranges_m.size(); i += 3) ranges_m[i] = kInf;
  const Scan scan = make_scan(reading(ranges_m), laser);
  REQUIRE(scan.points.size() == 480);
  CHECK(scan.free_bearings_rad.size() == 240);
  CHECK(scan.angle_increment_rad > 0);
  CHECK(std::is_sorted(scan.free_bearings_rad.begin(), scan.free_bearings_rad.end()));
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const ScanPoint& point = scan.points[i];
    REQUIRE((point.bearing_rad >= -std::numbers::pi && point.bearing_rad < std::numbers::pi));
    REQUIRE((i == 0 || scan.points[i - 1].bearing_rad <= point.bearing_rad));
    const double beam_rad = laser.angle_min_rad + point.beam * laser.angle_increment_rad;
    REQUIRE((point.position - 3.0 * unit_vector(beam_rad)).norm() < 1e-9);
  }
}

TEST_CASE("a range that is written exactly at a limit keeps to it, though single precision rounds it") {
  // 5.6 and 0.7 are a little less in single precision, 8.1 a little more.
  LaserModel laser = five_beams();
  laser.no_return_m = 5.6;
  CHECK(make_scan(reading({5.6f, 5.6f, 5.5f, 1, 1}), laser).free_bearings_rad.size() == 2);
  laser = five_beams();
  laser.range_max_m = 8.1;
  CHECK(make_scan(reading({8.1f, 8.2f, 1, 1, 1}), laser).points.size() == 4);
  laser = five_beams();
  laser.range_min_m = 0.7;
  CHECK(make_scan(reading({0.7f, 0.6f, 1, 1, 1}), laser).invalid == 1);
}
