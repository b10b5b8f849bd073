#pragma once

#include <opal/common/geometry.hpp>

#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace opal::ifc_importer {

/// Points by where they are, in squares of the size of a tolerance.
class PointNodes {
 public:
  explicit PointNodes(double same_m) : same_m_(same_m) {}

  /// Calls visit(node) for the nodes within the tolerance of a point.
  template <class Visit>
  void visit_near(const Point& p, Visit visit) const {
    const std::int64_t column = square(p.x()), row = square(p.y());
    for (std::int64_t c = column - 1; c <= column + 1; ++c)
      for (std::int64_t r = row - 1; r <= row + 1; ++r) {
        const auto found = squares_.find(key(c, r));
        if (found == squares_.end()) continue;
        for (const int node : found->second)
          if ((points_[static_cast<std::size_t>(node)] - p).norm() <= same_m_) visit(node);
      }
  }

  /// The nearest node within the tolerance, or -1.
  int nearest(const Point& p) const {
    int best = -1;
    double best_m = 2 * same_m_;
    visit_near(p, [&](int node) {
      const double distance_m = (points_[static_cast<std::size_t>(node)] - p).norm();
      if (distance_m < best_m) best = node, best_m = distance_m;
    });
    return best;
  }

  int add(const Point& p) {
    squares_[key(square(p.x()), square(p.y()))].push_back(static_cast<int>(points_.size()));
    points_.push_back(p);
    return static_cast<int>(points_.size()) - 1;
  }

  int nearest_or_new(const Point& p) {
    const int node = nearest(p);
    return node >= 0 ? node : add(p);
  }

  const std::vector<Point>& points() const { return points_; }

 private:
  std::int64_t square(double x) const { return static_cast<std::int64_t>(std::floor(x / same_m_)); }
  static std::int64_t key(std::int64_t column, std::int64_t row) {
    const auto wrapped = [](std::int64_t number) { return static_cast<std::uint64_t>(number); };  // products overflow
    return static_cast<std::int64_t>(wrapped(column) * 0x100000001B3 ^ wrapped(row) * 0x9E3779B97F4A7C1);
  }

  double same_m_;
  std::vector<Point> points_;
  std::unordered_map<std::int64_t, std::vector<int>> squares_;
};

}  // namespace opal::ifc_importer
