#include <opal/sensing/lines/line_corner.hpp>

#include <Eigen/LU>

#include <catch2/catch.hpp>

using namespace opal;

namespace {

Line line(const Segment& segment, double offset_sigma_m, double heading_sigma_rad, double correlation) {
  Line line;
  line.segment = segment;
  const double both = correlation * offset_sigma_m * heading_sigma_rad;
  line.covariance << offset_sigma_m * offset_sigma_m, both, both, heading_sigma_rad * heading_sigma_rad;
  return line;
}

/// A line that is off: moved to its left, and turned about its middle.
Segment off_by(const Segment& segment, double offset_m, double turn_rad) {
  const Point half = 0.5 * segment.length_m() * unit_vector(segment.heading_rad() + turn_rad);
  const Point middle = segment.midpoint() + offset_m * segment.normal();
  return {middle - half, middle + half};
}

/// Where two lines meet, and the mean of their headings.
Eigen::Vector3d meeting_of(const Segment& a, const Segment& b) {
  Eigen::Matrix2d normals;
  normals << a.normal().transpose(), b.normal().transpose();
  const Point at = normals.inverse() * Point(a.normal().dot(a.begin), b.normal().dot(b.begin));
  return {at.x(), at.y(), 0.5 * (a.heading_rad() + b.heading_rad())};
}

/// By how much a corner moves and turns per error of its lines: offset and heading of one, then of the other.
Eigen::Matrix<double, 3, 4> effect_of_errors(const Segment& a, const Segment& b) {
  constexpr double kStep = 1e-5;
  Eigen::Matrix<double, 3, 4> effect;
  for (int k = 0; k < 4; ++k) {
    const auto at = [&](double step) {
      Eigen::Vector4d error = Eigen::Vector4d::Zero();
      error[k] = step;
      return meeting_of(off_by(a, error[0], error[1]), off_by(b, error[2], error[3]));
    };
    effect.col(k) = (at(kStep) - at(-kStep)) / (2 * kStep);
  }
  return effect;
}

}  // namespace

TEST_CASE("the covariance of a corner is what the errors of its lines make of it, at any angle") {
  const double opening_rad = GENERATE(0.6, std::numbers::pi / 2, 2.4, 4.5);
  CAPTURE(opening_rad);
  const Point at(3, 1);
  const double after_rad = 0.4, before_rad = after_rad + opening_rad - std::numbers::pi;
  const Segment before{at - 2 * unit_vector(before_rad), at - 0.1 * unit_vector(before_rad)};
  const Segment after{at + 0.2 * unit_vector(after_rad), at + 3 * unit_vector(after_rad)};
  const std::vector<Line> lines{line(before, 0.01, 0.02, 0.5), line(after, 0.03, 0.01, -0.3)};
  const LineCorner corner = corner_at({0, 1, at}, lines);
  Eigen::Matrix4d errors = Eigen::Matrix4d::Zero();
  errors.topLeftCorner<2, 2>() = lines[0].covariance;
  errors.bottomRightCorner<2, 2>() = lines[1].covariance;
  const auto effect = effect_of_errors(before, after);
  const Eigen::Matrix3d expected = effect * errors * effect.transpose();
  CHECK((corner.covariance - expected).norm() < 1e-4 * expected.norm());
}

TEST_CASE("a corner looks along the middle of the angle that is open to view, however it is turned") {
  for (const double turned_rad : {0.0, 1.0, 2.5, -2.0})
    for (const double opening_rad : {0.6, 1.5, 3.0, 4.5}) {
      CAPTURE(turned_rad, opening_rad);
      const double before_rad = turned_rad + opening_rad + std::numbers::pi;
      const std::vector<Line> lines{line({-2 * unit_vector(before_rad), Point(0, 0)}, 0.01, 0.01, 0),
                                    line({Point(0, 0), 2 * unit_vector(turned_rad)}, 0.01, 0.01, 0)};
      const OrientedPoint corner = corner_at({0, 1, Point(0, 0)}, lines).geometry;
      CHECK(corner.opening_rad == Approx(opening_rad));
      CHECK(std::abs(wrap_angle(corner.heading_rad - turned_rad - opening_rad / 2)) < 1e-9);
    }
}
