#include "survey/scan_on_map.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <optional>

namespace opal {
namespace {

constexpr std::size_t kFewestPoints = 5, kFewestPointsOfMoved = 8;
constexpr double kShortestFace_m = 0.25;    ///< covered; shorter pieces have no direction of their own
constexpr double kShortestMoved_m = 0.6;    ///< of a face that is taken for one elsewhere
constexpr double kLeastShareOfMoved = 0.4;  ///< of its length, of such a face
constexpr double kShareInPlace = 0.3;     ///< of a face's length, that leaves no doubt that it is where it is believed
constexpr double kWidestTurn_rad = 0.12;  ///< between a mapped face and the same one in the scan
constexpr double kLargestRms_m = 0.04;
// Errors that all points of a face share: how flat it is, how well it was drawn.
constexpr double kFaceSigma_m = 0.015, kFaceSigma_rad = 0.01, kDrawnSigma_m = 0.02;
constexpr double kReadingSigma_m = 0.025;

/// A line through points by total least squares.
struct FittedFace {
  Segment segment;  ///< visible side on the left
  double covered_m = 0, rms_m = 0;
  Eigen::Matrix2d covariance;  ///< (offset at the midpoint, heading)
};

double covered_by(std::vector<double>& along) {
  constexpr double kGap_m = 0.5;
  std::sort(along.begin(), along.end());
  double covered = 0;
  for (std::size_t k = 1; k < along.size(); ++k) covered += std::min(kGap_m, along[k] - along[k - 1]);
  return covered;
}

FittedFace fit_face(const std::vector<Point>& points, const Point& laser) {
  Point mean = Point::Zero();
  for (const Point& p : points) mean += p / static_cast<double>(points.size());
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const Point& p : points) scatter += (p - mean) * (p - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(scatter);
  Point direction = axes.eigenvectors().col(1);
  if (left_of(direction).dot(laser - mean) < 0) direction = -direction;
  std::vector<double> along;
  for (const Point& p : points) along.push_back(direction.dot(p - mean));
  FittedFace face;
  face.covered_m = covered_by(along);
  face.segment = {mean + along.front() * direction, mean + along.back() * direction};
  face.rms_m = std::sqrt(std::max(0.0, axes.eigenvalues()(0)) / static_cast<double>(points.size()));
  const double variance = kReadingSigma_m * kReadingSigma_m;
  const double middle = 0.5 * (along.front() + along.back());
  const double heading = variance / std::max(1e-6, axes.eigenvalues()(1));
  face.covariance << variance / static_cast<double>(points.size()) + middle * middle * heading, middle * heading,
      middle * heading, heading;
  return face;
}

MapMeasurement to_measurement(MapFeatureNumber number, const FittedFace& face, double mapped_length_m) {
  Eigen::Matrix2d covariance = face.covariance;
  const double drawn = kDrawnSigma_m / std::max(0.3, mapped_length_m);
  covariance(0, 0) += kFaceSigma_m * kFaceSigma_m;
  covariance(1, 1) += kFaceSigma_rad * kFaceSigma_rad + drawn * drawn;
  return {number, face.segment, covariance};
}

/// A few points of a face: they tell how far it is, not its direction.
MapMeasurement glimpse(const ExpectedFeature& feature, const std::vector<Point>& points, const Pose2& T_map_base) {
  constexpr double kLevelSigma_m = 0.08, kNoIdea_rad = 10;
  Point mean = Point::Zero();
  for (const Point& p : points) mean += p / static_cast<double>(points.size());
  const Point half = 0.005 * T_map_base.inverse().rotate(feature.surface.direction);
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  covariance(0, 0) = kLevelSigma_m * kLevelSigma_m / static_cast<double>(points.size()) + kFaceSigma_m * kFaceSigma_m;
  covariance(1, 1) = kNoIdea_rad * kNoIdea_rad;
  return {feature.number, Segment{mean - half, mean + half}, covariance};
}

/// The centre of a circle of known radius through points of its rim.
std::optional<MapMeasurement> fit_column(MapFeatureNumber number, double radius_m, const std::vector<Point>& points,
                                         Point center) {
  constexpr double kShareAcross = 0.8;  // of the diameter: otherwise it may be any corner
  constexpr int kSteps = 5;
  if (points.size() < kFewestPoints) return std::nullopt;
  double widest = 0;
  for (const Point& p : points) widest = std::max(widest, (p - points.front()).norm());
  if (widest < kShareAcross * radius_m) return std::nullopt;
  Eigen::Matrix2d H;
  for (int step = 0; step < kSteps; ++step) {
    H = 1e-6 * Eigen::Matrix2d::Identity();
    Point g = Point::Zero();
    for (const Point& p : points) {
      const Point from = center - p;
      const double distance = std::max(1e-3, from.norm());
      H += from * from.transpose() / (distance * distance);
      g += from / distance * (distance - radius_m);
    }
    center -= H.ldlt().solve(g);
  }
  if (!center.allFinite()) return std::nullopt;
  double squares = 0;
  for (const Point& p : points) squares += std::pow((p - center).norm() - radius_m, 2);
  if (std::sqrt(squares / static_cast<double>(points.size())) > kLargestRms_m) return std::nullopt;
  const Eigen::Matrix2d covariance =
      kReadingSigma_m * kReadingSigma_m * H.inverse() + 0.02 * 0.02 * Eigen::Matrix2d::Identity();
  return MapMeasurement{number, Circle{center, radius_m}, covariance};
}

/// A scan's points, sorted out among expected surfaces.
class Sorting {
 public:
  Sorting(const ExpectedFeatures& expected, std::span<const Point> points, const Point& laser, const Pose2& T_map_base)
      : expected_(expected),
        points_(points),
        laser_(laser),
        T_(T_map_base),
        eye_(T_map_base * laser),
        own_(expected.all().size()) {
    for (const Point& point : points) {
      const int k = expected.nearest(eye_, T_ * point, kOnSurface_m);
      if (k >= 0)
        own_[k].push_back(point);
      else
        left_over_.push_back(point);
    }
  }

