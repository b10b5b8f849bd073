#include <opal/sensing/lines/line_corner.hpp>

#include <Eigen/LU>

namespace opal {
namespace {

/// Covariance of (offset, heading) of a line, with the offset taken at `at` instead of the midpoint: an
/// offset grows by heading error times the distance along the line.
Eigen::Matrix2d covariance_at(const Line& line, const Point& at) {
  Eigen::Matrix2d move = Eigen::Matrix2d::Identity();
  move(0, 1) = line.segment.direction().dot(at - line.segment.midpoint());
  return move * line.covariance * move.transpose();
}

/// The corner moves by dx with n_before . dx = offset_before and n_after . dx = offset_after; its heading
/// turns by the mean of the two line headings.
Eigen::Matrix3d corner_covariance(const Line& before, const Line& after, const Point& at) {
  Eigen::Matrix2d normals;
  normals << before.segment.normal().transpose(), after.segment.normal().transpose();
  const Eigen::Matrix2d to_position = normals.inverse();
  Eigen::Matrix<double, 3, 4> jacobian = Eigen::Matrix<double, 3, 4>::Zero();
  jacobian.block<2, 1>(0, 0) = to_position.col(0);
  jacobian.block<2, 1>(0, 2) = to_position.col(1);
  jacobian(2, 1) = jacobian(2, 3) = 0.5;
  Eigen::Matrix4d lines = Eigen::Matrix4d::Zero();
  lines.topLeftCorner<2, 2>() = covariance_at(before, at);
  lines.bottomRightCorner<2, 2>() = covariance_at(after, at);
  return jacobian * lines * jacobian.transpose();
}

}  // namespace

LineCorner corner_at(const Junction& junction, std::span<const Line> lines) {
  const Line& before = lines[junction.before];
  const Line& after = lines[junction.after];
  // Both faces are seen from their left: the open angle runs counter-clockwise from `after` to `before`
  // reversed.
  const double from = after.segment.heading_rad();
  const double two_pi = 2 * std::numbers::pi;
  const double opening = std::fmod(before.segment.heading_rad() + std::numbers::pi - from + 2 * two_pi, two_pi);
  LineCorner corner;
  corner.geometry = {junction.position, wrap_angle(from + opening / 2), opening};
  corner.covariance = corner_covariance(before, after, junction.position);
  return corner;
}

}  // namespace opal
