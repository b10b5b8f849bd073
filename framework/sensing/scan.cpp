#include <opal/sensing/scan.hpp>

#include "sensing/beam_order.hpp"

#include <algorithm>

namespace opal {
namespace {

struct Beams {
  double angle_min_rad;
  double angle_increment_rad;
  std::size_t count;
};

Beams beams_of(const RawScan& raw, const LaserModel& laser) {
  if (laser.geometry_from_log && raw.angle_min_rad && raw.angle_increment_rad)
    return {*raw.angle_min_rad, *raw.angle_increment_rad, raw.ranges_m.size()};
  const auto described = static_cast<std::size_t>(std::max(laser.beams, 0));
  return {laser.angle_min_rad, laser.angle_increment_rad, std::min(described, raw.ranges_m.size())};
}

enum class Reading { invalid, hit, free };

constexpr double kRounding_m = 5e-4;

Reading classify(double range_m, const LaserModel& laser) {
  if (std::isnan(range_m) || range_m <= 0 || range_m < laser.range_min_m - kRounding_m) return Reading::invalid;
  const bool is_hit = range_m <= laser.range_max_m + kRounding_m && is_below(range_m, laser.no_return_m);
  return is_hit ? Reading::hit : Reading::free;
}

}  // namespace

void sort_by_bearing(Scan& scan) {
  const auto nearer_right = [](const ScanPoint& a, const ScanPoint& b) { return a.bearing_rad < b.bearing_rad; };
  // Most lasers deliver their beams in this order already.
  if (!std::ranges::is_sorted(scan.points, nearer_right)) std::ranges::stable_sort(scan.points, nearer_right);
  if (!std::ranges::is_sorted(scan.free_bearings_rad)) std::ranges::sort(scan.free_bearings_rad);
}

bool is_below(double range_m, double limit_m) { return range_m < limit_m - kRounding_m; }

std::string name_of(const LaserModel& laser, std::size_t position) {
  if (!laser.frame.empty()) return laser.frame;
  return laser.topic.empty() ? std::to_string(position + 1) : laser.topic;
}

Scan make_scan(const RawScan& raw, const LaserModel& laser) {
  const Beams beams = beams_of(raw, laser);
  Scan scan;
  scan.stamp_s = raw.stamp_s;
  scan.angle_increment_rad = std::abs(beams.angle_increment_rad);
  scan.range_max_m = std::min(laser.range_max_m, laser.no_return_m);
  scan.invalid = static_cast<int>(raw.ranges_m.size() - beams.count);
  scan.points.reserve(beams.count);
  for (std::size_t i = 0; i < beams.count; ++i) {
    const double range_m = raw.ranges_m[i];
    const Reading reading = classify(range_m, laser);
    const double bearing_rad = wrap_angle(beams.angle_min_rad + static_cast<double>(i) * beams.angle_increment_rad);
    if (reading == Reading::hit)
      scan.points.push_back({range_m * unit_vector(bearing_rad), range_m, bearing_rad, static_cast<int>(i)});
    else if (reading == Reading::free)
      scan.free_bearings_rad.push_back(bearing_rad);
    else
      ++scan.invalid;
  }
  sort_by_bearing(scan);
  return scan;
}

}  // namespace opal
