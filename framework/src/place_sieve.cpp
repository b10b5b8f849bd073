#include "place_sieve.hpp"

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
  const bool is_loose = observed.extent_max_m > observed.extent_min_m;
  const Pose2 T_frame_base = observed.frame.inverse();
  std::vector<Point> on_pattern;
  for (std::size_t from = 0; from < kStride; ++from)
    for (std::size_t k = from; k < points.size(); k += kStride) {
      const bool slides = is_loose && std::abs((T_frame_base * points[k]).y()) < kOnPattern_m;
      (slides ? on_pattern : points_).push_back(points[k]);
    }
  points_.insert(points_.end(), on_pattern.begin(), on_pattern.end());
  turned_.reserve(points_.size());
}

void TellingPoints::turn_to(double heading_rad) {
  turn_ = Pose2(0, 0, heading_rad);
  turned_.clear();
  for (std::size_t k = 0; k < kFirst; ++k) turned_.push_back(turn_.rotate(points_[k]));
}

float TellingPoints::coarse_nearness(const MapView& map, const Point& position, float bar) const {
  const std::span<const Point> first = std::span(turned_).first(kFirst);
  const float half = map.coarse_nearness_sum(first.first(kFirst / 2), position);
  if (half + static_cast<float>(kFirst / 2) < bar * static_cast<float>(kFirst)) return 0;
  return (half + map.coarse_nearness_sum(first.subspan(kFirst / 2), position)) / static_cast<float>(kFirst);
}

float TellingPoints::nearness(const MapView& map, const Point& position, double slack_m) {
  while (turned_.size() < points_.size()) turned_.push_back(turn_.rotate(points_[turned_.size()]));
  return map.nearness_sum(turned_, position, slack_m) / static_cast<float>(turned_.size());
}

}  // namespace opal
