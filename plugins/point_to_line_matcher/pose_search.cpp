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
};

Steps steps_over(double extent, double finest, int most) {
  const int count = std::clamp(static_cast<int>(std::ceil(extent / finest)), 1, most);
  return {count, std::max(finest, extent / count)};
}

class Search {
 public:
  Search(const ReferenceGrid& grid, std::span<const Point> scan, const Pose2& guess, const Eigen::Vector3d& sigma,
         double sigmas)
      : grid_(grid), scan_(scan), guess_(guess), sigma_(sigma), columns_(scan.size()), rows_(scan.size()) {
    const Steps headings = steps_over(sigmas * sigma.z(), kHeadingStep_rad, kMostHeadingSteps);
    const double finest = grid.cell_m();
    const Steps x = steps_over(sigmas * sigma.x(), finest, kMostSteps);
    const Steps y = steps_over(sigmas * sigma.y(), finest, kMostSteps);
    for (int k = -headings.count; k <= headings.count; ++k) {
      turn(k * headings.size);
      for (int j = -y.count; j <= y.count; ++j)
        for (int i = -x.count; i <= x.count; ++i) rate(i * stride(x), j * stride(y), k * headings.size);
    }
  }

  std::vector<Pose2> best() const {
    std::vector<Pose2> poses{best_.T_reference_scan};
    if (second_.rating > 0.7 * best_.rating) poses.push_back(second_.T_reference_scan);
    return poses;
  }

 private:
  int stride(const Steps& steps) const { return std::max(1, static_cast<int>(std::lround(steps.size / grid_.cell_m()))); }

  void turn(double by_rad) {
    const Pose2 turned(guess_.position(), guess_.heading_rad() + by_rad);
    for (std::size_t p = 0; p < scan_.size(); ++p) {
      const Point moved = turned * scan_[p];
      columns_[p] = grid_.column_of(moved.x());
      rows_[p] = grid_.row_of(moved.y());
    }
  }

  void rate(int column_shift, int row_shift, double turn_rad) {
    float near = 0;
    for (std::size_t p = 0; p < columns_.size(); ++p)
      near += grid_.nearness(columns_[p] + column_shift, rows_[p] + row_shift);
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
  std::vector<int> columns_, rows_;
  Candidate best_, second_;
};

}  // namespace

std::vector<Pose2> search_poses(const ReferenceGrid& grid, std::span<const Point> scan, const Pose2& guess,
                                const Eigen::Vector3d& guess_sigma, double sigmas) {
  return Search(grid, scan, guess, guess_sigma, sigmas).best();
}

}  // namespace opal::point_to_line
