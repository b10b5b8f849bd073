#pragma once

#include "recording/point_cloud.hpp"
#include "recording/ros_messages.hpp"

namespace opal::recording {

/// Makes planar scans of one 3D lidar's point clouds.
///
/// A point counts if it lies between the heights of the slice, above the floor of the robot's frame, and farther from
/// the sensor than range_min_m: what is nearer is the robot itself. It belongs to the beam that points nearest to it,
/// seen from the sensor's place on the floor plan. The nearest point of a beam is its range, a horizontal distance. A
/// beam without a point is unknown (NaN): whether the lidar has a ray there that met nothing, or none, the cloud does
/// not tell. Only a nearest point beyond range_max_m says that the beam is free.
class CloudSlicer {
 public:
  /// @param laser  has a slice; its mount holds until `set_mount` gives another one.
  explicit CloudSlicer(LaserModel laser);

  const LaserModel& laser() const { return laser_; }
  /// Where the log says that the sensor is. It holds if the laser takes its geometry from the log.
  void set_mount(const Eigen::Isometry3d& T_base_sensor);
  /// @return the scan, stamped when the first point was measured if the cloud tells so, else as the cloud.
  RawScan scan_of(const PointCloudMessage& cloud) const;

 private:
  int beam_of(const Point& position) const;

  LaserModel laser_;
  Eigen::Isometry3d T_base_sensor_;
};

/// The pose of a sliced sensor, as a deployment describes it.
Eigen::Isometry3d described_mount(const LaserModel& laser);

}  // namespace opal::recording
