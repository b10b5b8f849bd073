#pragma once

#include "local_map/local_map_graph.hpp"

#include <ceres/ceres.h>

#include <array>

namespace opal {

// Least standard deviations: neither detectors nor matchers know of errors they share between scans.
constexpr double kLeastSigma_m = 0.01;
constexpr double kLeastSigma_rad = 0.003;

using Variable = std::array<double, 3>;

inline Variable to_variable(const Pose2& pose) { return {pose.x(), pose.y(), pose.heading_rad()}; }
inline Pose2 to_pose(const Variable& v) { return {v[0], v[1], v[2]}; }

/// W with W^T W = inverse of the covariance, after the least standard deviations have been added.
template <int N>
Eigen::Matrix<double, N, N> whitening(Eigen::Matrix<double, N, N> covariance,
                                      const Eigen::Matrix<double, N, 1>& least_sigma) {
  covariance.diagonal() += least_sigma.cwiseAbs2();
  const Eigen::Matrix<double, N, N> information = covariance.inverse();
  return information.llt().matrixU();
}

/// Writes to Ceres' arrays; a null pointer is a Jacobian that is not asked for.
template <int Rows, int Columns>
void store(double* to, const Eigen::Matrix<double, Rows, Columns>& values) {
  if (!to) return;
  for (int row = 0; row < Rows; ++row)
    for (int column = 0; column < Columns; ++column) to[row * Columns + column] = values(row, column);
}

/// Rotation by `heading` and its derivative by the heading.
struct Turn {
  explicit Turn(double heading) {
    const double c = std::cos(heading), s = std::sin(heading);
    R << c, -s, s, c;
    dR << -s, -c, c, -s;
  }
  Eigen::Matrix2d R, dR;
};

/// Relative pose of two keyframes: (R_a^T (x_b - x_a) - t, heading_b - heading_a - turn).
class MotionFactor : public ceres::SizedCostFunction<3, 3, 3> {
 public:
  explicit MotionFactor(const RelativePose& motion)
      : motion_(motion.T_from_to),
        W_(whitening<3>(motion.covariance, {kLeastSigma_m, kLeastSigma_m, kLeastSigma_rad})) {}

  bool Evaluate(double const* const* v, double* residuals, double** jacobians) const override {
    const Turn a(v[0][2]);
    const Point apart(v[1][0] - v[0][0], v[1][1] - v[0][1]);
    Eigen::Vector3d e;
    e << a.R.transpose() * apart - motion_.position(), wrap_angle(v[1][2] - v[0][2] - motion_.heading_rad());
    store<3, 1>(residuals, W_ * e);
    if (!jacobians) return true;
    Eigen::Matrix3d by_a = -Eigen::Matrix3d::Identity(), by_b = Eigen::Matrix3d::Identity();
    by_a.topLeftCorner<2, 2>() = -a.R.transpose();
    by_a.topRightCorner<2, 1>() = a.dR.transpose() * apart;
    by_b.topLeftCorner<2, 2>() = a.R.transpose();
    store<3, 3>(jacobians[0], W_ * by_a);
    store<3, 3>(jacobians[1], W_ * by_b);
    return true;
  }

 private:
  Pose2 motion_;
  Eigen::Matrix3d W_;
};

/// A position `apart` from a pose in the frame of both, seen from the pose: R^T apart - seen, and its derivatives by
/// the pose and by the position.
inline void evaluate_seen_point(double heading_rad, const Point& apart, const Point& seen, const Eigen::Matrix2d& W,
                                double* residuals, double** jacobians) {
  const Turn base(heading_rad);
  store<2, 1>(residuals, W * (base.R.transpose() * apart - seen));
  if (!jacobians) return;
  Eigen::Matrix<double, 2, 3> by_pose;
  by_pose << -base.R.transpose(), base.dR.transpose() * apart;
  store<2, 3>(jacobians[0], W * by_pose);
  store<2, 2>(jacobians[1], W * base.R.transpose());
}

/// A straight face seen from a pose, beside its line (offset along the normal, heading): e, and its derivatives by the
/// pose and by the line.
/// @param e                  offset and heading that are left [m, rad].
/// @param from               from where offsets count to the middle of what is seen, and how the pose's heading moves
/// it.
/// @param normal             of the line, and how the line's heading turns it.
inline void evaluate_seen_line(const Eigen::Vector2d& e, const Point& from, const Point& from_by_heading,
                               const Point& normal, const Point& normal_by_heading, const Eigen::Matrix2d& W,
                               double* residuals, double** jacobians) {
  store<2, 1>(residuals, W * e);
  if (!jacobians) return;
  Eigen::Matrix<double, 2, 3> by_pose;
  by_pose << normal.x(), normal.y(), normal.dot(from_by_heading), 0, 0, 1;
  Eigen::Matrix2d by_line;
  by_line << -1, normal_by_heading.dot(from), 0, -1;
  store<2, 3>(jacobians[0], W * by_pose);
  store<2, 2>(jacobians[1], W * by_line);
}

/// Covariance of a * b, first order.
inline Eigen::Matrix3d chained(const RelativePose& a, const RelativePose& b) {
  const Point lever = a.T_from_to.rotate(b.T_from_to.position());
  Eigen::Matrix3d by_a = Eigen::Matrix3d::Identity(), by_b = Eigen::Matrix3d::Identity();
  by_a.topRightCorner<2, 1>() = left_of(lever);
  by_b.topLeftCorner<2, 2>() = Turn(a.T_from_to.heading_rad()).R;
  return by_a * a.covariance * by_a.transpose() + by_b * b.covariance * by_b.transpose();
}

}  // namespace opal
