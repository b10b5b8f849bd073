#include "local_map/matched_points.hpp"

#include <opal/sensing/point_runs.hpp>

#include <cmath>
#include <cstdint>
#include <span>

namespace opal {
namespace {

// Keyframes that are matched against: the newest, and older ones with so much driving between them. Near neighbours
// add no view, and a chain of nothing but short steps drifts.
constexpr std::size_t kReferenceKeyframes = 5;
constexpr double kReferenceStep_m = 0.4;

constexpr double kReferenceRange_m = 20.0;  ///< farther points are too sparse for their direction to be known
constexpr double kReferenceSpacing_m = 0.04;

/// The newest keyframe first.
std::vector<const Keyframe*> chosen_among(const std::deque<Keyframe>& keyframes) {
  std::vector<const Keyframe*> chosen;
  for (auto it = keyframes.rbegin(); it != keyframes.rend() && chosen.size() < kReferenceKeyframes; ++it)
    if (chosen.empty() || chosen.back()->driven_m - it->driven_m >= kReferenceStep_m) chosen.push_back(&*it);
  return chosen;
}

/// Which keyframes saw something where: cells around a position.
class Sightings {
 public:
  Sightings(const Point& middle, std::span<const Keyframe* const> keyframes)
      : low_(middle - Point::Constant(kReferenceRange_m)), by_(kSide * kSide, 0), alone_(keyframes.size() == 1) {
    for (unsigned number = 0; number < keyframes.size(); ++number)
      for (const Point& point : keyframes[number]->points) add(keyframes[number]->T_local_base * point, number);
  }

  /// There or right beside it. True if there is no other.
  bool by_another(const Point& point, unsigned keyframe) const {
    if (alone_) return true;
    unsigned by = 0;
    for (int row = -1; row <= 1; ++row)
      for (int column = -1; column <= 1; ++column)
        if (const auto cell = cell_of(point, column, row); cell < by_.size()) by |= by_[cell];
    return (by & ~unsigned{bit(keyframe)}) != 0;
  }

 private:
  static constexpr double kCell_m = 0.1;
  static constexpr std::size_t kSide = static_cast<std::size_t>(2 * kReferenceRange_m / kCell_m);

  void add(const Point& point, unsigned keyframe) {
    if (const auto cell = cell_of(point, 0, 0); cell < by_.size()) by_[cell] |= bit(keyframe);
  }
  static std::uint8_t bit(unsigned keyframe) { return static_cast<std::uint8_t>(1U << keyframe); }
  /// Outside, it is no cell.
  std::size_t cell_of(const Point& point, int column, int row) const {
    const double x = std::floor((point.x() - low_.x()) / kCell_m) + column;
    const double y = std::floor((point.y() - low_.y()) / kCell_m) + row;
    const bool inside = x >= 0 && y >= 0 && x < kSide && y < kSide;
    return inside ? static_cast<std::size_t>(y) * kSide + static_cast<std::size_t>(x) : by_.size();
  }

  Point low_;
  std::vector<std::uint8_t> by_;  ///< by cell: a bit a keyframe
  bool alone_;
};

/// Points of one keyframe, no nearer to their predecessor than the spacing.
class Gathered {
 public:
  Gathered(std::vector<Point>& points, const Point& position) : points_(points), position_(position) {}

  void begin_keyframe() { last_ = Point(1e9, 1e9); }
  void add(const Point& point) {
    if ((point - last_).squaredNorm() < kReferenceSpacing_m * kReferenceSpacing_m) return;
    if ((point - position_).squaredNorm() > kReferenceRange_m * kReferenceRange_m) return;
    points_.push_back(point);
    last_ = point;
  }

 private:
  std::vector<Point>& points_;
  Point position_;
  Point last_;
};

void gather(Gathered& gathered, const Keyframe& keyframe, unsigned number, const Sightings& sightings) {
  gathered.begin_keyframe();
  for (const PointRun& run : point_runs(keyframe.points))
    for (std::size_t k = run.first; k < run.end; ++k) {
      const Point point = keyframe.T_local_base * keyframe.points[k];
      if (!run.may_walk || sightings.by_another(point, number)) gathered.add(point);
    }
}

}  // namespace

std::vector<Point> points_in_base(const Sample& sample) {
  std::vector<Point> points;
  for (const LaserView& view : sample.views)
    for (const ScanPoint& point : view.scan.points)
      if (point.position.allFinite()) points.push_back(view.T_base_laser * point.position);
  return points;
}

std::vector<Point> matched_points(const Point& position, const std::deque<Keyframe>& keyframes) {
  const std::vector<const Keyframe*> chosen = chosen_among(keyframes);
  const Sightings sightings(position, chosen);
  std::vector<Point> points;
  Gathered gathered(points, position);
  for (auto number = static_cast<unsigned>(chosen.size()); number-- > 0;)
    gather(gathered, *chosen[number], number, sightings);
  return points;
}

}  // namespace opal
