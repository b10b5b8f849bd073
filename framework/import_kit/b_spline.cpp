#include <opal/import_kit/b_spline.hpp>

#include <algorithm>
#include <cmath>

namespace opal {
namespace {

constexpr int kMaxDegree = 25;
// A span is halved until its chords are near enough, and no further than this.
constexpr int kMaxHalvings = 10;
// Where a curve and its chord are compared; an inflexion in the middle must not hide what lies beside it.
constexpr double kProbes[] = {0.21, 0.5, 0.79};

std::size_t degree_of(const BSpline& spline) { return static_cast<std::size_t>(spline.degree); }

/// The k with knots[k] <= parameter < knots[k + 1], among the spans of the curve.
std::size_t span_at(const BSpline& spline, double parameter) {
  const auto first = spline.knots.begin() + spline.degree;
  const auto last = spline.knots.begin() + static_cast<std::ptrdiff_t>(spline.control_points.size());
  auto after = std::upper_bound(first, last, parameter);
  while (after != first + 1 && *(after - 1) == *after) --after;  // at the end: the last span that has a length
  return static_cast<std::size_t>(after - spline.knots.begin()) - 1;
}

double distance(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector3d along = b - a;
  const double length2 = along.squaredNorm();
  const double t = length2 > 0 ? std::clamp(along.dot(p - a) / length2, 0.0, 1.0) : 0;
  return (p - a - t * along).norm();
}

/// Adds the points after `from` up to `to`.
void add_span(const BSpline& spline, double from, double to, double tolerance, int halvings,
              std::vector<Eigen::Vector3d>& points) {
  const Eigen::Vector3d end = point_at(spline, to);
  const Eigen::Vector3d begin = points.back();
  const bool is_near = std::all_of(std::begin(kProbes), std::end(kProbes), [&](double share) {
    return distance(point_at(spline, from + share * (to - from)), begin, end) <= tolerance;
  });
  if (is_near || halvings == 0) {
    points.push_back(end);
    return;
  }
  const double middle = (from + to) / 2;
  add_span(spline, from, middle, tolerance, halvings - 1, points);
  add_span(spline, middle, to, tolerance, halvings - 1, points);
}

}  // namespace

std::string fault_of(const BSpline& spline) {
  const std::size_t points = spline.control_points.size(), knots = spline.knots.size();
  if (spline.degree < 1 || spline.degree > kMaxDegree) return "a spline of degree " + std::to_string(spline.degree);
  if (points <= degree_of(spline))
    return "a spline of degree " + std::to_string(spline.degree) + " with " + std::to_string(points) +
           " control points";
  if (knots != points + degree_of(spline) + 1)
    return "a spline with " + std::to_string(knots) + " knots, expected " +
           std::to_string(points + degree_of(spline) + 1);
  const auto is_finite = [](double value) { return std::isfinite(value); };
  if (!std::ranges::all_of(spline.knots, is_finite) || !std::ranges::is_sorted(spline.knots) ||
      !(spline.knots[points] > spline.knots[degree_of(spline)]))
    return "a spline whose knots do not rise";
  if (!spline.weights.empty() && spline.weights.size() != points)
    return "a spline with a weight for some control points only";
  if (!std::ranges::all_of(spline.weights, [](double weight) { return weight > 1e-9 && weight < 1e9; }))
    return "a spline with weights that are not positive";
  if (!std::ranges::all_of(spline.control_points, [](const auto& p) { return p.allFinite(); }))
    return "a spline with a control point that is nowhere";
  return "";
}

Eigen::Vector3d point_at(const BSpline& spline, double parameter) {
  const std::size_t degree = degree_of(spline), span = span_at(spline, parameter);
  std::vector<Eigen::Vector4d> d(degree + 1);  // homogeneous
  for (std::size_t j = 0; j <= degree; ++j) {
    const std::size_t k = span - degree + j;
    const double weight = spline.weights.empty() ? 1 : spline.weights[k];
    d[j] << weight * spline.control_points[k], weight;
  }
  for (std::size_t round = 1; round <= degree; ++round)
    for (std::size_t j = degree; j >= round; --j) {
      const double low = spline.knots[span - degree + j], high = spline.knots[span + 1 + j - round];
      const double share = high > low ? (parameter - low) / (high - low) : 0;
      d[j] = (1 - share) * d[j - 1] + share * d[j];
    }
  return d[degree].head<3>() / d[degree].w();
}

std::vector<Eigen::Vector3d> chord_points(const BSpline& spline, double tolerance) {
  const std::size_t last = spline.control_points.size();
  std::vector<Eigen::Vector3d> points{point_at(spline, spline.knots[degree_of(spline)])};
  for (std::size_t k = degree_of(spline); k < last; ++k)
    if (spline.knots[k + 1] > spline.knots[k])
      add_span(spline, spline.knots[k], spline.knots[k + 1], tolerance, kMaxHalvings, points);
  return points;
}

}  // namespace opal
