// The messages of ROS recordings, as ROS 2 and as ROS 1 write them.
#include <opal/sensing/scan.hpp>
#include "recording/cloud_slicer.hpp"
#include "recording/cloud_tally.hpp"
#include "recording/fixed_frames.hpp"
#include "recording/ros_messages.hpp"

#include <cstdlib>

namespace {

using namespace opal::recording;

void require(bool kept) {
  if (!kept) std::abort();
}

void check_frames(const std::vector<Transform>& transforms) {
  SeenTransforms seen;
  for (const auto& transform : transforms) seen.add(transform, "/tf", false);
  const FixedFrames frames = seen.fixed_frames();
  for (const auto& transform : transforms) frames.pose(transform.parent, transform.child);
}

void check_cloud(Bytes message, Wire wire) {
  const DecodedPointCloud decoded = decode_point_cloud(message, wire);
  require(decoded.cloud.has_value() == decoded.complaint.empty());
  if (!decoded.cloud) return;
  require(decoded.cloud->size() <= message.size());  // each point has several bytes
  opal::LaserModel laser;
  laser.slice = opal::CloudSlice{-1, 1, 0, 0.1, 0.2};
  const opal::RawScan scan = CloudSlicer(laser).scan_of(*decoded.cloud);
  require(scan.ranges_m.size() == static_cast<std::size_t>(laser.beams));
  for (const float range_m : scan.ranges_m) require(!(range_m <= 0));
  for (const float time_s : scan.beam_times_s) require(time_s >= 0 && time_s < 3);
  CloudTally tally;
  tally.add(*decoded.cloud);
  tally.told("/points", std::nullopt);
}

void check_message(Bytes message, Wire wire) {
  if (const auto laser = decode_laser_scan(message, wire)) {
    require(laser->scan.ranges_m.size() * sizeof(float) <= message.size());
    opal::LaserModel model;
    model.geometry_from_log = true;
    const opal::Scan clean = opal::make_scan(laser->scan, model);
    require(clean.points.size() + clean.free_bearings_rad.size() + static_cast<std::size_t>(clean.invalid) ==
            laser->scan.ranges_m.size());
  }
  if (const auto odometry = decode_odometry(message, wire))
    require(odometry->odometry.T_odom_base.position().allFinite());
  if (const auto said = decode_hint(message, wire)) {
    require(said->hint.hint.T_map_base.position().allFinite());
    require(said->hint.hint.sigma_m > 0 && said->hint.hint.sigma_rad > 0);
  }
  decode_clock(message, wire);
  check_cloud(message, wire);
  if (const auto transforms = decode_transforms(message, wire)) check_frames(*transforms);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Bytes message(reinterpret_cast<const std::byte*>(data), size);
  check_message(message, Wire::cdr);
  check_message(message, Wire::ros1);
  return 0;
}
