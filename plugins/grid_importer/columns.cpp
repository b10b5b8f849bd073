#include "columns.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace opal::grid_importer {
namespace {

constexpr double kMinRadius_m = 0.1;
// Cells of one dotted outline are at most this far apart (Chebyshev, in cells).
constexpr int kBlobReach = 2;
constexpr std::size_t kMinBlobCells = 8;
// Of 16 directions around the centre, this many must show an outline: 160 degrees, as seen from one side.
constexpr int kMinSectorsSeen = 7;
// Around a column nothing is occupied, out to this distance, and most that is seen is free: its shadow is unknown.
constexpr double kClearance_m = 0.20;
constexpr double kMaxOccupiedShare = 0.05;
constexpr double kMinFreeShare = 0.4;
// Nobody looks into a column.
constexpr double kMaxFreeShareInside = 0.1;
// A circle has 3 parameters and a box 5, so that noise alone makes the box fit better.
constexpr double kMaxRmsRatioToBox = 0.8;
// A uniformly filled cell has 0.29 cells of spread; smear doubles it.
constexpr double kMaxRms = 0.75;
constexpr int kRefinements = 10;

using Blob = std::vector<int>;

std::vector<CellPoint> positions(const Boundary& boundary, const Blob& blob) {
  std::vector<CellPoint> points;
  for (const int cell : blob) points.push_back(centre_of(boundary[cell].cell));
  return points;
}

/// Connected sets of boundary cells that fit into a square of max_extent cells.
class BlobSearch {
 public:
  BlobSearch(const Boundary& boundary, int max_extent)
      : boundary_(boundary), max_extent_(max_extent), seen_(static_cast<std::size_t>(boundary.size())) {}

  std::vector<Blob> run() {
    std::vector<Blob> blobs;
    for (int cell = 0; cell < boundary_.size(); ++cell) {
      if (seen_[static_cast<std::size_t>(cell)]) continue;
      Blob blob = connected_to(cell);
      if (blob.size() >= kMinBlobCells && is_small(blob)) blobs.push_back(std::move(blob));
    }
    return blobs;
  }

 private:
  Blob connected_to(int start) {
    Blob blob{start};
    seen_[static_cast<std::size_t>(start)] = true;
    for (std::size_t k = 0; k < blob.size(); ++k)
      boundary_.visit_near(boundary_[blob[k]].cell, kBlobReach, [&](int other) {
        if (seen_[static_cast<std::size_t>(other)]) return;
        seen_[static_cast<std::size_t>(other)] = true;
        blob.push_back(other);
      });
    return blob;
  }

  bool is_small(const Blob& blob) const {
    Eigen::AlignedBox2d box;
    for (const CellPoint& p : positions(boundary_, blob)) box.extend(p);
    return box.sizes().maxCoeff() <= max_extent_;
  }

  const Boundary& boundary_;
  int max_extent_;
  std::vector<bool> seen_;
};

/// Solves the 3 x 3 normal equations of `rows x = rights`.
class LeastSquares3 {
 public:
  void add(const Eigen::Vector3d& row, double right) {
    normal_ += row * row.transpose();
    right_ += right * row;
  }
  std::optional<Eigen::Vector3d> solve() const {
    const Eigen::FullPivLU<Eigen::Matrix3d> lu(normal_);
    return lu.isInvertible() ? std::optional<Eigen::Vector3d>(lu.solve(right_)) : std::nullopt;
  }

