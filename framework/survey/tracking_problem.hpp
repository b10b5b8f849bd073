#pragma once

#include "survey/tracking_factors.hpp"
#include "survey/tracking_graph.hpp"

#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>

#include <algorithm>

namespace opal {

inline constexpr int kTrackStepIterations = 6;  // starts near the solution
inline constexpr int kTrackBatchIterations = 30;
inline constexpr double kLeastOffsetSigma_m = 0.02;  // what the measurements of one face have in common

/// Asks after each step whether to go on.
class AskingCallback : public ceres::IterationCallback {
 public:
  explicit AskingCallback(const GoesOn& goes_on) : goes_on_(goes_on) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& step) override {
    const bool goes_on = !goes_on_ || goes_on_(static_cast<double>(step.iteration) / kTrackBatchIterations);
    return goes_on ? ceres::SOLVER_CONTINUE : ceres::SOLVER_ABORT;
  }

 private:
  const GoesOn& goes_on_;
};

/// One problem: variables and factors, in a frame at the oldest pose, so that numbers stay small.
class TrackingProblem {
 public:
  /// @param most_variables  that will be added: poses and offsets.
  TrackingProblem(const MapView& map, const PoseTrackerOptions& options, const Point& origin,
                  std::size_t most_variables)
      : map_(map), options_(options), origin_(origin), measured_loss_(options.robust_scale) {
    variables_.reserve(most_variables);
  }

  /// @param doubt  factor on the variance of its motion.
  void add_pose(const TrackedKeyframe& keyframe, double doubt) {
    add_loose_pose(keyframe);
    if (poses_.size() < 2) return;
    const RelativePose motion{{}, {}, keyframe.T_before_now, doubt * keyframe.motion_covariance};
    problem_.AddResidualBlock(new MotionFactor(motion), nullptr, poses_[poses_.size() - 2], poses_.back());
  }

  /// What is known of the newest pose.
  void bound(const TrackedKeyframe& keyframe, const Eigen::Vector3d& sigma) {
    const Pose2 local(Point(keyframe.T_map_base.position() - origin_), keyframe.T_map_base.heading_rad());
    problem_.AddResidualBlock(new PosePriorFactor(local, sigma.cwiseAbs2().asDiagonal()), nullptr, poses_.back());
  }

  /// Lines that the sights of legs refer to by their order.
  void add_landmarks(std::span<const Segment> landmarks) {
    for (const Segment& at : landmarks) {
      landmarks_.push_back({Segment{at.begin - origin_, at.end - origin_}, new_variable({0, 0, 0})});
      problem_.AddParameterBlock(landmarks_.back().line, 2);
    }
  }

  void add_leg(const TrackLeg& leg) {
    for (std::size_t k = 0; k < leg.track.size(); ++k) {
      if (k > 0)
        add_pose(leg.track[k], 1);
      else
        add_loose_pose(leg.track[k]);
      if (k == 0 && !leg.begins_at) bound(leg.track[k], leg.start_sigma);
      for (const MapMeasurement& measured : leg.track[k].measurements) add_measurement(measured, {}, 0);
      if (leg.landmarks.empty()) continue;
      for (const LandmarkSight& sight : leg.landmarks[k]) {
        const Landmark& landmark = landmarks_[sight.landmark];
        problem_.AddResidualBlock(new LandmarkFactor(sight, landmark.thought), &measured_loss_, poses_.back(),
                                  landmark.line);
      }
    }
  }

  /// Two poses, by their order, that are one.
  void join(std::size_t one, std::size_t other) {
    constexpr double kSame_m = 0.01, kSame_rad = 0.005;
    const Eigen::Matrix3d covariance = Eigen::Vector3d(kSame_m, kSame_m, kSame_rad).cwiseAbs2().asDiagonal();
    problem_.AddResidualBlock(new MotionFactor(RelativePose{{}, {}, Pose2(), covariance}), nullptr, poses_[one],
                              poses_[other]);
  }

  void add_prior(const PosePrior& prior) {
    const Pose2 local(Point(prior.T_map_base.position() - origin_), prior.T_map_base.heading_rad());
    problem_.AddResidualBlock(new PosePriorFactor(local, prior.covariance), nullptr, poses_.front());
  }

  /// From the newest pose.
  void add_measurement(const MapMeasurement& measured, const OffsetMemories& memory, int epoch) {
    double* offset = offset_of(measured.feature, memory, epoch);
    if (const auto* face = std::get_if<Segment>(&map_.feature(measured.feature).geometry)) {
      const Segment local{face->begin - origin_, face->end - origin_};
      problem_.AddResidualBlock(new MappedFaceFactor(measured, local), &measured_loss_, poses_.back(), offset);
    } else {
      const Point at = anchor_of(map_.feature(measured.feature).geometry) - origin_;
      problem_.AddResidualBlock(new MappedPointFactor(measured, at), &measured_loss_, poses_.back(), offset);
    }
  }

