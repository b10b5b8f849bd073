#include "localization/search/coarse_to_fine.hpp"

#include "localization/search/pattern_lookup.hpp"

#include <algorithm>

namespace opal {

bool BestShare::passes(float value) {
  const auto bin = static_cast<int>(std::clamp(value, 0.0f, 1.0f) * (kBins - 1));
  ++counts_[bin];
  ++total_;
  if (bin >= lowest_) ++passing_;
  const auto wanted = std::max(few_, total_ / one_in_);
  while (lowest_ < kBins - 1 && passing_ - counts_[lowest_] >= wanted) passing_ -= counts_[lowest_++];
  return bin >= lowest_;
}

TellingPoints::TellingPoints(const PatternInstance& observed, std::span<const Point> points) {
  constexpr double kOnPattern_m = 0.3;
  constexpr std::size_t kStride = 5;
  const bool may_sweep = is_under_constrained(observed);
  const Pose2 T_frame_base = observed.frame.inverse();
  std::vector<Point> on_pattern;
  for (std::size_t from = 0; from < kStride; ++from)
    for (std::size_t k = from; k < points.size(); k += kStride) {
      const bool sweeps = may_sweep && std::abs((T_frame_base * points[k]).y()) < kOnPattern_m;
      (sweeps ? on_pattern : points_).push_back(points[k]);
    }
  points_.insert(points_.end(), on_pattern.begin(), on_pattern.end());
  turned_.reserve(points_.size());
}

TellingPoints::First TellingPoints::first() const {
  First first;
  std::copy_n(points_.begin(), kFirst, first.begin());
  return first;
}

void TellingPoints::turn_to(double heading_rad) {
  const Pose2 turn(0, 0, heading_rad);
  turned_.clear();
  for (const Point& point : points_) turned_.push_back(turn.rotate(point));
}

float TellingPoints::likelihood_field(const MapView& map, const Point& position, double slack_m) {
  return map.likelihood_field_sum(turned_, position, slack_m) / static_cast<float>(turned_.size());
}

TellingPoints::First turned(const TellingPoints::First& points, const Pose2& turn) {
  TellingPoints::First turned;
  for (std::size_t k = 0; k < points.size(); ++k) turned[k] = turn.rotate(points[k]);
  return turned;
}

float coarse_likelihood_field(const TellingPoints::First& points, const MapView& map, const Point& position,
                              float bar) {
  constexpr std::size_t kHalf = TellingPoints::kFirst / 2;
  constexpr float kAll = TellingPoints::kFirst;
  const std::span<const Point> all(points);
  const float half = map.coarse_likelihood_field_sum(all.first(kHalf), position);
  if (half + static_cast<float>(kHalf) < bar * kAll) return 0;
  return (half + map.coarse_likelihood_field_sum(all.subspan(kHalf), position)) / kAll;
}

}  // namespace opal
