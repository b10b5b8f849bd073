#include "sensor_health/wheel_slip.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace opal {
namespace {

constexpr double kOver_m = 2;          // of driving that is looked at
constexpr double kMost = 1.3;          // times more than the other
constexpr double kLeastApart_m = 0.4;  // so that a stop is no slip

}  // namespace

void WheelSlip::add(double by_odometry_m, double by_scans_m) {
  steps_.push_back({by_odometry_m, by_scans_m});
  sum_.by_odometry_m += by_odometry_m;
  sum_.by_scans_m += by_scans_m;
  while (std::max(sum_.by_odometry_m - steps_.front().by_odometry_m, sum_.by_scans_m - steps_.front().by_scans_m) >
         kOver_m) {
    sum_.by_odometry_m -= steps_.front().by_odometry_m;
    sum_.by_scans_m -= steps_.front().by_scans_m;
    steps_.pop_front();
  }
}

void WheelSlip::clear() {
  steps_.clear();
  sum_ = {0, 0};
}

std::optional<SensorFinding> WheelSlip::finding() const {
  const auto [odometry_m, scans_m] = sum_;
  const auto [less_m, more_m] = std::minmax(odometry_m, scans_m);
  if (more_m < kOver_m / 2 || more_m - less_m < kLeastApart_m || more_m < kMost * less_m) return std::nullopt;
  return SensorFinding{
      SensorFinding::Subject::odometry_distance,
      SensorFinding::Verdict::doubtful,
      odometry_m > 0 ? scans_m / odometry_m : 0,
      1,
      0,
      fmt::format("odometry counts {:.1f} m where scans move by {:.1f} m: do the wheels slip?", odometry_m, scans_m)};
}

}  // namespace opal
