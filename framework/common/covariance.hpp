#pragma once

#include <opal/common/geometry.hpp>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <cmath>

namespace opal {

/// Covariance of (x, y, heading) in axes of frame `a`. @param covariance_b  the same in axes of frame `b`.
inline Eigen::Matrix3d turned_covariance(const Pose2& T_a_b, const Eigen::Matrix3d& covariance_b) {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.col(0).head<2>() = T_a_b.rotate(Point::UnitX());
  turn.col(1).head<2>() = T_a_b.rotate(Point::UnitY());
  return turn * covariance_b * turn.transpose();
}

/// Standard deviation of a position along the axis of which least is known.
inline double largest_sigma(const Eigen::Matrix2d& covariance) {
  return std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(covariance, Eigen::EigenvaluesOnly).eigenvalues()(1));
}

}  // namespace opal
