#include <opal/import_kit/b_spline.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <numbers>

using namespace opal;
using Eigen::Vector3d;

namespace {

/// A quarter of the unit circle, exactly (Piegl and Tiller 1997, section 7.3).
BSpline quarter_circle() {
  return {2, {0, 0, 0, 1, 1, 1}, {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {1, std::numbers::sqrt2 / 2, 1}};
}

BSpline with_inner_knots() {
  return {3, {0, 0, 0, 0, 1, 2, 2, 2, 2}, {{0, 0, 0}, {1, 2, 0}, {3, 2, 0}, {4, -1, 0}, {6, 0, 0}}, {}};
}

}  // namespace

TEST_CASE("a spline of one span is the Bezier curve of its control points") {
  const BSpline cubic{3, {0, 0, 0, 0, 1, 1, 1, 1}, {{0, 0, 0}, {1, 1, 0}, {3, 1, 0}, {4, 0, 0}}, {}};
  CHECK((point_at(cubic, 0) - Vector3d(0, 0, 0)).norm() < 1e-12);
  CHECK((point_at(cubic, 0.5) - Vector3d(2, 0.75, 0)).norm() < 1e-12);
  CHECK((point_at(cubic, 1) - Vector3d(4, 0, 0)).norm() < 1e-12);
}

TEST_CASE("a rational spline is a circle exactly, and its chords are as near as asked for") {
  const double tolerance = GENERATE(0.1, 0.01, 0.001);
  const auto points = chord_points(quarter_circle(), tolerance);
  REQUIRE(points.size() > 2);
  for (const Vector3d& p : points) CHECK(p.norm() == Approx(1).margin(1e-12));
  for (std::size_t k = 0; k + 1 < points.size(); ++k)
    CHECK(1 - (points[k] + points[k + 1]).norm() / 2 < 1.1 * tolerance);
  CHECK(points.size() < 4 / std::sqrt(tolerance));
}

TEST_CASE("a straight spline needs one chord for each of its spans") {
  const BSpline line{1, {0, 0, 1, 2, 2}, {{0, 0, 0}, {2, 0, 0}, {2, 5, 1}}, {}};
  const auto points = chord_points(line, 0.001);
  REQUIRE(points.size() == 3);
  CHECK((points[1] - Vector3d(2, 0, 0)).norm() < 1e-12);
}

TEST_CASE("a spline lies within its control points and is moved with them") {
  const BSpline spline = with_inner_knots();
  BSpline moved = spline;
  for (Vector3d& p : moved.control_points) p += Vector3d(10, -3, 2);
  for (double u = 0; u <= 2; u += 0.0625) {
    const Vector3d p = point_at(spline, u);
    CHECK(p.x() >= 0);
    CHECK(p.x() <= 6);
    CHECK((point_at(moved, u) - p - Vector3d(10, -3, 2)).norm() < 1e-12);
  }
  CHECK((point_at(spline, 2) - Vector3d(6, 0, 0)).norm() < 1e-12);
}

TEST_CASE("a periodic spline begins and ends at one point, without repeated knots") {
  std::vector<Vector3d> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  square.insert(square.end(), square.begin(), square.begin() + 3);
  BSpline closed{3, {}, square, {}};
  for (int k = 0; k < 11; ++k) closed.knots.push_back(k);
  REQUIRE(fault_of(closed).empty());
  const auto points = chord_points(closed, 0.001);
  CHECK((points.front() - points.back()).norm() < 1e-12);
  for (const Vector3d& p : points) CHECK((p - Vector3d(0.5, 0.5, 0)).norm() < 0.5);
}

TEST_CASE("what is wrong with a spline is said in words") {
  const auto fault = [](auto change) {
    BSpline spline = with_inner_knots();
    change(spline);
    return fault_of(spline);
  };
  CHECK(fault([](BSpline&) {}).empty());
  CHECK(fault([](BSpline& s) { s.degree = 0; }) == "a spline of degree 0");
  CHECK(fault([](BSpline& s) { s.control_points.resize(3); }) == "a spline of degree 3 with 3 control points");
  CHECK(fault([](BSpline& s) { s.knots.pop_back(); }) == "a spline with 8 knots, expected 9");
  CHECK(fault([](BSpline& s) { s.knots[4] = 3; }) == "a spline whose knots do not rise");
  CHECK(fault([](BSpline& s) { s.knots.assign(9, 1.0); }) == "a spline whose knots do not rise");
  CHECK(fault([](BSpline& s) { s.weights = {1, 1}; }) == "a spline with a weight for some control points only");
  CHECK(fault([](BSpline& s) { s.weights = {1, 1, 0, 1, 1}; }) == "a spline with weights that are not positive");
  CHECK(fault([](BSpline& s) { s.control_points[1].x() = std::numeric_limits<double>::quiet_NaN(); }) ==
        "a spline with a control point that is nowhere");
}
