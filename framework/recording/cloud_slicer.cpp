#include "recording/cloud_slicer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace opal::recording {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

/// What the beams of a slice have met so far.
class NearestByBeam {
 public:
  explicit NearestByBeam(int beams)
      : ranges_m_(static_cast<std::size_t>(beams), kUnknown), times_s_(ranges_m_.size()) {}

  void add(int beam, double range_m, double after_stamp_s) {
    const auto index = static_cast<std::size_t>(beam);
    if (ranges_m_[index] <= range_m) return;  // false for one that is unknown
    ranges_m_[index] = static_cast<float>(range_m);
    times_s_[index] = static_cast<float>(after_stamp_s);
  }

  /// The scan begins with its first point.
  void tell(RawScan& scan, bool with_times) {
    scan.ranges_m = std::move(ranges_m_);
    if (!with_times) return;
    float first_s = std::numeric_limits<float>::infinity();
    const auto has_time = [&](std::size_t i) { return !std::isnan(scan.ranges_m[i]) && std::isfinite(times_s_[i]); };
    for (std::size_t i = 0; i < times_s_.size(); ++i)
      if (has_time(i)) first_s = std::min(first_s, times_s_[i]);
    if (std::isinf(first_s)) return;
    for (std::size_t i = 0; i < times_s_.size(); ++i) times_s_[i] = has_time(i) ? times_s_[i] - first_s : 0;
    scan.stamp_s += double{first_s};
    scan.beam_times_s = std::move(times_s_);
  }

 private:
  std::vector<float> ranges_m_;
  std::vector<float> times_s_;
};

}  // namespace

Eigen::Isometry3d described_mount(const LaserModel& laser) {
  const Pose2& on_floor = laser.T_base_laser;
  const CloudSlice& slice = *laser.slice;
  Eigen::Isometry3d T_base_sensor = Eigen::Isometry3d::Identity();
  T_base_sensor.translation() = Eigen::Vector3d(on_floor.x(), on_floor.y(), slice.height_m);
  T_base_sensor.linear() = (Eigen::AngleAxisd(on_floor.heading_rad(), Eigen::Vector3d::UnitZ()) *
                            Eigen::AngleAxisd(slice.pitch_rad, Eigen::Vector3d::UnitY()) *
                            Eigen::AngleAxisd(slice.roll_rad, Eigen::Vector3d::UnitX()))
                               .toRotationMatrix();
  return T_base_sensor;
}

CloudSlicer::CloudSlicer(LaserModel laser) : laser_(std::move(laser)), T_base_sensor_(described_mount(laser_)) {}

void CloudSlicer::set_mount(const Eigen::Isometry3d& T_base_sensor) {
  if (laser_.geometry_from_log) T_base_sensor_ = T_base_sensor;
}

/// @return -1 for a direction in which no beam points.
int CloudSlicer::beam_of(const Point& position) const {
  constexpr double kRound = 2 * std::numbers::pi;
  const double slack_rad = laser_.angle_increment_rad / 2;
  double along_rad = std::fmod(std::atan2(position.y(), position.x()) - laser_.angle_min_rad + slack_rad, kRound);
  if (along_rad < 0) along_rad += kRound;
  const double beam = along_rad / laser_.angle_increment_rad;
  return beam < laser_.beams ? static_cast<int>(beam) : -1;
}

RawScan CloudSlicer::scan_of(const PointCloudMessage& cloud) const {
  RawScan scan;
  scan.stamp_s = cloud.stamp_s;
  scan.frame = cloud.frame;
  scan.angle_min_rad = laser_.angle_min_rad;
  scan.angle_increment_rad = laser_.angle_increment_rad;
  const Pose2 T_base_laser = projected(T_base_sensor_);
  const Pose2 T_laser_base = T_base_laser.inverse();
  const PointTimes times(cloud);
  NearestByBeam nearest(laser_.beams);
  cloud.for_each_point([&](const PointCloudMessage::CloudPoint& point) {
    if (!point.is_measured()) return;
    const Eigen::Vector3d seen(point.x_m, point.y_m, point.z_m);
    const double height_m = T_base_sensor_.linear().row(2).dot(seen) + T_base_sensor_.translation().z();
    if (height_m < laser_.slice->z_min_m || height_m > laser_.slice->z_max_m) return;
    const Point position = T_laser_base * Point((T_base_sensor_ * seen).head<2>());
    const double range_m = position.norm();
    if (range_m <= 0 || is_below(range_m, laser_.range_min_m)) return;
    const int beam = beam_of(position);
    if (beam >= 0) nearest.add(beam, range_m, times.are_known() ? times.after_stamp_s(point.time) : 0);
  });
  nearest.tell(scan, times.are_known());
  return scan;
}

}  // namespace opal::recording
