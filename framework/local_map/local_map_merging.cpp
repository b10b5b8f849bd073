#include "local_map/local_map_merging.hpp"

#include "local_map/local_map_association.hpp"

#include <Eigen/Dense>

#include <algorithm>

namespace opal {
namespace {

// What the pose of a keyframe adds to the error of a measurement, within one horizon: scan matching on recorded
// logs leaves 1 to 3 cm and about 0.3 degrees.
constexpr double kPoseSigma_m = 0.02;
constexpr double kPoseSigma_rad = 0.005;

constexpr int kRobustPasses = 2;

/// Weight of a residual of that many standard deviations, squared: Cauchy with scale 2.
double cauchy_weight(double squared) { return 1.0 / (1.0 + squared / 4.0); }

std::vector<Feature> in_local(const std::vector<Measurement>& measurements, const std::deque<Keyframe>& keyframes) {
  std::vector<Feature> moved;
  moved.reserve(measurements.size());
  for (const Measurement& m : measurements)
    moved.push_back(transformed(keyframe_of(keyframes, m.keyframe).T_local_base, m.feature));
  return moved;
}

// --- points, corners, circles: a vector of three numbers each -------------------------------------------------

struct ToVector {
  Eigen::Vector3d operator()(const Point& p) const { return {p.x(), p.y(), 0}; }
  Eigen::Vector3d operator()(const OrientedPoint& p) const { return {p.position.x(), p.position.y(), p.heading_rad}; }
  Eigen::Vector3d operator()(const Circle& c) const { return {c.center.x(), c.center.y(), c.radius_m}; }
  Eigen::Vector3d operator()(const Segment& s) const { return {s.midpoint().x(), s.midpoint().y(), 0}; }
};

struct SetVector {
  const Eigen::Vector3d& v;
  void operator()(Point& p) const { p = v.head<2>(); }
  void operator()(OrientedPoint& p) const {
    p.position = v.head<2>();
    p.heading_rad = wrap_angle(v.z());
  }
  void operator()(Circle& c) const {
    c.center = v.head<2>();
    c.radius_m = v.z();
  }
  void operator()(Segment&) const {}
};

Eigen::Matrix3d information_of(const Feature& feature) {
  const double third = kind_of(feature.geometry) == GeometryKind::oriented_point ? kPoseSigma_rad : kPoseSigma_m;
  Eigen::Matrix3d covariance = feature.covariance;
  covariance.diagonal() += Eigen::Vector3d(kPoseSigma_m, kPoseSigma_m, third).cwiseAbs2();
  return covariance.inverse();
}

Eigen::Vector3d difference(const Feature& a, const Eigen::Vector3d& b) {
  Eigen::Vector3d d = std::visit(ToVector{}, a.geometry) - b;
  if (kind_of(a.geometry) == GeometryKind::oriented_point) d.z() = wrap_angle(d.z());
  return d;
}

double mean_opening_rad(const std::vector<Feature>& views) {
  double sum = 0;
  for (const Feature& view : views) sum += std::get<OrientedPoint>(view.geometry).opening_rad;
  return sum / static_cast<double>(views.size());
}

Feature mean_of(const std::vector<Feature>& views) {
  Feature mean = views.back();
  Eigen::Vector3d estimate = std::visit(ToVector{}, mean.geometry);
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  for (int pass = 0; pass < kRobustPasses; ++pass) {
    information.setZero();
    Eigen::Vector3d pull = Eigen::Vector3d::Zero();
    for (const Feature& view : views) {
      const Eigen::Vector3d d = difference(view, estimate);
      const Eigen::Matrix3d own = information_of(view);
      const double weight = cauchy_weight(d.dot(own * d));
      information += weight * own;
      pull += weight * (own * d);
    }
    estimate += information.inverse() * pull;
  }
  std::visit(SetVector{estimate}, mean.geometry);
  mean.covariance = information.inverse();
  if (kind_of(mean.geometry) == GeometryKind::point) {
    mean.covariance.row(2).setZero();
    mean.covariance.col(2).setZero();
  }
  if (auto* corner = std::get_if<OrientedPoint>(&mean.geometry)) corner->opening_rad = mean_opening_rad(views);
  return mean;
}

// --- segments: the line through all pieces, then its ends ------------------------------------------------------

/// An infinite line through `origin` with its uncertainty there (offset [m], heading [rad]).
struct Line {
  Point origin;
  double heading_rad = 0;
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
};

const Feature& longest(const std::vector<Feature>& views) {
  return *std::max_element(views.begin(), views.end(), [](const Feature& a, const Feature& b) {
    return std::get<Segment>(a.geometry).length_m() < std::get<Segment>(b.geometry).length_m();
  });
}

Eigen::Matrix2d line_information(const Feature& view) {
  Eigen::Matrix2d covariance = view.covariance.topLeftCorner<2, 2>();
  covariance.diagonal() += Eigen::Vector2d(kPoseSigma_m, kPoseSigma_rad).cwiseAbs2();
  return covariance.inverse();
}

/// One weighted least-squares step: a piece with midpoint at distance s along the line sees offset + s * turn, and
/// the turn itself.
void fit_step(Line& line, const std::vector<Feature>& views) {
  const Point along = unit_vector(line.heading_rad);
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
  Eigen::Vector2d pull = Eigen::Vector2d::Zero();
  for (const Feature& view : views) {
    const auto& piece = std::get<Segment>(view.geometry);
    const Point offset = piece.midpoint() - line.origin;
    Eigen::Matrix2d model;
    model << 1, along.dot(offset), 0, 1;
    const Eigen::Vector2d seen(cross(along, offset), wrap_angle(piece.heading_rad() - line.heading_rad));
    const Eigen::Matrix2d own = line_information(view);
    const double weight = cauchy_weight(seen.dot(own * seen));
    information += weight * model.transpose() * own * model;
    pull += weight * model.transpose() * own * seen;
  }
  line.covariance = information.inverse();
  const Eigen::Vector2d step = line.covariance * pull;
  line.origin += step.x() * left_of(along);
  line.heading_rad += step.y();
}

Line line_through(const std::vector<Feature>& views) {
  const auto& first = std::get<Segment>(longest(views).geometry);
  Line line{first.midpoint(), first.heading_rad()};
  for (int pass = 0; pass < kRobustPasses; ++pass) fit_step(line, views);
  return line;
}

struct LineEnd {
  double outward_m;  ///< along the line, outwards
  bool is_true;
};

/// The end on one side: where a true end was seen, the mean of the outermost such sightings, unless a piece reaches
/// clearly beyond it; otherwise as far as any piece reaches.
LineEnd end_of(const std::vector<LineEnd>& seen, double tolerance_m) {
  double farthest = -1e300, farthest_true = -1e300;
  for (const LineEnd& end : seen) {
    farthest = std::max(farthest, end.outward_m);
    if (end.is_true) farthest_true = std::max(farthest_true, end.outward_m);
  }
  if (farthest_true < farthest - tolerance_m) return {farthest, false};
  double sum = 0;
  int count = 0;
  for (const LineEnd& end : seen) {
    if (!end.is_true || end.outward_m < farthest_true - tolerance_m) continue;
    sum += end.outward_m;
    ++count;
  }
  return {sum / count, true};
}

/// Length of the union of all pieces along the line [m], times the share of it that measurements cover.
double support_of(const std::vector<Feature>& views, const Line& line) {
  const Point along = unit_vector(line.heading_rad);
  std::vector<std::pair<double, double>> extents;
  double covered = 0, length = 0;
  for (const Feature& view : views) {
    const auto& piece = std::get<Segment>(view.geometry);
    extents.emplace_back(along.dot(piece.begin - line.origin), along.dot(piece.end - line.origin));
    covered += view.support_m;
    length += piece.length_m();
  }
  std::sort(extents.begin(), extents.end());
  double united = 0, reach = extents.front().first;
  for (const auto& [begin, end] : extents) {
    united += std::max(0.0, end - std::max(begin, reach));
    reach = std::max(reach, end);
  }
  return united * covered / length;
}

Feature joined(const std::vector<Feature>& views, const LocalMapOptions& options) {
  const Line line = line_through(views);
  const Point along = unit_vector(line.heading_rad);
  std::vector<LineEnd> begins, ends;
  Feature whole = views.back();
  for (const Feature& view : views) {
    const auto& piece = std::get<Segment>(view.geometry);
    begins.push_back({-along.dot(piece.begin - line.origin), view.true_end[0]});
    ends.push_back({along.dot(piece.end - line.origin), view.true_end[1]});
  }
  const LineEnd begin = end_of(begins, options.association_distance_m);
  const LineEnd end = end_of(ends, options.association_distance_m);
  whole.geometry = Segment{line.origin - begin.outward_m * along, line.origin + end.outward_m * along};
  whole.true_end = {begin.is_true, end.is_true};
  whole.support_m = support_of(views, line);
  Eigen::Matrix2d to_midpoint;  // offset at the midpoint = offset at the origin + distance * heading
  to_midpoint << 1, 0.5 * (end.outward_m - begin.outward_m), 0, 1;
  whole.covariance.setZero();
  whole.covariance.topLeftCorner<2, 2>() = to_midpoint * line.covariance * to_midpoint.transpose();
  return whole;
}

int count_distinct_poses(const LocalFeature& local, const std::deque<Keyframe>& keyframes,
                         const LocalMapOptions& options) {
  int count = 0;
  const Keyframe* last = nullptr;
  for (const Measurement& m : local.measurements) {
    const Keyframe& next = keyframe_of(keyframes, m.keyframe);
    if (last && distance_m(last->T_local_base, next.T_local_base) < options.pose_change_m &&
        angle_between_rad(last->T_local_base, next.T_local_base) < options.pose_change_rad)
      continue;
    last = &next;
    ++count;
  }
  return count;
}

bool share_a_keyframe(const LocalFeature& a, const LocalFeature& b) {
  return std::any_of(a.measurements.begin(), a.measurements.end(), [&](const Measurement& m) {
    return std::any_of(b.measurements.begin(), b.measurements.end(),
                       [&](const Measurement& n) { return n.keyframe == m.keyframe; });
  });
}

/// Pieces of a segment may be seen at once; two points seen at once are two.
bool are_pieces_of_one(const LocalFeature& a, const LocalFeature& b, const LocalMapOptions& options) {
  if (!association_cost(a.feature, b.feature, options)) return false;
  return kind_of(a.feature.geometry) == GeometryKind::segment || !share_a_keyframe(a, b);
}

void absorb(LocalFeature& keeper, const LocalFeature& other) {
  keeper.measurements.insert(keeper.measurements.end(), other.measurements.begin(), other.measurements.end());
  std::stable_sort(keeper.measurements.begin(), keeper.measurements.end(),
                   [](const Measurement& a, const Measurement& b) { return a.keyframe < b.keyframe; });
  keeper.stable = keeper.stable || other.stable;
}

}  // namespace

const Keyframe& keyframe_of(const std::deque<Keyframe>& keyframes, KeyframeId id) {
  return *std::lower_bound(keyframes.begin(), keyframes.end(), id,
                           [](const Keyframe& keyframe, KeyframeId wanted) { return keyframe.id < wanted; });
}

Feature estimate(const std::vector<Measurement>& measurements, const std::deque<Keyframe>& keyframes,
                 const LocalMapOptions& options) {
  const std::vector<Feature> views = in_local(measurements, keyframes);
  return kind_of(views.front().geometry) == GeometryKind::segment ? joined(views, options) : mean_of(views);
}

void refresh(LocalFeature& local, const std::deque<Keyframe>& keyframes, const LocalMapOptions& options) {
  local.feature = estimate(local.measurements, keyframes, options);
  local.distinct_poses = count_distinct_poses(local, keyframes, options);
  local.stable = local.stable || local.distinct_poses >= options.stable_after;
  local.last_keyframe = local.measurements.back().keyframe;
}

void merge_pieces(std::vector<LocalFeature>& features, std::vector<LocalFeatureId>& renamed,
                  const std::deque<Keyframe>& keyframes, const LocalMapOptions& options) {
  for (std::size_t a = 0; a < features.size(); ++a) {
    for (std::size_t b = a + 1; b < features.size();) {
      if (!are_pieces_of_one(features[a], features[b], options)) {
        ++b;
        continue;
      }
      absorb(features[a], features[b]);
      refresh(features[a], keyframes, options);
      std::replace(renamed.begin(), renamed.end(), features[b].id, features[a].id);
      features.erase(features.begin() + static_cast<std::ptrdiff_t>(b));
      b = a + 1;  // the longer one may now reach others
    }
  }
}

}  // namespace opal
