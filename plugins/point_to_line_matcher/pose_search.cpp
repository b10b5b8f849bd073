#include "pose_search.hpp"

#include <algorithm>
#include <array>

namespace opal::point_to_line {
namespace {

constexpr double kHeadingStep_rad = 0.02;  ///< moves a point 10 m away by two cells
constexpr int kMostHeadingSteps = 16;      ///< to either side
constexpr int kMostSteps = 6;              ///< to either side, for x and y
constexpr double kApart_m = 0.25;
constexpr double kApart_rad = 0.06;
constexpr double kPriorWeight = 0.5;  ///< points per nat

struct Candidate {
  double rating = -1e300;
  Pose2 T_reference_scan;
};

bool are_apart(const Pose2& a, const Pose2& b) {
  return distance_m(a, b) > kApart_m || angle_between_rad(a, b) > kApart_rad;
}

/// Steps of a symmetric search: `count` to either side, each `size` wide.
struct Steps {
  int count;
  double size;

  int all() const { return 2 * count + 1; }
};

Steps steps_over(double extent, double finest, int most) {
  const int count = std::clamp(static_cast<int>(std::ceil(extent / finest)), 1, most);
  return {count, std::max(finest, extent / count)};
}

class Search {
 public:
  Search(const ReferenceGrid& grid, std::span<const Point> scan, const Pose2& guess, const Eigen::Vector3d& sigma,
         double sigmas)
      : grid_(grid),
        scan_(scan),
        guess_(guess),
        sigma_(sigma),
        x_(steps_over(sigmas * sigma.x(), grid.cell_m(), kMostSteps)),
        y_(steps_over(sigmas * sigma.y(), grid.cell_m(), kMostSteps)) {
    const Steps headings = steps_over(sigmas * sigma.z(), kHeadingStep_rad, kMostHeadingSteps);
    for (int k = -headings.count; k <= headings.count; ++k) rate_heading(k * headings.size);
  }

  std::vector<Pose2> best() const {
    std::vector<Pose2> poses{best_.T_reference_scan};
    if (second_.rating > 0.7 * best_.rating) poses.push_back(second_.T_reference_scan);
    return poses;
  }

 private:
  /// In cells.
  int stride(const Steps& steps) const {
    return std::max(1, static_cast<int>(std::lround(steps.size / grid_.cell_m())));
  }

  void rate_heading(double turn_rad) {
    const int stride_x = stride(x_), stride_y = stride(y_);
    sum_likelihood_field(Pose2(guess_.position(), guess_.heading_rad() + turn_rad), stride_x, stride_y);
    for (int j = 0; j < y_.all(); ++j)
      for (int i = 0; i < x_.all(); ++i)
        rate(sums_[j][i], (i - x_.count) * stride_x, (j - y_.count) * stride_y, turn_rad);
  }

  /// Of all points, at every shift, row by row: neighbouring shifts find neighbouring cells.
  void sum_likelihood_field(const Pose2& turned, int stride_x, int stride_y) {
    cells_.clear();
    for (const Point& point : scan_) {
      const Point moved = turned * point;
      cells_.push_back(
          {grid_.column_of(moved.x()) - x_.count * stride_x, grid_.row_of(moved.y()) - y_.count * stride_y});
    }
    for (int j = 0; j < y_.all(); ++j) sums_[j] = grid_.sum_likelihood_field(cells_, j * stride_y, stride_x, x_.all());
  }

  void rate(float near, int column_shift, int row_shift, double turn_rad) {
    const Point shift = grid_.cell_m() * Point(column_shift, row_shift);
    const double squared = Eigen::Vector3d(shift.x(), shift.y(), turn_rad).cwiseQuotient(sigma_).squaredNorm();
    const double rating = static_cast<double>(near) - kPriorWeight * 0.5 * squared;
    if (rating <= second_.rating) return;
    keep({rating, Pose2(guess_.position() + shift, guess_.heading_rad() + turn_rad)});
  }

  void keep(const Candidate& candidate) {
    const bool apart = are_apart(candidate.T_reference_scan, best_.T_reference_scan);
    if (candidate.rating > best_.rating) {
      if (apart) second_ = best_;
      best_ = candidate;
    } else if (apart) {
      second_ = candidate;
    }
  }

  const ReferenceGrid& grid_;
  std::span<const Point> scan_;
  const Pose2& guess_;
  const Eigen::Vector3d& sigma_;
  Steps x_, y_;
  std::vector<ReferenceGrid::Cell> cells_;  ///< where the points lie at the lowest shift
  static_assert(2 * kMostSteps + 1 <= ReferenceGrid::kMostSums);
  std::array<ReferenceGrid::Sums, 2 * kMostSteps + 1> sums_;  ///< likelihood-field score, by y and x
  Candidate best_, second_;
};

}  // namespace

std::vector<Pose2> search_poses(const ReferenceGrid& grid, std::span<const Point> scan, const Pose2& guess,
                                const Eigen::Vector3d& guess_sigma, double sigmas) {
  return Search(grid, scan, guess, guess_sigma, sigmas).best();
}

}  // namespace opal::point_to_line
