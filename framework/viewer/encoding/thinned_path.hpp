#pragma once

#include <opal/common/geometry.hpp>

#include <cstddef>
#include <vector>

namespace opal {

/// Where the robot was, however long the drive: the longer, the farther apart the points. Frame: `map` [m].
class ThinnedPath {
 public:
  /// @param most  points in all. @pre most >= 4
  explicit ThinnedPath(std::size_t most = 1000) : most_(most) {}

  /// The next place. One that is far from the last one begins a new line: the estimate has changed its mind.
  void add(const Point& p_map);
  void clear() { *this = ThinnedPath(most_); }

  /// Oldest first; none is empty. The last line ends with the newest place.
  const std::vector<std::vector<Point>>& lines() const { return lines_; }

 private:
  void thin();
  std::vector<Point> thinned(const std::vector<Point>& line) const;

  static constexpr double kJump_m = 1;  ///< as the page breaks the trajectory

  std::size_t most_;
  double apart_m_ = 0.1;  ///< points of a line, at least
  std::vector<std::vector<Point>> lines_;
  Point newest_ = Point::Zero();
  std::size_t points_ = 0;
};

}  // namespace opal
