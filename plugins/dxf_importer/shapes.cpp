#include "shapes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace opal::dxf_importer {
namespace {

constexpr double kStraightBulge = 1e-6;
constexpr double kSimilarity = 1e-6;
constexpr double kSamePoint_m = 1e-6;

class Drawer {
 public:
  Drawer(const PlacedEntity& placed, const ShapeOptions& options, PlanSides closed_sides, Shapes& shapes)
      : options_(options), closed_sides_(closed_sides), shapes_(shapes), T_(placed.T_drawing_entity) {
    T_ = Eigen::Translation2d(-options.origin_m) *
         Eigen::AlignedScaling2d(options.metres_per_unit, options.metres_per_unit) * T_;
    const Eigen::Vector2d x = T_.linear().col(0), y = T_.linear().col(1);
    scale_ = std::max(x.norm(), y.norm());
    is_similarity_ =
        std::abs(x.dot(y)) <= kSimilarity * scale_ * scale_ && std::abs(x.norm() - y.norm()) <= kSimilarity * scale_;
  }

  std::string operator()(const std::monostate&) { return "entities of this type are not read"; }
  std::string operator()(const DxfInsert&) { return "it is not in model space"; }

  std::string operator()(const DxfPath& path) {
    if (is_similarity_) shapes_.width_m = path.width * scale_;
    if (const auto circle = ring_of(path)) return (*this)(*circle);
    add_line(moved(flattened(path.vertices, path.closed)), path.closed);
    return path.vertices.size() < 2 ? "it has fewer than two vertices" : "";
  }

  std::string operator()(const Circle& circle) {
    if (circle.radius_m <= 0) return "its radius is not positive";
    const double radius_m = circle.radius_m * scale_;
    if (is_similarity_ && radius_m <= options_.max_column_radius_m) {
      shapes_.circles.push_back({T_ * circle.center, radius_m});
      return "";
    }
    ++shapes_.chorded;
    std::vector<Point> points = moved(arc(circle, 0, 2 * std::numbers::pi));
    points.pop_back();
    shapes_.lines.push_back({std::move(points), true, closed_sides_});
    return "";
  }

  std::string operator()(const DxfArc& arc_of) {
    if (arc_of.circle.radius_m <= 0) return "its radius is not positive";
    ++shapes_.chorded;
    add_line(moved(arc(arc_of.circle, arc_of.from_rad, arc_of.sweep_rad)), false);
    return "";
  }

  std::string operator()(const DxfEllipse& ellipse) {
    const double size = std::max(ellipse.major.norm(), ellipse.minor.norm());
    if (!(std::min(ellipse.major.norm(), ellipse.minor.norm()) > 0)) return "it is flat";
    std::vector<Point> points;
    for (const Point& p : arc_points({Point::Zero(), 1}, ellipse.from_rad, ellipse.sweep_rad,
                                     options_.chord_tolerance_m / (scale_ * size)))
      points.push_back(ellipse.center + p.x() * ellipse.major + p.y() * ellipse.minor);
    add_curve(std::move(points));
    return "";
  }

  std::string operator()(const BSpline& spline) {
    std::vector<Point> points;
    for (const Eigen::Vector3d& p : chord_points(spline, options_.chord_tolerance_m / scale_))
      points.push_back(p.head<2>());
    add_curve(std::move(points));
    return "";
  }

  std::string operator()(const DxfLines& lines) {
    for (const DxfPath& path : lines.lines) add_line(moved(flattened(path.vertices, path.closed)), path.closed);
    return "";
  }

  /// Loops inside each other are holes.
  std::string operator()(const DxfFill& fill) {
    closed_sides_ = PlanSides::solid;
    std::size_t used = 0;
    for (const auto& loop : fill.loops) {
      if (loop.size() < 2) continue;
      std::vector<Point> points = moved(flattened(loop, true));
      if (fill.loops.size() == 1)
        add_line(std::move(points), true);
      else
        shapes_.lines.push_back({std::move(points), true, PlanSides::solid});
      ++used;
    }
    return used == 0 ? "it has no boundary that can be read" : "";
  }

 private:
  /// Two half circles, as DONUT draws them.
  static std::optional<Circle> ring_of(const DxfPath& path) {
    if (!path.closed || path.vertices.size() != 2) return std::nullopt;
    const DxfVertex &a = path.vertices.front(), &b = path.vertices.back();
    if (std::abs(std::abs(a.bulge) - 1) > kStraightBulge || std::abs(a.bulge - b.bulge) > kStraightBulge)
      return std::nullopt;
    return Circle{(a.position + b.position) / 2, (b.position - a.position).norm() / 2};
  }

  std::vector<Point> arc(const Circle& circle, double from_rad, double sweep_rad) const {
    return arc_points(circle, from_rad, sweep_rad, options_.chord_tolerance_m / scale_);
  }

  std::vector<Point> moved(std::vector<Point> points) const {
    for (Point& p : points) p = T_ * p;
    return points;
  }

  /// All points in order; of a closed line, the first is not repeated.
  std::vector<Point> flattened(const std::vector<DxfVertex>& vertices, bool closed) {
    std::vector<Point> points;
    was_curved_ = false;
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      points.push_back(vertices[k].position);
      if (k + 1 == vertices.size() && !closed) break;
      const std::vector<Point> between = bulge_points(vertices[k], vertices[(k + 1) % vertices.size()].position);
      was_curved_ |= !between.empty();
      points.insert(points.end(), between.begin(), between.end());
    }
    shapes_.chorded += was_curved_;
    return points;
  }

  /// On the arc to the next vertex, both ends left out.
  std::vector<Point> bulge_points(const DxfVertex& vertex, const Point& next) const {
    const Point chord = next - vertex.position;
    const double b = vertex.bulge;
    if (std::abs(b) < kStraightBulge || chord.norm() == 0) return {};
    const Point centre = vertex.position + chord / 2 + left_of(chord) * (1 - b * b) / (4 * b);
    const Point from = vertex.position - centre;
    std::vector<Point> points = arc({centre, from.norm()}, std::atan2(from.y(), from.x()), 4 * std::atan(b));
    points.erase(points.begin());
    points.pop_back();
    return points;
  }

  void add_curve(std::vector<Point> points) {
    ++shapes_.chorded;
    was_curved_ = true;
    add_line(moved(std::move(points)), false);
  }

  void add_line(std::vector<Point> points, bool closed) {
    if (points.size() > 2 && (points.front() - points.back()).norm() < kSamePoint_m) {
      points.pop_back();
      closed = true;
    }
    if (closed)
      if (const auto circle = circle_drawn_by(points, options_.circle_tolerance_m);
          circle && circle->radius_m <= options_.max_column_radius_m) {
        shapes_.circles.push_back(*circle);
        ++shapes_.refitted;
        shapes_.chorded -= was_curved_;
        return;
      }
    shapes_.lines.push_back({std::move(points), closed, closed ? closed_sides_ : PlanSides::to_find});
  }

  const ShapeOptions& options_;
  PlanSides closed_sides_;
  Shapes& shapes_;
  Eigen::Affine2d T_;  ///< from the entity to the map [m]
  double scale_ = 1;
  bool is_similarity_ = true;
  bool was_curved_ = false;  ///< the line that was made straight last
};

}  // namespace

std::string add_shape(const PlacedEntity& placed, const ShapeOptions& options, PlanSides closed_sides, Shapes& shapes) {
  return std::visit(Drawer(placed, options, closed_sides, shapes), placed.entity->shape);
}

}  // namespace opal::dxf_importer
