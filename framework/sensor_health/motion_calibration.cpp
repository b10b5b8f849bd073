#include "sensor_health/motion_calibration.hpp"

#include "common/covariance.hpp"

#include <opal/common/quantile.hpp>

#include <Eigen/Dense>

#include <algorithm>
#include <utility>
#include <vector>

namespace opal {
namespace {

constexpr int kRounds = 8;        // of reweighting; the weights settle in four or five
constexpr double kHuber = 1.5;    // standard deviations beyond which a residual counts by its size only
constexpr double kUnknown_m = 1;  // one-sigma of a mount's position of which the drive says nothing
constexpr std::size_t kFewestPairs = 3;

// Odometry and scans are stamped up to 0.1 s apart, and wheels slip: so much of a motion [1], and so much always.
constexpr double kShare = 0.1, kLeast_m = 0.02, kLeast_rad = 0.02;
constexpr double kTells = 1;  // standard deviations between two explanations of a motion, so that it is for one of them
constexpr double kLeastTurn_rad = 0.05, kLeastDrive_m = 0.1;  // less tells nothing of a scale

double robust_weight(double normalized) { return normalized <= kHuber ? 1 : kHuber / normalized; }

/// Median of what most residuals are over what they should be: at least 1, so that luck is no precision.
double excess_of(std::vector<double> normalized, double expected_median) {
  return std::max(1.0, upper_median_of(std::move(normalized)) / expected_median);
}

// ---------------------------------------------------------------------------------------------- turns

double turn_sigma_rad(const MotionPair& pair) {
  return std::hypot(kLeast_rad, kShare * pair.T_odometry.heading_rad(), std::sqrt(pair.covariance(2, 2)));
}

/// Turns by scans over turns by odometry, through the origin.
Estimated turn_scale_of(std::span<const MotionPair> pairs) {
  Estimated scale{1, 0};
  std::vector<double> normalized(pairs.size(), 0.0);
  double information = 0;
  for (int round = 0; round < kRounds; ++round) {
    double sum = 0;
    information = 1e-12;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const double by_odometry = pairs[k].T_odometry.heading_rad(), sigma = turn_sigma_rad(pairs[k]);
      const double weight = (round == 0 ? 1 : robust_weight(normalized[k])) / (sigma * sigma);
      information += weight * by_odometry * by_odometry;
      sum += weight * by_odometry * pairs[k].T_scans.heading_rad();
    }
    scale.value = sum / information;
    for (std::size_t k = 0; k < pairs.size(); ++k)
      normalized[k] = std::abs(pairs[k].T_scans.heading_rad() - scale.value * pairs[k].T_odometry.heading_rad()) /
                      turn_sigma_rad(pairs[k]);
  }
  scale.sigma = excess_of(normalized, 0.674) / std::sqrt(information);
  return scale;
}

// ---------------------------------------------------------------------------------------------- distances

using Unknowns =
    Eigen::Vector4d;  ///< scale * cos, scale * sin of the mount's heading; its position, seen from the laser
using Rows = Eigen::Matrix<double, 2, 4>;

/// T_scans of a laser whose beams turn the other way.
Pose2 mirrored(const Pose2& T) { return {T.x(), -T.y(), -T.heading_rad()}; }

/// b = R(-heading) (scale a - (I - R(turn)) p): what scans see of the base's motion a from a mount at p.
struct Equation {
  Rows rows;
  Point seen;
  Eigen::Matrix2d whitening;  ///< makes residuals of variance 1

