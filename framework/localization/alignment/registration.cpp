#include "localization/alignment/registration.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <optional>

namespace opal {
namespace {

struct Headed {
  double heading_rad = 0;
  double weight = 0;  ///< 0: has no direction
};

Headed heading_of(const Geometry& geometry) {
  if (const auto* s = std::get_if<Segment>(&geometry)) return {s->heading_rad(), s->length_m()};
  if (const auto* p = std::get_if<OrientedPoint>(&geometry)) return {p->heading_rad, 0.5};
  return {};
}

bool is_segment(const GeometryPair& pair) { return kind_of(pair.local) == GeometryKind::segment; }

/// Weighted circular mean of what the directions of the pairs, and of the ways between their points, turn by.
std::optional<double> common_turn(std::span<const GeometryPair> pairs) {
  Point sum = Point::Zero();
  for (const GeometryPair& pair : pairs) {
    const Headed local = heading_of(pair.local), mapped = heading_of(pair.mapped);
    if (local.weight > 0) sum += local.weight * unit_vector(mapped.heading_rad - local.heading_rad);
  }
  for (std::size_t a = 0; a < pairs.size(); ++a)
    for (std::size_t b = a + 1; b < pairs.size(); ++b) {
      if (is_segment(pairs[a]) || is_segment(pairs[b])) continue;
      const Point local = anchor_of(pairs[b].local) - anchor_of(pairs[a].local);
      const Point mapped = anchor_of(pairs[b].mapped) - anchor_of(pairs[a].mapped);
      if (local.norm() > 1e-3 && mapped.norm() > 1e-3)
        sum += local.norm() * unit_vector(std::atan2(cross(local, mapped), local.dot(mapped)));
    }
  if (sum.norm() < 1e-9) return std::nullopt;
  return std::atan2(sum.y(), sum.x());
}

/// One row per scalar constraint: normal . (R y + t - m) = 0.
struct Constraint {
  Point local;
  Point mapped;
  Point normal;
  std::size_t pair;
};

std::vector<Constraint> constraints_of(std::span<const GeometryPair> pairs) {
  std::vector<Constraint> rows;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (is_segment(pairs[k])) {
      const auto& local = std::get<Segment>(pairs[k].local);
      const auto& mapped = std::get<Segment>(pairs[k].mapped);
      for (const Point& end : {local.begin, local.end}) rows.push_back({end, mapped.begin, mapped.normal(), k});
    } else {
      for (const Point& axis : {Point(Point::UnitX()), Point(Point::UnitY())})
        rows.push_back({anchor_of(pairs[k].local), anchor_of(pairs[k].mapped), axis, k});
    }
  }
  return rows;
}

Eigen::Matrix2d information(const std::vector<Constraint>& rows) {
  Eigen::Matrix2d A = Eigen::Matrix2d::Zero();
  for (const Constraint& row : rows) A += row.normal * row.normal.transpose();
  return A;
}

/// The translation that fits best at a given turn; the least one where the rows leave it open.
Point best_shift(const std::vector<Constraint>& rows, const Pose2& turn) {
  Point b = Point::Zero();
  for (const Constraint& row : rows) b += row.normal * row.normal.dot(row.mapped - turn.rotate(row.local));
  return information(rows).completeOrthogonalDecomposition().solve(b);
}

Pose2 gauss_newton_step(const std::vector<Constraint>& rows, const Pose2& T, bool turn_too) {
  Eigen::Matrix3d H = Eigen::Matrix3d::Identity() * 1e-9;
  Eigen::Vector3d g = Eigen::Vector3d::Zero();
  for (const Constraint& row : rows) {
    const Point lever = T.rotate(row.local);
    const Eigen::Vector3d J(row.normal.x(), row.normal.y(), turn_too ? cross(lever, row.normal) : 0.0);
    const double error = row.normal.dot(T * row.local - row.mapped);
    H += J * J.transpose();
    g += error * J;
  }
  const Eigen::Vector3d step = -H.ldlt().solve(g);
  return {Point(T.position() + step.head<2>()), T.heading_rad() + (turn_too ? step.z() : 0.0)};
}

}  // namespace

Mismatch mismatch(const Geometry& placed, const Geometry& mapped) {
  if (const auto* a = std::get_if<Segment>(&placed)) {
    const auto& b = std::get<Segment>(mapped);
    const Point along = b.direction();
    const double u = along.dot(a->begin - b.begin), v = along.dot(a->end - b.begin);
    const double gap = std::max({0.0, std::min(u, v) - b.length_m(), -std::max(u, v)});
    return {std::hypot(b.normal().dot(a->midpoint() - b.begin), gap),
            std::abs(wrap_angle(a->heading_rad() - b.heading_rad()))};
  }
  if (const auto* a = std::get_if<OrientedPoint>(&placed)) {
    const auto& b = std::get<OrientedPoint>(mapped);
    return {(a->position - b.position).norm(), std::abs(wrap_angle(a->heading_rad - b.heading_rad))};
  }
  return {(anchor_of(placed) - anchor_of(mapped)).norm(), 0};
}

Registration register_geometry(std::span<const GeometryPair> pairs) {
  Registration result;
  result.errors_m.assign(pairs.size(), 0.0);
  const std::vector<Constraint> rows = constraints_of(pairs);
  if (rows.empty()) return result;
  const auto turn = common_turn(pairs);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> spread(information(rows));
  const bool both_ways = spread.eigenvalues()[0] > 0.02 * spread.eigenvalues()[1];
  result.fixed = (turn ? 1 : 0) + (both_ways ? 2 : 1);

  const Pose2 turned(0, 0, turn.value_or(0.0));
  Pose2 T(best_shift(rows, turned), turned.heading_rad());
  for (int iteration = 0; iteration < 4; ++iteration) T = gauss_newton_step(rows, T, turn.has_value());
  result.T_map_local = T;
  for (const Constraint& row : rows) {
    const double error = std::abs(row.normal.dot(T * row.local - row.mapped));
    double& of_pair = result.errors_m[row.pair];
    of_pair = is_segment(pairs[row.pair]) ? std::max(of_pair, error) : std::hypot(of_pair, error);
  }
  return result;
}

}  // namespace opal
