#include "reference_grid.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>

namespace opal::point_to_line {
namespace {

constexpr double kFinestCell_m = 0.1;
constexpr double kMostCells = 500 * 500;  ///< a larger reference gets larger cells
constexpr double kMostColumns = 5000;

// The direction across the outline at a point comes from a neighbour on either side, at least an arm's length away
// so that range noise of 2 cm turns it little, and in line with the point.
constexpr double kArm_m = 0.15;
constexpr double kLongestArm_m = 1.2;
constexpr double kInLineCosine = 0.95;

constexpr double kNear_m = 0.15;
constexpr double kAgreement = 0.9;  ///< mean length of a cell's normals below which it is a corner or clutter

// So many cells to all sides tell whether a cell is a piece of a wall, and the direction across it, also where a wall
// ends in view, and where range noise is as large as an arm. Along a wall the variance is so many times that across it.
// About a right angle it is four times.
constexpr int kNeighbours = 2;
constexpr double kElongated = 8;
constexpr double kEnds = 0.7;  ///< cells from a surfel to the middle of those about it, from which on a wall ends there

/// The first point at least an arm's length from points[i], going by `step`; null: the scan ends or jumps before.
const Point* arm(std::span<const Point> points, std::size_t i, int step) {
  for (auto k = static_cast<std::ptrdiff_t>(i) + step; k >= 0 && k < std::ssize(points); k += step) {
    const Point& other = points[static_cast<std::size_t>(k)];
    const double squared = (other - points[i]).squaredNorm();
    if (squared > kLongestArm_m * kLongestArm_m) return nullptr;
    if (squared >= kArm_m * kArm_m) return &other;
  }
  return nullptr;
}

Point normal_at(std::span<const Point> points, std::size_t i) {
  const Point* before = arm(points, i, -1);
  const Point* after = arm(points, i, 1);
  if (!before || !after) return Point::Zero();
  const Point in = (points[i] - *before).normalized();
  const Point out = (*after - points[i]).normalized();
  return in.dot(out) > kInLineCosine ? left_of((*after - *before).normalized()) : Point::Zero();
}

bool has_near_neighbour(std::span<const Point> points, std::size_t i) {
  return (i > 0 && (points[i] - points[i - 1]).squaredNorm() < kNear_m * kNear_m) ||
         (i + 1 < points.size() && (points[i + 1] - points[i]).squaredNorm() < kNear_m * kNear_m);
}

double squared(double value) { return value * value; }

}  // namespace

ReferenceGrid::ReferenceGrid(std::span<const Point> reference) {
  if (reference.empty()) return;
  lay_out(reference);
  gather(reference);
  for (std::uint32_t i = 0; i < surfels_.size(); ++i) spread(i);
}

void ReferenceGrid::lay_out(std::span<const Point> reference) {
  Eigen::AlignedBox2d box;
  for (const Point& p : reference) box.extend(p);
  const Point size = box.sizes() + Point::Constant(2 * kReach_m + kFinestCell_m);
  cell_m_ = std::max({kFinestCell_m, std::sqrt(size.x() * size.y() / kMostCells), size.maxCoeff() / kMostColumns});
  origin_ = box.min() - Point::Constant(kReach_m);
  columns_ = static_cast<int>(size.x() / cell_m_) + 1;
  rows_ = static_cast<int>(size.y() / cell_m_) + 1;
  const std::size_t cells = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  surfel_of_.assign(cells, kNone);
  likelihood_field_.assign(cells + kReadAhead, 0);
}

/// One surfel per occupied cell. Cells about it tell the direction of a wall best. Near corners and on small things it
/// is that of its own points.
void ReferenceGrid::gather(std::span<const Point> reference) {
  std::vector<std::uint32_t> surfel_of_point;
  surfel_of_point.reserve(reference.size());
  for (const Point& p : reference) {
    std::uint32_t& index = surfel_of_[cell(column_of(p.x()), row_of(p.y()))];
    if (index == kNone) {
      index = static_cast<std::uint32_t>(surfels_.size());
      surfels_.emplace_back();
    }
    surfels_[index].mean += p;
    ++surfels_[index].points;
    surfel_of_point.push_back(index);
  }
  for (Surfel& surfel : surfels_) surfel.mean /= surfel.points;
  std::vector<char> is_on_line;
  is_on_line.reserve(surfels_.size());
  for (Surfel& surfel : surfels_) is_on_line.push_back(take_normal_of_neighbours(surfel));
  for (std::size_t i = 0; i < reference.size(); ++i)
    if (const std::uint32_t index = surfel_of_point[i]; !is_on_line[index])
      add_neighbours(surfels_[index], reference, i);
  for (std::size_t k = 0; k < surfels_.size(); ++k)
    if (!is_on_line[k]) set_normal_of_points(surfels_[k]);
}

/// Scans seen from either side of a wall have opposite normals: they are turned alike.
void ReferenceGrid::add_neighbours(Surfel& surfel, std::span<const Point> reference, std::size_t i) {
  const Point normal = normal_at(reference, i);
  surfel.normal += normal.dot(surfel.normal) < 0 ? Point(-normal) : normal;
  surfel.dense = surfel.dense || has_near_neighbour(reference, i);
}

void ReferenceGrid::set_normal_of_points(Surfel& surfel) {
  const bool agree = surfel.normal.norm() > kAgreement * surfel.points;
  surfel.normal = agree ? surfel.normal.normalized() : Point::Zero();
}

bool ReferenceGrid::take_normal_of_neighbours(Surfel& surfel) const {
  const int column = column_of(surfel.mean.x()), row = row_of(surfel.mean.y());
  double points = 0;
  Point sum = Point::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  for (int r = std::max(0, row - kNeighbours); r <= std::min(rows_ - 1, row + kNeighbours); ++r)
    for (int c = std::max(0, column - kNeighbours); c <= std::min(columns_ - 1, column + kNeighbours); ++c) {
      const std::uint32_t index = surfel_of_[cell(c, r)];
      if (index == kNone) continue;
      const Surfel& other = surfels_[index];
      const Point away = other.mean - surfel.mean;
      points += other.points;
      sum += other.points * away;
      squares += other.points * away * away.transpose();
    }
  const Eigen::Matrix2d scatter = squares / points - sum * sum.transpose() / (points * points);
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes;
  axes.computeDirect(scatter);
  const double across = std::max(0.0, axes.eigenvalues()[0]), along = axes.eigenvalues()[1];
  if (along <= kElongated * across) return false;
  surfel.normal = axes.eigenvectors().col(0);
  surfel.normal_variance = across / (points * along);
  const Point direction = axes.eigenvectors().col(1);
  const double middle_m = direction.dot(sum) / points;
  if (std::abs(middle_m) > kEnds * cell_m_) surfel.end = middle_m > 0 ? Point(-direction) : direction;
  return true;
}

void ReferenceGrid::spread(std::uint32_t index) {
  constexpr int kMostReach = static_cast<int>(kReach_m / kFinestCell_m) + 1;
  const Point& mean = surfels_[index].mean;
  const int reach = static_cast<int>(kReach_m / cell_m_) + 1;
  const int column = column_of(mean.x()), row = row_of(mean.y());
  const int first = std::max(0, column - reach), count = std::min(columns_ - 1, column + reach) - first + 1;
  std::array<double, 2 * kMostReach + 1> across;  // squared, by column
  for (int c = 0; c < count; ++c) across[c] = squared(origin_.x() + cell_m_ * (first + c + 0.5) - mean.x());
  for (int r = std::max(0, row - reach); r <= std::min(rows_ - 1, row + reach); ++r) {
    const double along = squared(origin_.y() + cell_m_ * (r + 0.5) - mean.y());
    float* likelihood_field = &likelihood_field_[cell(first, r)];
    std::uint32_t* surfel = &surfel_of_[cell(first, r)];
    for (int c = 0; c < count; ++c) {
      // No branch: which cells are nearer is nothing that a processor could guess.
      const double near = 1 - (across[c] + along) / (kReach_m * kReach_m);
      const bool nearer = near > likelihood_field[c];
      likelihood_field[c] = nearer ? static_cast<float>(near) : likelihood_field[c];
      surfel[c] = nearer ? index : surfel[c];
    }
  }
}

ReferenceGrid::Sums ReferenceGrid::sum_likelihood_field(std::span<const Cell> cells, int rows, int step,
                                                        int count) const {
  return count <= kMostSums / 2 ? sum_likelihood_field<kMostSums / 2>(cells, rows, step, count)
                                : sum_likelihood_field<kMostSums>(cells, rows, step, count);
}

/// Sums stay in the processor's registers, which takes a number of them that is known beforehand.
template <int kSums>
ReferenceGrid::Sums ReferenceGrid::sum_likelihood_field(std::span<const Cell> cells, int rows, int step,
                                                        int count) const {
  using Row = Eigen::Array<float, kSums, 1>;
  using Steps = Eigen::Map<const Row, Eigen::Unaligned, Eigen::InnerStride<>>;
  Row sums = Row::Zero();
  for (const auto& [column, first_row] : cells) {
    const int row = first_row + rows;
    if (row < 0 || row >= rows_) continue;
    const bool inside = column >= 0 && column + count * step <= columns_ && step <= kMostStep;
    if (inside && step == 1)
      sums += Eigen::Map<const Row>(&likelihood_field_[cell(column, row)]);
    else if (inside)
      sums += Steps(&likelihood_field_[cell(column, row)], Eigen::InnerStride<>(step));
    else
      sums += likelihood_field_cell_by_cell(column, row, step, count).template head<kSums>();
  }
  Sums all = Sums::Zero();
  all.template head<kSums>() = sums;
  return all;
}

ReferenceGrid::Sums ReferenceGrid::likelihood_field_cell_by_cell(int column, int row, int step, int count) const {
  Sums likelihood_field = Sums::Zero();
  for (int k = 0; k < count; ++k)
    if (const int c = column + k * step; c >= 0 && c < columns_) likelihood_field[k] = likelihood_field_[cell(c, row)];
  return likelihood_field;
}

}  // namespace opal::point_to_line