  explicit Equation(const MotionPair& pair, const Pose2& T_scans) : seen(T_scans.position()) {
    const Point a = pair.T_odometry.position();
    const double c = std::cos(T_scans.heading_rad()), s = std::sin(T_scans.heading_rad());
    rows << a.x(), a.y(), c - 1, -s,  //
        a.y(), -a.x(), s, c - 1;
    const double share_m = kShare * a.norm();
    Eigen::Matrix2d covariance = pair.covariance.topLeftCorner<2, 2>();
    covariance.diagonal().array() += kLeast_m * kLeast_m + share_m * share_m;
    whitening = Eigen::Matrix2d(covariance.llt().matrixL()).inverse();
  }
  double normalized(const Unknowns& x) const { return (whitening * (rows * x - seen)).norm(); }
};

struct Solution {
  Unknowns unknowns;
  Eigen::Matrix4d covariance;
};

/// One weighted least-squares step. The position is tied to the described one as loosely as kUnknown_m.
Solution solved(std::span<const Equation> equations, std::span<const double> weights, const Point& described) {
  Eigen::Matrix4d information = Eigen::Vector4d(1e-9, 1e-9, 1, 1).asDiagonal();
  information.bottomRightCorner<2, 2>() /= kUnknown_m * kUnknown_m;
  Unknowns sum;
  sum << 0, 0, described / (kUnknown_m * kUnknown_m);
  for (std::size_t k = 0; k < equations.size(); ++k) {
    const Rows rows = equations[k].whitening * equations[k].rows;
    information += weights[k] * rows.transpose() * rows;
    sum += weights[k] * rows.transpose() * (equations[k].whitening * equations[k].seen);
  }
  const Eigen::LDLT<Eigen::Matrix4d> solver(information);
  return {solver.solve(sum), solver.solve(Eigen::Matrix4d::Identity())};
}

Solution mount_and_scale(std::span<const MotionPair> pairs, bool is_mirrored, const Pose2& described) {
  std::vector<Equation> equations;
  for (const MotionPair& pair : pairs)
    equations.emplace_back(pair, is_mirrored ? mirrored(pair.T_scans) : pair.T_scans);
  // As the laser sees it, so that the unknowns stay linear.
  const Point seen_from_laser = Pose2(Point::Zero(), -described.heading_rad()) * described.position();
  std::vector<double> weights(pairs.size(), 1.0), normalized(pairs.size(), 0.0);
  Solution solution;
  for (int round = 0; round < kRounds; ++round) {
    solution = solved(equations, weights, seen_from_laser);
    for (std::size_t k = 0; k < equations.size(); ++k) {
      normalized[k] = equations[k].normalized(solution.unknowns);
      weights[k] = robust_weight(normalized[k]);
    }
  }
  const double excess = excess_of(normalized, 1.177);
  solution.covariance *= excess * excess;
  return solution;
}

void read_mount(const Solution& solution, MotionCalibration& calibration) {
  const Point direction = solution.unknowns.head<2>();
  const double scale = direction.norm(), heading_rad = std::atan2(direction.y(), direction.x());
  const Eigen::Matrix2d covariance = solution.covariance.topLeftCorner<2, 2>();
  const Point along = scale > 0 ? Point(direction / scale) : Point(1, 0), across = left_of(along);
  calibration.distance_scale = {scale, std::sqrt(along.dot(covariance * along))};
  calibration.mount_heading_rad = {heading_rad, std::sqrt(across.dot(covariance * across)) / std::max(scale, 1e-9)};
  calibration.mount_position_m = Pose2(Point::Zero(), heading_rad) * Point(solution.unknowns.tail<2>());
  calibration.mount_position_sigma_m = largest_sigma(solution.covariance.bottomRightCorner<2, 2>());
}

Unknowns as_described(const Pose2& T_base_laser) {
  Unknowns x;
  x << unit_vector(T_base_laser.heading_rad()),
      Pose2(Point::Zero(), -T_base_laser.heading_rad()) * T_base_laser.position();
  return x;
}

/// Of the pairs that drove and are for one of the two.
double share_nearer_to(const Unknowns& estimate, std::span<const MotionPair> pairs, bool is_mirrored,
                       const Unknowns& described) {
  double nearer = 0, drives = 0;
  for (const MotionPair& pair : pairs) {
    if (pair.T_odometry.position().norm() < kLeastDrive_m) continue;
    const Equation estimated(pair, is_mirrored ? mirrored(pair.T_scans) : pair.T_scans), as_it_is(pair, pair.T_scans);
    const double by_estimate = estimated.normalized(estimate), by_description = as_it_is.normalized(described);
    if (std::abs(by_estimate - by_description) < kTells) continue;
    ++drives;
    nearer += by_estimate < by_description;
  }
  return drives > 0 ? nearer / drives : 0;
}

/// Of the pairs that turned.
double share_of_turns_nearer_to(double scale, std::span<const MotionPair> pairs) {
  double nearer = 0, turns = 0;
  for (const MotionPair& pair : pairs) {
    const double by_odometry = pair.T_odometry.heading_rad(), by_scans = pair.T_scans.heading_rad();
    if (std::abs(by_odometry) < kLeastTurn_rad) continue;
    ++turns;
    nearer += std::abs(by_scans - scale * by_odometry) < std::abs(by_scans - by_odometry);
  }
  return turns > 0 ? nearer / turns : 0;
}

}  // namespace

std::optional<MotionCalibration> calibrate_motion(std::span<const MotionPair> pairs, const Pose2& described) {
  if (pairs.size() < kFewestPairs) return std::nullopt;
  MotionCalibration calibration;
  calibration.pairs = static_cast<int>(pairs.size());
  for (const MotionPair& pair : pairs) {
    calibration.driven_m += pair.T_odometry.position().norm();
    calibration.turned_rad += std::abs(pair.T_odometry.heading_rad());
  }
  calibration.turn_scale = turn_scale_of(pairs);
  const bool is_mirrored = calibration.turn_scale.value < -3 * calibration.turn_scale.sigma;
  const Solution solution = mount_and_scale(pairs, is_mirrored, described);
  read_mount(solution, calibration);
  calibration.turns_better = share_of_turns_nearer_to(calibration.turn_scale.value, pairs);
  calibration.distances_better = share_nearer_to(solution.unknowns, pairs, is_mirrored, as_described(described));
  return calibration;
}

}  // namespace opal