  bool solve(bool batch, const GoesOn& goes_on = {}) {
    ceres::Solver::Options solver;
    AskingCallback asking(goes_on);
    solver.callbacks.push_back(&asking);
    solver.linear_solver_type = batch ? ceres::SPARSE_NORMAL_CHOLESKY : ceres::DENSE_SCHUR;
    if (!batch && !offsets_.empty()) {
      solver.linear_solver_ordering = std::make_shared<ceres::ParameterBlockOrdering>();
      for (auto& [key, offset] : offsets_) solver.linear_solver_ordering->AddElementToGroup(offset, 0);
      for (double* pose : poses_) solver.linear_solver_ordering->AddElementToGroup(pose, 1);
    }
    solver.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;  // in this thread alone: SuiteSparse starts others
    solver.max_num_iterations = batch ? kTrackBatchIterations : kTrackStepIterations;
    solver.function_tolerance = batch ? 1e-6 : 1e-4;
    solver.num_threads = 1;
    solver.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(solver, &problem_, &summary);
    return summary.IsSolutionUsable();
  }

  SolvedTrack solution() const {
    SolvedTrack track;
    track.usable = true;
    for (const double* pose : poses_) {
      track.T_map_base.emplace_back(Point(pose[0] + origin_.x(), pose[1] + origin_.y()), pose[2]);
      track.usable = track.usable && track.T_map_base.back().position().allFinite() && std::isfinite(pose[2]);
    }
    std::map<MapFeatureNumber, double> epochs;
    for (const auto& [key, offset] : offsets_) {
      FeatureOffset& solved = track.offsets[key.first];
      const double n = ++epochs[key.first];
      solved.moved += (moved_by(key.first, offset) - solved.moved) / n;
    }
    return track;
  }

  /// First-order one-sigmas of the offsets, of as many poses as there are.
  void add_offset_sigmas(std::map<MapFeatureNumber, FeatureOffset>& solved) {
    ceres::Problem::EvaluateOptions order;
    for (double* pose : poses_) order.parameter_blocks.push_back(pose);
    for (auto& [key, offset] : offsets_) order.parameter_blocks.push_back(offset);
    for (const Landmark& landmark : landmarks_) order.parameter_blocks.push_back(landmark.line);
    ceres::CRSMatrix J;
    problem_.Evaluate(order, nullptr, nullptr, nullptr, &J);
    const Eigen::Map<const Eigen::SparseMatrix<double, Eigen::RowMajor>> rows(
        J.num_rows, J.num_cols, static_cast<Eigen::Index>(J.values.size()), J.rows.data(), J.cols.data(),
        J.values.data());
    const Eigen::SparseMatrix<double> jacobian = rows;
    Eigen::SparseMatrix<double> H = jacobian.transpose() * jacobian, ridge(J.num_cols, J.num_cols);
    ridge.setIdentity();
    H += 1e-9 * ridge;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factored(H);
    auto at = static_cast<Eigen::Index>(3 * poses_.size());
    for (auto& [key, offset] : offsets_) {
      const double variance = factored.solve(Eigen::VectorXd::Unit(J.num_cols, at))(at);
      solved[key.first].sigma_m = std::hypot(kLeastOffsetSigma_m, std::sqrt(std::max(0.0, variance)));
      at += size_of(key.first);
    }
  }

  /// First-order covariances around the solution.
  void add_covariances(SolvedTrack& track) {
    ceres::Problem::EvaluateOptions order;
    for (double* pose : poses_) order.parameter_blocks.push_back(pose);
    for (auto& [key, offset] : offsets_) order.parameter_blocks.push_back(offset);
    ceres::CRSMatrix J;
    problem_.Evaluate(order, nullptr, nullptr, nullptr, &J);
    Eigen::MatrixXd H = 1e-9 * Eigen::MatrixXd::Identity(J.num_cols, J.num_cols);
    for (int row = 0; row < J.num_rows; ++row)
      for (int a = J.rows[row]; a < J.rows[row + 1]; ++a)
        for (int b = J.rows[row]; b < J.rows[row + 1]; ++b) H(J.cols[a], J.cols[b]) += J.values[a] * J.values[b];
    const Eigen::MatrixXd covariance = H.llt().solve(Eigen::MatrixXd::Identity(J.num_cols, J.num_cols));
    for (std::size_t k = 0; k < poses_.size(); ++k)
      track.covariances.push_back(
          covariance.block<3, 3>(static_cast<Eigen::Index>(3 * k), static_cast<Eigen::Index>(3 * k)));
    auto at = static_cast<Eigen::Index>(3 * poses_.size());
    for (auto& [feature, offset] : track.offsets) {
      offset.sigma_m = std::hypot(kLeastOffsetSigma_m, std::sqrt(std::max(0.0, covariance(at, at))));
      at += size_of(feature);
    }
  }

