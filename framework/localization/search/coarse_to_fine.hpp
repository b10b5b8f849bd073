#pragma once

#include <opal/common/geometry.hpp>
#include <opal/map/view/map_view.hpp>
#include <opal/patterns/pattern.hpp>

#include <array>
#include <span>
#include <vector>

namespace opal {

/// Lets pass about the best share of all values in [0, 1] so far, and whatever comes while there are few.
class OPAL_EXPORT BestShare {
 public:
  BestShare(std::size_t few, std::size_t one_in) : few_(few), one_in_(one_in) {}
  bool passes(float value);
  /// What is less does not pass.
  float bar() const { return static_cast<float>(lowest_) / (kBins - 1); }

 private:
  static constexpr int kBins = 128;
  std::size_t few_, one_in_;
  std::array<std::size_t, kBins> counts_{};
  std::size_t total_ = 0, passing_ = 0;
  int lowest_ = 0;
};

/// The points of a scan as they would lie on the map, in an order in which few of them say much: those along which the
/// observed pattern could sweep come last, since they lie on the map wherever it sweeps to; the others are spread over
/// the scan.
class OPAL_EXPORT TellingPoints {
 public:
  TellingPoints(const PatternInstance& observed, std::span<const Point> points);
  std::size_t size() const { return points_.size(); }
  /// Fewer tell nothing.
  bool enough() const { return points_.size() >= 2 * kFirst; }

  /// The first few, as they lie about the robot.
  static constexpr std::size_t kFirst = 10;
  using First = std::array<Point, kFirst>;
  First first() const;

  /// From here on the robot has this heading.
  void turn_to(double heading_rad);
  /// Mean likelihood-field score of all points. @param slack_m  as MapView::likelihood_field_sum.
  float likelihood_field(const MapView& map, const Point& position, double slack_m = 0);

 private:
  std::vector<Point> points_, turned_;
};

/// As they lie in axes that are turned.
TellingPoints::First turned(const TellingPoints::First& points, const Pose2& turn);

/// Mean likelihood-field score to the map in large cells, the robot being at `position`; 0 as soon as it is sure to be
/// less than `bar`.
float coarse_likelihood_field(const TellingPoints::First& points, const MapView& map, const Point& position, float bar);

}  // namespace opal
