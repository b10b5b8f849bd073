#include "matcher.hpp"

#include "pose_search.hpp"

#include <opal/sensing/point_runs.hpp>

#include <algorithm>
#include <array>
#include <numbers>
#include <vector>

namespace opal::point_to_line {
namespace {

constexpr std::size_t kFewestPoints = 10;
constexpr double kJump_m = 0.25;      ///< steps between neighbours longer than this count as this when thinning
constexpr double kLeastSigma = 1e-4;  ///< [m], [rad]: a guess is never certain
constexpr double kMostDoubt = 4;      ///< standard deviations that a match may lie off the guess, beyond the search

std::vector<Point> finite(std::span<const Point> points) {
  std::vector<Point> kept;
  kept.reserve(points.size());
  std::copy_if(points.begin(), points.end(), std::back_inserter(kept),
               [](const Point& p) { return p.allFinite() && p.cwiseAbs().maxCoeff() < 1e6; });
  return kept;
}

/// Points whose neighbours are far from them because the beams graze the surface say where the beams went, not where
/// along the surface they are: they would tie a scan of a corridor to the place of the one before.
bool is_sparse_by_grazing(const Point& a, const Point& b) {
  constexpr double kDense_m = 0.15, kGrazing = 4;
  const double step_m = (b - a).norm();
  const double across_m = std::abs(cross(a, b)) / std::max(a.norm(), 1e-9);
  return step_m > kDense_m && step_m > kGrazing * across_m;
}

std::vector<Point> without_grazed(const std::vector<Point>& points) {
  std::vector<Point> kept;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    if (!is_sparse_by_grazing(points[i], points[i + 1])) kept.push_back(points[i]);
  return kept;
}

/// Whatever a person may be counts as a few points, so that one who walks along does not outvote odometry.
std::vector<Point> with_few_that_may_walk(const std::vector<Point>& points) {
  constexpr std::size_t kFew = 2;
  std::vector<Point> kept;
  for (const PointRun& run : point_runs(points)) {
    const std::size_t step = run.may_walk ? std::max<std::size_t>(1, (run.end - run.first) / kFew) : 1;
    for (std::size_t k = run.first + step / 2; k < run.end; k += step) kept.push_back(points[k]);
  }
  return kept;
}

double capped_step_m(const Point& a, const Point& b) { return std::min(kJump_m, (a - b).norm()); }

/// About `count` points, evenly along the outline rather than by bearing, so that near walls do not outvote far ones.
std::vector<Point> evenly(const std::vector<Point>& points, int count) {
  double length_m = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length_m += capped_step_m(points[i - 1], points[i]);
  const double spacing_m = length_m / count;
  std::vector<Point> chosen{points.front()};
  double since_m = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    since_m += capped_step_m(points[i - 1], points[i]);
    if (since_m < spacing_m) continue;
    chosen.push_back(points[i]);
    since_m = std::fmod(since_m, std::max(spacing_m, 1e-9));
  }
  return chosen;
}

double bearing_of(const Point& p) { return std::atan2(p.y(), p.x()); }

/// In which directions from a pose something is known.
class KnownBearings {
 public:
  KnownBearings(std::span<const Point> known, const Pose2& T_reference_eye) {
    constexpr std::size_t kEvery = 4;  // neighbours are a few centimetres apart
    const Pose2 T_eye_reference = T_reference_eye.inverse();
    for (std::size_t k = 0; k < known.size(); k += kEvery) {
      const int bin = bin_of(bearing_of(T_eye_reference * known[k]));
      for (int beside = -1; beside <= 1; ++beside) known_[wrapped(bin + beside)] = true;
    }
  }
  bool holds(double bearing) const { return known_[wrapped(bin_of(bearing))]; }

 private:
  static constexpr int kBins = 180;
  static int bin_of(double bearing) { return static_cast<int>(std::floor(bearing * kBins / (2 * std::numbers::pi))); }
  static std::size_t wrapped(int bin) { return static_cast<std::size_t>((bin % kBins + kBins) % kBins); }
  std::array<bool, kBins> known_ = {};
};

/// Points in directions in which the reference has any, also if the guess is turned by a standard deviation. What comes
/// into view for the first time has nothing to be matched with: it would speak for turning less.
std::vector<Point> seen_before(const std::vector<Point>& scan, std::span<const Point> reference, const Prior& prior) {
  const KnownBearings known(reference, prior.T_reference_scan);
  std::vector<Point> before;
  for (const Point& point : scan) {
    const double bearing = bearing_of(point);
    if (known.holds(bearing - prior.sigma.z()) && known.holds(bearing + prior.sigma.z())) before.push_back(point);
  }
  return before;
}

bool is_far_from(const Prior& prior, const Pose2& pose, double sigmas) {
  const Point away = (pose.position() - prior.T_reference_scan.position()).cwiseQuotient(prior.sigma.head<2>());
  const double turned = angle_between_rad(pose, prior.T_reference_scan) / prior.sigma.z();
  return away.norm() > std::sqrt(2.0) * sigmas || turned > sigmas;
}

}  // namespace

ScanMatch PointToLineMatcher::match(std::span<const Point> reference, std::span<const Point> scan, const Pose2& guess,
                                    const Eigen::Vector3d& guess_sigma) const {
  const Prior prior{guess, guess_sigma.cwiseMax(kLeastSigma)};
  ScanMatch nothing;
  nothing.T_reference_scan = guess;
  nothing.covariance = prior.sigma.cwiseAbs2().asDiagonal();
  const std::vector<Point> known = finite(reference);
  const std::vector<Point> all = finite(scan), seen = seen_before(all, known, prior);
  const std::vector<Point> dense = without_grazed(seen);
  if (dense.size() < kFewestPoints || known.size() < kFewestPoints || !prior.sigma.allFinite()) return nothing;

  const ReferenceGrid grid(known);
  const std::vector<Pose2> starts = search_poses(grid, with_few_that_may_walk(evenly(dense, options_.search_points)),
                                                 guess, prior.sigma, options_.search_sigmas);
  const std::vector<Point> points = with_few_that_may_walk(evenly(seen, options_.max_points));
  Refined best = refine(grid, points, starts.front(), prior, options_.refinement);
  for (std::size_t i = 1; i < starts.size(); ++i) {
    const Refined other = refine(grid, points, starts[i], prior, options_.refinement);
    if (other.cost < best.cost) best = other;
  }
  if (!best.match.converged) return nothing;
  best.match.inlier_share =
      inlier_share(grid, evenly(all, options_.max_points), best.match.T_reference_scan, options_.refinement);
  best.match.converged = best.match.inlier_share >= options_.min_inlier_share &&
                         !is_far_from(prior, best.match.T_reference_scan, options_.search_sigmas + kMostDoubt);
  return best.match;
}

}  // namespace opal::point_to_line
