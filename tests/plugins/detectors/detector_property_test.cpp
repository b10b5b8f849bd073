#include "synthetic_scan.hpp"

#include "plugins/boxes/detector.hpp"
#include "plugins/circles/detector.hpp"
#include "plugins/corners/detector.hpp"
#include "plugins/lines/detector.hpp"

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>

#include <memory>

namespace {

using namespace opal;
using namespace opal::test;

struct Named {
  const char* name;
  std::shared_ptr<const FeatureDetector> detector;
};

std::vector<Named> detectors() {
  return {{"lines", std::make_shared<lines::LineDetector>(LineExtractionOptions{})},
          {"corners", std::make_shared<corners::CornerDetector>(corners::CornerOptions{})},
          {"circles", std::make_shared<circles::CircleDetector>(circles::CircleOptions{})},
          {"boxes", std::make_shared<boxes::BoxDetector>(boxes::BoxOptions{})}};
}

/// Everything that has a length in a geometry, as points.
std::vector<Point> points_of(const Geometry& geometry) {
  if (const auto* segment = std::get_if<Segment>(&geometry)) return {segment->begin, segment->end};
  if (const auto* circle = std::get_if<Circle>(&geometry)) return {circle->center, {circle->radius_m, 0}};
  if (const auto* corner = std::get_if<OrientedPoint>(&geometry))
    return {corner->position, unit_vector(corner->heading_rad), {corner->opening_rad, 0}};
  return {std::get<Point>(geometry)};
}

bool same(const Feature& a, const Feature& b) {
  if (a.type != b.type || a.geometry.index() != b.geometry.index() || a.true_end != b.true_end) return false;
  const auto points_a = points_of(a.geometry);
  const auto points_b = points_of(b.geometry);
  for (std::size_t i = 0; i < points_a.size(); ++i)
    if ((points_a[i] - points_b[i]).norm() > 1e-5) return false;
  return (a.covariance - b.covariance).norm() <= 1e-4 * a.covariance.norm() + 1e-12;
}

/// Same features in any order: a turned scanner starts its sweep elsewhere.
void check_same(const std::vector<Feature>& found, const std::vector<Feature>& expected) {
  CHECK(found.size() == expected.size());
  for (const Feature& feature : expected) {
    const Point anchor = anchor_of(feature.geometry);
    CAPTURE(feature.type, anchor.transpose());
    CHECK(std::any_of(found.begin(), found.end(), [&](const Feature& f) { return same(f, feature); }));
  }
}

std::vector<Feature> transformed_all(const Pose2& T, std::vector<Feature> features) {
  for (Feature& feature : features) feature = transformed(T, feature);
  return features;
}

void check_sane(const Feature& feature) {
  for (const Point& p : points_of(feature.geometry)) CHECK(p.allFinite());
  CHECK(feature.covariance.allFinite());
  CHECK(feature.covariance.isApprox(feature.covariance.transpose(), 1e-9));
  CHECK(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(feature.covariance).eigenvalues().minCoeff() > -1e-9);
  if (const auto* segment = std::get_if<Segment>(&feature.geometry)) {
    CHECK(segment->normal().dot(-segment->begin) > 0);
    CHECK(feature.support_m <= segment->length_m() + 0.3);
  }
}

}  // namespace

TEST_CASE("a rotated scan gives the rotated features") {
  std::mt19937 random(21);
  Scanner half;
  half.sigma_m = 0.01;
  Scanner whole = all_around();
  whole.sigma_m = 0.01;
  const double angle = GENERATE(-3.0, -0.7, 0.4, 1.5, 2.9);
  for (const Scanner& scanner : {half, whole}) {
    const Scan scan = scan_of(furnished_room(), scanner, random);
    for (const auto& [name, detector] : detectors()) {
      CAPTURE(name, angle, scanner.beams);
      check_same(detector->detect(turned(scan, angle)), transformed_all({0, 0, angle}, detector->detect(scan)));
    }
  }
}

TEST_CASE("where the sweep of an all-around scanner starts does not matter") {
  std::mt19937 random(22);
  Scanner scanner = all_around();
  scanner.sigma_m = 0.01;
  const Scene closed_room{outline({{-2, -3}, {5, -3}, {5, 2}, {-2, 2}}), {}};
  for (const Scene& scene : {furnished_room(), closed_room}) {
    const Scan scan = scan_of(scene, scanner, random);
    Scan shifted = scan;
    const int shift = GENERATE(1, 90, 355, 610);
    std::rotate(shifted.points.begin(), shifted.points.begin() + shift, shifted.points.end());
    for (auto p = shifted.points.end() - shift; p != shifted.points.end(); ++p) p->bearing_rad += 2 * std::numbers::pi;
    for (const auto& [name, detector] : detectors()) {
      CAPTURE(name, shift);
      check_same(detector->detect(shifted), detector->detect(scan));
    }
  }
}

TEST_CASE("what is found in a furnished room is what is there") {
  const Scan scan = scan_of(furnished_room(), all_around());
  const auto found = [&](int i) { return detectors()[static_cast<std::size_t>(i)].detector->detect(scan); };
  CHECK(found(0).size() == 7);  // five walls, two sides of the box; the sixth wall cannot be seen
  CHECK(found(2).size() == 1);
  CHECK(found(3).size() == 1);
}

TEST_CASE("empty scans, single points and equal points hold no features") {
  Scan scan;
  scan.angle_increment_rad = 0.01;
  scan.range_max_m = 30;
  const Point position = 2 * unit_vector(0.1);
  for (int count : {0, 1, 2, 100}) {
    scan.points.assign(static_cast<std::size_t>(count), {position, 2, 0.1, 0});
    for (const auto& [name, detector] : detectors()) {
      CAPTURE(name, count);
      CHECK(detector->detect(scan).empty());
    }
  }
}

TEST_CASE("clutter, NaN and many beams give only finite features, and the same ones twice") {
  std::mt19937 random(static_cast<unsigned>(GENERATE(range(100, 130))));
  Scan scan = clutter(GENERATE(181, 1440, 5000), random);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  scan.points[10] = {{nan, 1}, nan, nan, 10};
  scan.points[20] = {{0, 0}, 0, scan.points[20].bearing_rad, 20};
  for (const auto& [name, detector] : detectors()) {
    CAPTURE(name);
    const auto found = detector->detect(scan);
    for (const Feature& feature : found) check_sane(feature);
    check_same(detector->detect(scan), found);
  }
}

TEST_CASE("a scan without beam spacing is no reason to fail") {
  Scan scan = scan_of(furnished_room(), Scanner{});
  scan.angle_increment_rad = 0;
  for (const auto& [name, detector] : detectors())
    for (const Feature& feature : detector->detect(scan)) check_sane(feature);
}

TEST_CASE("time of one scan", "[!benchmark]") {
  std::mt19937 random(23);
  Scanner scanner;
  scanner.sigma_m = 0.01;
  const Scan scan = scan_of(furnished_room(), scanner, random);
  Scanner fine = all_around(5000);
  fine.sigma_m = 0.02;
  const Scan many = scan_of(furnished_room(), fine, random);
  for (const Named& each : detectors()) {
    BENCHMARK(std::string(each.name) + ", 361 beams") { return each.detector->detect(scan).size(); };
    BENCHMARK(std::string(each.name) + ", 5000 beams") { return each.detector->detect(many).size(); };
  }
}
