#include "sensor_health/range_habits.hpp"

#include <algorithm>

namespace opal {
namespace {

// Ranges are recorded to the centimetre. From other poses the farthest one is another one: on recorded logs two beams
// share it in three of a hundred scans at most. What stands for "nothing" returns in 18 of a hundred, or more.
constexpr std::ptrdiff_t kFewestAlike = 2;
constexpr int kFewestScans = 5;
constexpr double kFarther = 1.01;
constexpr std::size_t kMostRanges = 1000;  // that are kept; the rest says nothing new

}  // namespace

void RangeHabits::add(const Scan& scan) {
  const double beams = static_cast<double>(scan.points.size() + scan.free_bearings_rad.size()) + scan.invalid;
  if (beams == 0) return;
  ++scans_;
  beams_ += beams;
  hits_ += static_cast<double>(scan.points.size());
  if (scan.points.empty()) return;
  double farthest_m = 0;
  for (const ScanPoint& point : scan.points) farthest_m = std::max(farthest_m, point.range_m);
  if (farthest_m_.size() < kMostRanges) farthest_m_.push_back(farthest_m);
  const auto so_far = std::count_if(scan.points.begin(), scan.points.end(),
                                    [&](const ScanPoint& point) { return point.range_m == farthest_m; });
  if (so_far < kFewestAlike || repeated_.size() >= kMostRanges) return;
  Seen& seen = repeated_[farthest_m];
  ++seen.scans;
  seen.beam_share += static_cast<double>(so_far) / beams;
}

double RangeHabits::usable_share() const { return beams_ > 0 ? hits_ / beams_ : 1; }

std::optional<RangeHabits::Repeated> RangeHabits::repeated_farthest() const {
  const auto most = std::max_element(repeated_.begin(), repeated_.end(),
                                     [](const auto& a, const auto& b) { return a.second.scans < b.second.scans; });
  if (most == repeated_.end() || most->second.scans < kFewestScans) return std::nullopt;
  const auto farther = std::count_if(farthest_m_.begin(), farthest_m_.end(),
                                     [&](double range_m) { return range_m > kFarther * most->first; });
  const double scans = most->second.scans;
  return Repeated{most->first, scans / scans_, most->second.beam_share / scans,
                  static_cast<double>(farther) / static_cast<double>(farthest_m_.size())};
}

}  // namespace opal
