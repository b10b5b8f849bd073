#pragma once

#include "local_map/graph_factors.hpp"

#include "survey/pose_tracker.hpp"
#include "survey/tracking_graph.hpp"

namespace opal {

/// A pose that is known beforehand: x - prior.
class PosePriorFactor : public ceres::SizedCostFunction<3, 3> {
 public:
  PosePriorFactor(const Pose2& prior, const Eigen::Matrix3d& covariance)
      : prior_(prior), W_(whitening<3>(covariance, {kLeastSigma_m, kLeastSigma_m, kLeastSigma_rad})) {}

  bool Evaluate(double const* const* v, double* residuals, double** jacobians) const override {
    const Eigen::Vector3d e(v[0][0] - prior_.x(), v[0][1] - prior_.y(), wrap_angle(v[0][2] - prior_.heading_rad()));
    store<3, 1>(residuals, W_ * e);
    if (jacobians) store<3, 3>(jacobians[0], W_);
    return true;
  }

 private:
  Pose2 prior_;
  Eigen::Matrix3d W_;
};

/// A mapped face seen from a pose: its direction, and how far the middle of what was seen is from the face, which
/// itself is off by an offset along its normal (thesis A.1 and A.2; not the position along the face).
class MappedFaceFactor : public ceres::SizedCostFunction<2, 3, 1> {
 public:
  MappedFaceFactor(const MapMeasurement& measured, const Segment& mapped)
      : middle_(std::get<Segment>(measured.seen).midpoint()),
        turn_(std::get<Segment>(measured.seen).heading_rad() - mapped.heading_rad()),
        normal_(mapped.normal()),
        rho_(normal_.dot(mapped.begin)),
        W_(whitening<2>(measured.covariance, {1e-4, 1e-4})) {}

  bool Evaluate(double const* const* v, double* residuals, double** jacobians) const override {
    const Turn base(v[0][2]);
    const Point middle = Point(v[0][0], v[0][1]) + base.R * middle_;
    store<2, 1>(residuals, W_ * Eigen::Vector2d(normal_.dot(middle) - rho_ - v[1][0], wrap_angle(turn_ + v[0][2])));
    if (!jacobians) return true;
    Eigen::Matrix<double, 2, 3> by_pose;
    by_pose << normal_.x(), normal_.y(), normal_.dot(base.dR * middle_), 0, 0, 1;
    store<2, 3>(jacobians[0], W_ * by_pose);
    store<2, 1>(jacobians[1], W_ * Eigen::Vector2d(-1, 0));
    return true;
  }

 private:
  Point middle_;
  double turn_;
  Point normal_;
  double rho_;
  Eigen::Matrix2d W_;
};

/// A straight face that is not on the map, seen from a pose. Its line is (offset along the normal, turn) from where it
/// was thought to be.
class LandmarkFactor : public ceres::SizedCostFunction<2, 3, 2> {
 public:
  LandmarkFactor(const LandmarkSight& sight, const Segment& thought)
      : middle_(sight.seen.midpoint()),
        turn_(sight.seen.heading_rad() - thought.heading_rad()),
        normal_(thought.normal()),
        anchor_(thought.midpoint()),
        W_(whitening<2>(sight.covariance, {1e-4, 1e-4})) {}

  bool Evaluate(double const* const* v, double* residuals, double** jacobians) const override {
    const Turn base(v[0][2]), line(v[1][1]);
    const Point from = Point(v[0][0], v[0][1]) + base.R * middle_ - anchor_;
    const Point normal = line.R * normal_;
    const Eigen::Vector2d e(normal.dot(from) - v[1][0], wrap_angle(turn_ + v[0][2] - v[1][1]));
    evaluate_seen_line(e, from, base.dR * middle_, normal, line.dR * normal_, W_, residuals, jacobians);
    return true;
  }

 private:
  Point middle_;
  double turn_;
  Point normal_, anchor_;
  Eigen::Matrix2d W_;
};

/// A mapped column, which itself is off by an offset, seen in range and bearing: R^T (l + offset - x) - z.
class MappedPointFactor : public ceres::SizedCostFunction<2, 3, 2> {
 public:
  MappedPointFactor(const MapMeasurement& measured, const Point& mapped)
      : seen_(anchor_of(measured.seen)), mapped_(mapped), W_(whitening<2>(measured.covariance, {1e-4, 1e-4})) {}

  bool Evaluate(double const* const* v, double* residuals, double** jacobians) const override {
    const Point apart = mapped_ + Point(v[1][0], v[1][1]) - Point(v[0][0], v[0][1]);
    evaluate_seen_point(v[0][2], apart, seen_, W_, residuals, jacobians);
    return true;
  }

 private:
  Point seen_, mapped_;
  Eigen::Matrix2d W_;
};

/// An offset that is about as known: (offset - mean) / sigma.
template <int N>
class OffsetFactor : public ceres::SizedCostFunction<N, N> {
 public:
  OffsetFactor(const Eigen::Matrix<double, N, 1>& mean, double sigma_m) : mean_(mean), sigma_m_(sigma_m) {}

  bool Evaluate(double const* const* v, double* residuals, double** jacobians) const override {
    for (int k = 0; k < N; ++k) residuals[k] = (v[0][k] - mean_[k]) / sigma_m_;
    if (jacobians) store<N, N>(jacobians[0], Eigen::Matrix<double, N, N>::Identity() / sigma_m_);
    return true;
  }

 private:
  Eigen::Matrix<double, N, 1> mean_;
  double sigma_m_;
};

/// An offset that changes slowly: (offset - offset before) / sigma.
template <int N>
class OffsetLinkFactor : public ceres::SizedCostFunction<N, N, N> {
 public:
  explicit OffsetLinkFactor(double sigma_m) : sigma_m_(sigma_m) {}

  bool Evaluate(double const* const* v, double* residuals, double** jacobians) const override {
    for (int k = 0; k < N; ++k) residuals[k] = (v[1][k] - v[0][k]) / sigma_m_;
    if (!jacobians) return true;
    const Eigen::Matrix<double, N, N> by_now = Eigen::Matrix<double, N, N>::Identity() / sigma_m_;
    store<N, N>(jacobians[0], -by_now);
    store<N, N>(jacobians[1], by_now);
    return true;
  }

 private:
  double sigma_m_;
};

}  // namespace opal
