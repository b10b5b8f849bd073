#include "local_map/local_map_graph.hpp"

#include "local_map/graph_factors.hpp"

#include <map>

namespace opal {
namespace {

// Poses nearer than this to the last one in the graph are not variables: they follow it rigidly. It keeps the graph
// at about 20 poses for a horizon of 6 m, whatever the rate of the scans.
constexpr double kPoseSpacing_m = 0.3;
constexpr double kPoseSpacing_rad = 0.3;

constexpr int kIterations = 5;  // starts near the solution; later steps move poses by less than a millimetre

/// A line (rho, psi), n = (cos psi, sin psi) its normal towards the visible side, rho = n . p for its points. The
/// residuals are those of (A.1) and (A.2) of the thesis, with two changes: the sign of rho follows the visible side
/// instead of the side of the origin, so that the two cases become one; and the distance is compared at the middle
/// of the measured piece instead of at the foot of the perpendicular, where it is independent of the angle.
class LineFactor : public ceres::SizedCostFunction<2, 3, 2> {
 public:
  explicit LineFactor(const Feature& measured)
      : middle_(std::get<Segment>(measured.geometry).midpoint()),
        normal_heading_(std::get<Segment>(measured.geometry).heading_rad() + std::numbers::pi / 2),
        W_(whitening<2>(measured.covariance.topLeftCorner<2, 2>(), {kLeastSigma_m, kLeastSigma_rad})) {}

  bool Evaluate(double const* const* v, double* residuals, double** jacobians) const override {
    const Turn base(v[0][2]);
    const Point normal = unit_vector(v[1][1]);
    const Point middle = Point(v[0][0], v[0][1]) + base.R * middle_;
    const Eigen::Vector2d e(normal.dot(middle) - v[1][0], wrap_angle(normal_heading_ + v[0][2] - v[1][1]));
    evaluate_seen_line(e, middle, base.dR * middle_, normal, left_of(normal), W_, residuals, jacobians);
    return true;
  }

 private:
  Point middle_;
  double normal_heading_;
  Eigen::Matrix2d W_;
};

/// A position seen from a pose: R^T (l - x) - z. Points and circle centres.
class PointFactor : public ceres::SizedCostFunction<2, 3, 2> {
 public:
  explicit PointFactor(const Feature& measured)
      : seen_(anchor_of(measured.geometry)),
        W_(whitening<2>(measured.covariance.topLeftCorner<2, 2>(), {kLeastSigma_m, kLeastSigma_m})) {}

  bool Evaluate(double const* const* v, double* residuals, double** jacobians) const override {
    const Point apart(v[1][0] - v[0][0], v[1][1] - v[0][1]);
    evaluate_seen_point(v[0][2], apart, seen_, W_, residuals, jacobians);
    return true;
  }

 private:
  Point seen_;
  Eigen::Matrix2d W_;
};

RelativePose seen_as_motion(const Feature& corner) {
  const auto& seen = std::get<OrientedPoint>(corner.geometry);
  return {{}, {}, Pose2(seen.position, seen.heading_rad), corner.covariance};
}

/// The factors of one measurement and the variables of one landmark, by shape. A corner is a pose seen from a pose.
ceres::CostFunction* factor_of(const Feature& measured) {
  switch (kind_of(measured.geometry)) {
    case GeometryKind::segment: return new LineFactor(measured);
    case GeometryKind::oriented_point: return new MotionFactor(seen_as_motion(measured));
    default: return new PointFactor(measured);
  }
}

Variable landmark_of(const Feature& feature, const Pose2& T_origin_local) {
  const Geometry geometry = transformed(T_origin_local, feature.geometry);
  if (const auto* corner = std::get_if<OrientedPoint>(&geometry))
    return {corner->position.x(), corner->position.y(), corner->heading_rad};
  const Point anchor = anchor_of(geometry);
  const auto* segment = std::get_if<Segment>(&geometry);
  if (!segment) return {anchor.x(), anchor.y(), 0};
  const double psi = segment->heading_rad() + std::numbers::pi / 2;
  return {unit_vector(psi).dot(anchor), psi, 0};
}

/// Ids of the keyframes that become variables: oldest and newest, and between them those that keep the spacing.
std::vector<std::size_t> choose_poses(const std::deque<Keyframe>& keyframes) {
  std::vector<std::size_t> chosen{0};
  for (std::size_t i = 1; i < keyframes.size(); ++i) {
    const Pose2& last = keyframes[chosen.back()].T_local_base;
    const Pose2& next = keyframes[i].T_local_base;
    if (i + 1 == keyframes.size() || distance_m(last, next) >= kPoseSpacing_m ||
        angle_between_rad(last, next) >= kPoseSpacing_rad)
      chosen.push_back(i);
  }
  return chosen;
}

/// Poses, landmarks and factors of one horizon, in a frame at the oldest pose: angles and distances stay small
/// however far the robot has come.
class Graph {
 public:
  /// @param most_landmarks  that will be added.
  Graph(const std::deque<Keyframe>& keyframes, std::size_t most_landmarks, const LocalMapOptions& options)
      : T_local_origin_(keyframes.front().T_local_base), options_(options) {
    const Pose2 T_origin_local = T_local_origin_.inverse();
    const std::vector<std::size_t> chosen = choose_poses(keyframes);
    variables_.reserve(chosen.size() + most_landmarks);
    for (const std::size_t index : chosen) {
      variables_.push_back(to_variable(T_origin_local * keyframes[index].T_local_base));
      poses_[keyframes[index].id] = variables_.back().data();
    }
    problem_.AddParameterBlock(poses_.begin()->second, 3);
    problem_.SetParameterBlockConstant(poses_.begin()->second);
  }