 private:
  Eigen::Matrix3d normal_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right_ = Eigen::Vector3d::Zero();
};

/// Algebraic circle fit: least squares of x^2 + y^2 - 2 a x - 2 b y - c (Kasa 1976, "A circle fitting procedure and
/// its error analysis"). Too small a radius for short arcs.
std::optional<RoundColumn> fit_algebraic(const std::vector<CellPoint>& points) {
  const CellPoint& origin = points.front();
  LeastSquares3 equations;
  for (const CellPoint& p : points) {
    const CellPoint d = p - origin;
    equations.add({2 * d.x(), 2 * d.y(), 1}, d.squaredNorm());
  }
  const auto s = equations.solve();
  if (!s) return std::nullopt;
  const double radius_squared = (*s)(2) + s->head<2>().squaredNorm();
  if (radius_squared <= 0) return std::nullopt;
  return RoundColumn{origin + s->head<2>(), std::sqrt(radius_squared), 0};
}

/// Geometric circle fit: Gauss-Newton on the distances to the circle, from the algebraic fit.
std::optional<RoundColumn> fit_circle(const std::vector<CellPoint>& points) {
  std::optional<RoundColumn> column = fit_algebraic(points);
  for (int k = 0; column && k < kRefinements; ++k) {
    LeastSquares3 equations;
    for (const CellPoint& p : points) {
      const CellPoint d = p - column->centre;
      if (const double distance = d.norm(); distance > 0)
        equations.add({d.x() / distance, d.y() / distance, 1}, distance - column->radius);
    }
    const auto step = equations.solve();
    if (!step) return std::nullopt;
    column->centre += step->head<2>();
    column->radius += (*step)(2);
  }
  return column;
}

double rms_to_circle(const std::vector<CellPoint>& points, const RoundColumn& column) {
  double sum = 0;
  for (const CellPoint& p : points) sum += std::pow((p - column.centre).norm() - column.radius, 2);
  return std::sqrt(sum / static_cast<double>(points.size()));
}

/// Root mean square distance to the nearest side of the box around the points that is turned by angle_rad; the box is
/// inset by half a cell, so that it runs through the cells of a straight side that is not on the raster.
double rms_to_box(const std::vector<CellPoint>& points, double angle_rad) {
  const CellPoint axis = unit_vector(angle_rad);
  Eigen::AlignedBox2d box;
  for (const CellPoint& p : points) box.extend(CellPoint(axis.dot(p), cross(axis, p)));
  const CellPoint centre = box.center();
  const CellPoint half = box.sizes() / 2 - CellPoint::Constant(0.5);
  double sum = 0;
  for (const CellPoint& p : points) {
    const CellPoint d = (CellPoint(axis.dot(p), cross(axis, p)) - centre).cwiseAbs() - half;
    sum += std::pow(d.cwiseAbs().minCoeff(), 2);
  }
  return std::sqrt(sum / static_cast<double>(points.size()));
}

double rms_to_best_box(const std::vector<CellPoint>& points) {
  constexpr int kAngles = 18;
  double best = std::numeric_limits<double>::infinity();
  for (int k = 0; k < kAngles; ++k) best = std::min(best, rms_to_box(points, k * std::numbers::pi / 2 / kAngles));
  return best;
}

bool is_seen_around(const std::vector<CellPoint>& points, const CellPoint& centre) {
  DirectionSet seen;
  for (const CellPoint& p : points) seen.add(DirectionSet::sector_of(p - centre));
  int sectors = 0;
  for (int k = 0; k < DirectionSet::kSectors; ++k) sectors += seen.contains(k);
  return sectors >= kMinSectorsSeen;
}

/// How much of a ring around a centre is in some state.
class Ring {
 public:
  Ring(const OccupancyGrid& grid, const CellPoint& centre, double inner, double outer) {
    const int reach = static_cast<int>(std::ceil(outer));
    const Cell middle = cell_at(centre);
    for (int row = middle.row - reach; row <= middle.row + reach; ++row)
      for (int column = middle.column - reach; column <= middle.column + reach; ++column) {
        const double distance = (CellPoint(column, row) - centre).norm();
        if (distance >= inner && distance <= outer) ++counts_[static_cast<std::size_t>(grid.at({column, row}))];
      }
  }
  double share(Occupancy state) const {
    const int all = counts_[0] + counts_[1] + counts_[2];
    return all > 0 ? static_cast<double>(counts_[static_cast<std::size_t>(state)]) / all : 0;
  }

 private:
  std::array<int, 3> counts_{};
};

bool stands_alone(const OccupancyGrid& grid, const RoundColumn& column) {
  const double inner = column.radius + 1.5;  // smear ends somewhere
  const Ring around(grid, column.centre, inner, std::max(column.radius + grid.to_cells(kClearance_m), inner + 2));
  const Ring inside(grid, column.centre, 0, column.radius - 1.5);
  return around.share(Occupancy::occupied) <= kMaxOccupiedShare && around.share(Occupancy::free) >= kMinFreeShare &&
         inside.share(Occupancy::free) <= kMaxFreeShareInside;
}

class RoundColumnTest {
 public:
  RoundColumnTest(const OccupancyGrid& grid, const VectorizerLimits& limits)
      : grid_(grid), min_radius_(grid.to_cells(kMinRadius_m)), max_radius_(grid.to_cells(limits.max_column_radius_m)) {}

  std::optional<RoundColumn> operator()(const std::vector<CellPoint>& points) const {
    std::optional<RoundColumn> column = fit_circle(points);
    if (!column || column->radius < min_radius_ || column->radius > max_radius_) return std::nullopt;
    column->rms = rms_to_circle(points, *column);
    const bool is_round = column->rms <= kMaxRms && column->rms <= kMaxRmsRatioToBox * rms_to_best_box(points);
    if (!is_round || !is_seen_around(points, column->centre) || !stands_alone(grid_, *column)) return std::nullopt;
    return column;
  }

 private:
  const OccupancyGrid& grid_;
  double min_radius_;
  double max_radius_;
};

}  // namespace

std::vector<RoundColumn> find_round_columns(Boundary& boundary, const VectorizerLimits& limits) {
  const int max_extent = static_cast<int>(std::ceil(boundary.grid().to_cells(2 * limits.max_column_radius_m))) + 2;
  const RoundColumnTest column_of(boundary.grid(), limits);
  std::vector<RoundColumn> columns;
  for (const Blob& blob : BlobSearch(boundary, max_extent).run())
    if (const auto column = column_of(positions(boundary, blob))) {
      columns.push_back(*column);
      for (const int cell : blob) boundary[cell].explained.add(0, DirectionSet::kSectors / 2);
    }
  return columns;
}

}  // namespace opal::grid_importer
