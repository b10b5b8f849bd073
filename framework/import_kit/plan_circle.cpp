#include <opal/import_kit/plan_assembly.hpp>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace opal {
namespace {

constexpr std::size_t kMinPoints = 12;
constexpr double kMaxGap_rad = std::numbers::pi / 3;
constexpr double kMaxChords = 720;

/// Least squares of x^2 + y^2 - 2 a x - 2 b y - c (Kasa 1976): exact where all points lie on a circle.
std::optional<Circle> fit_algebraic(const std::vector<Point>& points) {
  Point mean = Point::Zero();
  for (const Point& p : points) mean += p / static_cast<double>(points.size());
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const Point& p : points) {
    const Point q = p - mean;
    const Eigen::Vector3d row(2 * q.x(), 2 * q.y(), 1);
    normal += row * row.transpose();
    right += row * q.squaredNorm();
  }
  const Eigen::FullPivLU<Eigen::Matrix3d> lu(normal);
  if (!lu.isInvertible()) return std::nullopt;
  const Eigen::Vector3d solution = lu.solve(right);
  const double radius = std::sqrt(solution.z() + solution.head<2>().squaredNorm());
  if (!std::isfinite(radius)) return std::nullopt;
  return Circle{mean + solution.head<2>(), radius};
}

/// Going around once, in one direction, without large steps.
bool goes_around(const std::vector<Point>& points, const Point& centre) {
  double total = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Point a = points[k] - centre, b = points[(k + 1) % points.size()] - centre;
    const double step = std::atan2(cross(a, b), a.dot(b));
    if (std::abs(step) > kMaxGap_rad) return false;
    total += step;
  }
  return std::abs(std::abs(total) - 2 * std::numbers::pi) < 1e-3;
}

}  // namespace

std::optional<Circle> circle_drawn_by(const std::vector<Point>& closed_line, double tolerance_m) {
  if (closed_line.size() < kMinPoints) return std::nullopt;
  const std::optional<Circle> circle = fit_algebraic(closed_line);
  if (!circle || circle->radius_m <= tolerance_m) return std::nullopt;
  const bool fits = std::all_of(closed_line.begin(), closed_line.end(), [&](const Point& p) {
    return std::abs((p - circle->center).norm() - circle->radius_m) <= tolerance_m;
  });
  return fits && goes_around(closed_line, circle->center) ? circle : std::nullopt;
}

std::vector<Point> arc_points(const Circle& circle, double from_rad, double sweep_rad, double tolerance_m) {
  // A chord over the angle w is r (1 - cos(w / 2)) away from its arc.
  const double step_rad =
      circle.radius_m > tolerance_m ? 2 * std::acos(1 - tolerance_m / circle.radius_m) : std::numbers::pi / 2;
  const double wanted = std::ceil(std::abs(sweep_rad) / std::max(step_rad, 1e-6));
  const int chords = static_cast<int>(std::clamp(wanted, 1.0, kMaxChords));
  std::vector<Point> points;
  for (int k = 0; k <= chords; ++k)
    points.push_back(circle.center + circle.radius_m * unit_vector(from_rad + sweep_rad * k / chords));
  return points;
}

}  // namespace opal
