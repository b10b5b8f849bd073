#include "sensor_health/range_habits.hpp"

#include <algorithm>

namespace opal {
namespace {

// A wall seen squarely gives a few equal ranges, never this share of a scan; ranges are recorded to the centimetre.
constexpr double kManyBeams = 0.03;
constexpr int kFewestScans = 5;
constexpr std::size_t kMostRanges = 1000;  // of different farthest ranges; the rest says nothing new

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
  const auto so_far = std::count_if(scan.points.begin(), scan.points.end(),
                                    [&](const ScanPoint& point) { return point.range_m == farthest_m; });
  const double share = static_cast<double>(so_far) / beams;
  if (share < kManyBeams || farthest_.size() >= kMostRanges) return;
  Seen& seen = farthest_[farthest_m];
  ++seen.scans;
  seen.beam_share += share;
}

double RangeHabits::usable_share() const { return beams_ > 0 ? hits_ / beams_ : 1; }

std::optional<RangeHabits::Repeated> RangeHabits::repeated_farthest() const {
  const auto most = std::max_element(farthest_.begin(), farthest_.end(),
                                     [](const auto& a, const auto& b) { return a.second.scans < b.second.scans; });
  if (most == farthest_.end() || most->second.scans < kFewestScans) return std::nullopt;
  const double scans = most->second.scans;
  return Repeated{most->first, scans / scans_, most->second.beam_share / scans};
}

}  // namespace opal