  const std::vector<Point>& on(std::size_t k) const { return own_[k]; }

  /// Points that belong to nothing and lie along a face at one distance from it, where most of them do.
  std::vector<Point> beside(std::size_t k, double within_m) const {
    constexpr double kBin_m = 0.05;
    const Surface& face = expected_.all()[k].surface;
    const int bins = static_cast<int>(within_m / kBin_m);
    std::vector<int> count(2 * bins + 1, 0);
    std::vector<std::pair<double, Point>> candidates;
    for (const Point& point : left_over_) {
      const Point p = T_ * point;
      const SurfaceOffset at = offset_from(face, p);
      if (std::abs(at.offset_m) > within_m || at.along_m < 0 || at.along_m > face.size_m ||
          at.normal.dot(p - eye_) >= 0)
        continue;
      candidates.emplace_back(at.offset_m, point);
      ++count[bins + static_cast<int>(std::lround(at.offset_m / kBin_m))];
    }
    if (candidates.size() < kFewestPoints) return {};
    const auto most = std::max_element(count.begin(), count.end()) - count.begin() - bins;
    std::vector<Point> chosen;
    for (const auto& [offset, point] : candidates)
      if (std::abs(offset - static_cast<double>(most) * kBin_m) < 2 * kBin_m) chosen.push_back(point);
    return chosen;
  }

 private:
  const ExpectedFeatures& expected_;
  std::span<const Point> points_;
  Point laser_;
  Pose2 T_;
  Point eye_;
  std::vector<std::vector<Point>> own_;
  std::vector<Point> left_over_;
};

bool parallel(const Segment& seen, const Pose2& T_map_base, const Surface& face) {
  const Point direction = T_map_base.rotate(seen.direction());
  return direction.dot(face.direction) > 0 && std::abs(cross(direction, face.direction)) < std::sin(kWidestTurn_rad);
}

/// Points that lie where a face is believed to be.
MapMeasurement measure_in_place(const ExpectedFeature& feature, const std::vector<Point>& points, const Point& laser,
                                const Pose2& T_map_base) {
  if (points.size() >= kFewestPoints) {
    const FittedFace face = fit_face(points, laser);
    if (face.covered_m >= kShortestFace_m && face.rms_m < kLargestRms_m &&
        parallel(face.segment, T_map_base, feature.surface))
      return to_measurement(feature.number, face, feature.surface.size_m);
  }
  return glimpse(feature, points, T_map_base);
}

/// A line elsewhere that may be a face which is not where it is believed to be.
std::optional<MapMeasurement> measure_elsewhere(const ExpectedFeature& feature, const std::vector<Point>& points,
                                                const Point& laser, const Pose2& T_map_base) {
  if (points.size() < kFewestPointsOfMoved) return std::nullopt;
  const FittedFace face = fit_face(points, laser);
  const double least_m = std::max(kShortestMoved_m, kLeastShareOfMoved * feature.surface.size_m);
  if (face.covered_m < least_m || face.rms_m >= kLargestRms_m || !parallel(face.segment, T_map_base, feature.surface))
    return std::nullopt;
  return to_measurement(feature.number, face, feature.surface.size_m);
}

std::optional<MapMeasurement> look_for(std::size_t k, const ExpectedFeature& feature, const Sorting& sorted,
                                       const Point& laser, const Pose2& T_map_base, const PoseTrackerOptions& options) {
  const std::vector<Point>& own = sorted.on(k);
  if (feature.surface.is_circle()) {
    const Point center = T_map_base.inverse() * feature.surface.origin;
    return fit_column(feature.number, feature.surface.size_m, own, center);
  }
  std::optional<MapMeasurement> in_place, elsewhere;
  if (!own.empty()) in_place = measure_in_place(feature, own, laser, T_map_base);
  if (in_place && covered_m(*in_place) > kShareInPlace * feature.surface.size_m) return in_place;
  if (feature.surface.size_m < kShortestMoved_m) return in_place;
  const std::vector<Point> beside = sorted.beside(k, options.wall_error_m);
  if (beside.size() > 2 * own.size()) elsewhere = measure_elsewhere(feature, beside, laser, T_map_base);
  return elsewhere ? elsewhere : in_place;
}

}  // namespace

double covered_m(const MapMeasurement& measurement) {
  const auto* segment = std::get_if<Segment>(&measurement.seen);
  if (segment) return segment->length_m();
  const auto* circle = std::get_if<Circle>(&measurement.seen);
  return circle ? 2 * circle->radius_m : 0;
}

std::vector<MapMeasurement> measure(const ExpectedFeatures& expected, std::span<const Point> points, const Point& laser,
                                    const Pose2& T_map_base, const PoseTrackerOptions& options) {
  const Sorting sorted(expected, points, laser, T_map_base);
  std::vector<MapMeasurement> found;
  for (std::size_t k = 0; k < expected.all().size(); ++k)
    if (auto measured = look_for(k, expected.all()[k], sorted, laser, T_map_base, options))
      found.push_back(std::move(*measured));
  std::stable_sort(found.begin(), found.end(),
                   [](const MapMeasurement& a, const MapMeasurement& b) { return covered_m(a) > covered_m(b); });
  if (found.size() > static_cast<std::size_t>(options.features_per_scan)) found.resize(options.features_per_scan);
  return found;
}

}  // namespace opal