  void add_motions(const std::vector<RelativePose>& motions) {
    RelativePose chain;
    bool open = false;
    for (const RelativePose& motion : motions) {
      if (open) {
        chain.covariance = chained(chain, motion);
        chain.T_from_to = chain.T_from_to * motion.T_from_to;
        chain.to = motion.to;
      } else {
        chain = motion;
      }
      open = !poses_.contains(chain.to);
      if (!open && poses_.contains(chain.from))
        problem_.AddResidualBlock(new MotionFactor(chain), nullptr, poses_[chain.from], poses_[chain.to]);
    }
  }

  /// A landmark seen from one pose only says nothing about poses.
  void add_landmark(const LocalFeature& local) {
    std::vector<const Measurement*> measurements;
    for (const Measurement& m : local.measurements)
      if (poses_.contains(m.keyframe)) measurements.push_back(&m);
    if (measurements.size() < 2) return;
    variables_.push_back(landmark_of(local.feature, T_local_origin_.inverse()));
    landmarks_.push_back(variables_.back().data());
    for (const Measurement* m : measurements)
      problem_.AddResidualBlock(factor_of(m->feature), &loss_, poses_[m->keyframe], landmarks_.back());
  }

  bool solve() {
    if (landmarks_.empty() || poses_.size() < 2) return false;
    ceres::Solver::Options solver;
    solver.linear_solver_type = ceres::DENSE_SCHUR;
    solver.linear_solver_ordering = std::make_shared<ceres::ParameterBlockOrdering>();
    for (double* landmark : landmarks_) solver.linear_solver_ordering->AddElementToGroup(landmark, 0);
    for (const auto& [id, pose] : poses_)
      if (problem_.HasParameterBlock(pose)) solver.linear_solver_ordering->AddElementToGroup(pose, 1);
    solver.max_num_iterations = kIterations;
    solver.function_tolerance = 1e-4;
    solver.num_threads = 1;
    solver.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(solver, &problem_, &summary);
    return summary.IsSolutionUsable();
  }

  /// @return T_local_base for every keyframe: solved, or following the last solved one before it.
  std::vector<Pose2> poses_of(const std::deque<Keyframe>& keyframes) const {
    std::vector<Pose2> solved;
    Pose2 correction;
    for (const Keyframe& keyframe : keyframes) {
      if (const auto found = poses_.find(keyframe.id); found != poses_.end())
        correction = T_local_origin_ * to_pose({found->second[0], found->second[1], found->second[2]}) *
                     keyframe.T_local_base.inverse();
      solved.push_back(correction * keyframe.T_local_base);
    }
    return solved;
  }

 private:
  static ceres::Problem::Options borrow_loss() {
    ceres::Problem::Options options;
    options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    return options;
  }

  Pose2 T_local_origin_;
  const LocalMapOptions& options_;
  /// Poses, then landmarks, never reallocated. The solver orders variables by address: side by side, they are in the
  /// same order in every run, and the last digits are, too.
  std::vector<Variable> variables_;
  std::map<KeyframeId, double*> poses_;
  std::vector<double*> landmarks_;
  ceres::CauchyLoss loss_{options_.robust_scale};
  ceres::Problem problem_{borrow_loss()};
};

}  // namespace

bool optimize_poses(std::deque<Keyframe>& keyframes, const std::vector<LocalFeature>& features,
                    const std::vector<RelativePose>& motions, const LocalMapOptions& options) {
  if (keyframes.size() < 2) return false;
  Graph graph(keyframes, features.size(), options);
  graph.add_motions(motions);
  for (const LocalFeature& local : features) graph.add_landmark(local);
  if (!graph.solve()) return false;
  const std::vector<Pose2> solved = graph.poses_of(keyframes);
  for (const Pose2& pose : solved)
    if (!pose.position().allFinite() || !std::isfinite(pose.heading_rad())) return false;
  for (std::size_t i = 0; i < keyframes.size(); ++i) keyframes[i].T_local_base = solved[i];
  return true;
}

}  // namespace opal
