#include "sensor_health/range_habits.hpp"

#include <algorithm>

namespace opal {
namespace {

// Ranges are recorded to the centimetre. From other poses the farthest one is another one: on recorded logs two beams
// share it in three of a hundred scans at most. What stands for "nothing" returns in 18 of a hundred, or more.
constexpr int kFewestAlike = 2;
constexpr int kFewestScans = 5;
constexpr double kFarther = 1.01;

}  // namespace

bool RangeHabits::ScanRanges::repeats() const { return so_far >= kFewestAlike; }

void RangeHabits::add(const Scan& scan) {
  const std::size_t beams = scan.points.size() + scan.free_bearings_rad.size() + static_cast<std::size_t>(scan.invalid);
  if (beams == 0) return;
  ScanRanges ranges{static_cast<int>(beams), static_cast<int>(scan.points.size()), 0, 0};
  for (const ScanPoint& point : scan.points) ranges.farthest_m = std::max(ranges.farthest_m, point.range_m);
  ranges.so_far = static_cast<int>(
      std::ranges::count_if(scan.points, [&](const ScanPoint& point) { return point.range_m == ranges.farthest_m; }));
  newest_.push_back(ranges);
  count(ranges, 1);
  if (newest_.size() <= kScans) return;
  count(newest_.front(), -1);
  newest_.pop_front();
}

void RangeHabits::count(const ScanRanges& ranges, int sign) {
  beams_ += sign * ranges.beams;
  hits_ += sign * ranges.hits;
  if (!ranges.repeats()) return;
  int& scans = repeated_[ranges.farthest_m];
  scans += sign;
  if (scans == 0) repeated_.erase(ranges.farthest_m);
}

double RangeHabits::usable_share() const { return beams_ > 0 ? static_cast<double>(hits_) / beams_ : 1; }

std::optional<RangeHabits::Repeated> RangeHabits::repeated_farthest() const {
  const auto most =
      std::ranges::max_element(repeated_, [](const auto& a, const auto& b) { return a.second < b.second; });
  if (most == repeated_.end() || most->second < kFewestScans) return std::nullopt;
  const auto [range_m, scans] = *most;
  double beam_share = 0, seen = 0, farther = 0;
  for (const ScanRanges& ranges : newest_) {
    if (ranges.hits == 0) continue;
    ++seen;
    if (ranges.farthest_m > kFarther * range_m) ++farther;
    if (ranges.repeats() && ranges.farthest_m == range_m)
      beam_share += static_cast<double>(ranges.so_far) / ranges.beams / scans;
  }
  return Repeated{range_m, static_cast<double>(scans) / this->scans(), beam_share, farther / seen};
}

}  // namespace opal
