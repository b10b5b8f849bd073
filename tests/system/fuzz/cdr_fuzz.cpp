// The messages of ROS 2 recordings. Their decoders are compiled in: through the plugin, each input would need a
// database around it.
#include "plugins/ros2_bag/cdr_reader.cpp"
#include "plugins/ros2_bag/messages.cpp"
#include "plugins/ros2_bag/static_frames.cpp"

#include <opal/sensing/scan.hpp>

#include <cstdlib>

namespace {

void require(bool kept) {
  if (!kept) std::abort();
}

void check_frames(const std::vector<opal::ros2_bag::Transform>& transforms) {
  opal::ros2_bag::StaticFrames frames;
  for (const auto& transform : transforms) frames.add(transform);
  for (const auto& transform : transforms) frames.pose(transform.parent, transform.child);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const opal::ros2_bag::Bytes message(reinterpret_cast<const std::byte*>(data), size);
  if (const auto scan = opal::ros2_bag::decode_laser_scan(message)) {
    require(scan->ranges_m.size() * sizeof(float) <= size);
    opal::LaserModel laser;
    laser.geometry_from_log = true;
    const opal::Scan clean = opal::make_scan(*scan, laser);
    require(clean.points.size() + clean.free_bearings_rad.size() + static_cast<std::size_t>(clean.invalid) ==
            scan->ranges_m.size());
  }
  if (const auto odometry = opal::ros2_bag::decode_odometry(message))
    require(odometry->odometry.T_odom_base.position().allFinite());
  if (const auto transforms = opal::ros2_bag::decode_transforms(message)) check_frames(*transforms);
  return 0;
}