 private:
  bool is_face(MapFeatureNumber feature) const {
    return std::holds_alternative<Segment>(map_.feature(feature).geometry);
  }
  int size_of(MapFeatureNumber feature) const { return is_face(feature) ? 1 : 2; }

  /// A pose without a motion to it.
  void add_loose_pose(const TrackedKeyframe& keyframe) {
    const Point at = keyframe.T_map_base.position() - origin_;
    poses_.push_back(new_variable({at.x(), at.y(), keyframe.T_map_base.heading_rad()}));
    problem_.AddParameterBlock(poses_.back(), 3);
  }

  double* new_variable(const Variable& start) {
    variables_.push_back(start);
    return variables_.back().data();
  }

  Point moved_by(MapFeatureNumber feature, const double* offset) const {
    if (const auto* face = std::get_if<Segment>(&map_.feature(feature).geometry)) return offset[0] * face->normal();
    return {offset[0], offset[1]};
  }

  /// The variable of a feature's offset at the newest pose; new ones begin with what is known.
  double* offset_of(MapFeatureNumber feature, const OffsetMemories& memory, int epoch) {
    double*& offset = offsets_[{feature, epoch}];
    if (offset) return offset;
    offset = new_variable({0, 0, 0});
    const bool known = !memory.empty() && memory[feature].sigma_m > 0;
    const Point mean = known ? memory[feature].moved : Point(Point::Zero());
    const double sigma_m = known ? memory[feature].sigma_m : 0;
    if (const auto* face = std::get_if<Segment>(&map_.feature(feature).geometry))
      add_offset<1>(feature, offset, Eigen::Matrix<double, 1, 1>(mean.dot(face->normal())), sigma_m);
    else
      add_offset<2>(feature, offset, mean, sigma_m);
    link_to_epoch_before(feature, epoch);
    return offset;
  }

  /// Small or, at a price that hardly grows, large; and as remembered, if it is.
  template <int N>
  void add_offset(MapFeatureNumber feature, double* offset, const Eigen::Matrix<double, N, 1>& mean, double sigma_m) {
    using Mean = Eigen::Matrix<double, N, 1>;
    const double scale = std::max(options_.offset_scale_m, map_.feature(feature).position_sigma_m);
    problem_.AddParameterBlock(offset, N);
    problem_.AddResidualBlock(new OffsetFactor<N>(Mean::Zero(), scale), &offset_loss_, offset);
    if (sigma_m == 0) return;
    std::copy_n(mean.data(), N, offset);
    problem_.AddResidualBlock(new OffsetFactor<N>(mean, sigma_m), nullptr, offset);
  }

  /// Offsets change slowly over a batch: what all measurements of a face have in common (the laser's range, how
  /// straight it is) looks different from elsewhere, and must not be taken for where it stands.
  void link_to_epoch_before(MapFeatureNumber feature, int epoch) {
    const auto now = offsets_.find({feature, epoch});
    if (now == offsets_.begin()) return;
    const auto before = std::prev(now);
    if (before->first.first != feature) return;
    std::copy_n(before->second, size_of(feature), now->second);
    if (is_face(feature))
      problem_.AddResidualBlock(new OffsetLinkFactor<1>(options_.offset_memory_m), nullptr, before->second,
                                now->second);
    else
      problem_.AddResidualBlock(new OffsetLinkFactor<2>(options_.offset_memory_m), nullptr, before->second,
                                now->second);
  }

  static ceres::Problem::Options borrow_losses() {
    ceres::Problem::Options options;
    options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    return options;
  }

  const MapView& map_;
  const PoseTrackerOptions& options_;
  Point origin_;
  /// Never reallocated. The solver orders variables by address: side by side, they are in the same order in every run,
  /// and the last digits are, too.
  std::vector<Variable> variables_;
  std::vector<double*> poses_;
  struct Landmark {
    Segment thought;
    double* line;
  };
  std::vector<Landmark> landmarks_;
  std::map<std::pair<MapFeatureNumber, int>, double*> offsets_;  ///< by feature and epoch
  ceres::CauchyLoss measured_loss_, offset_loss_{1};
  ceres::Problem problem_{borrow_losses()};
};

}  // namespace opal
