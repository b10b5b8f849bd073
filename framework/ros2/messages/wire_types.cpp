#include "ros2/messages/wire_types.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace opal::ros2 {

WireTime wire_time(double stamp_s) {
  constexpr double kNanosecondsPerSecond = 1e9;
  const auto whole_ns = static_cast<std::int64_t>(std::llround(std::max(0.0, stamp_s) * kNanosecondsPerSecond));
  WireTime time{};
  time.sec = static_cast<std::int32_t>(whole_ns / 1'000'000'000);
  time.nanosec = static_cast<std::uint32_t>(whole_ns % 1'000'000'000);
  return time;
}

WireHeader wire_header(double stamp_s, const std::string& frame) {
  WireHeader header{};
  header.stamp = wire_time(stamp_s);
  header.frame_id = wire_text(frame);
  return header;
}

WireQuaternion wire_turn(double heading_rad) {
  WireQuaternion turn{};
  turn.z = std::sin(heading_rad / 2);
  turn.w = std::cos(heading_rad / 2);
  return turn;
}

WirePose wire_pose(const Pose2& pose) {
  WirePose wire{};
  wire.position.x = pose.x();
  wire.position.y = pose.y();
  wire.orientation = wire_turn(pose.heading_rad());
  return wire;
}

WireMarker wire_marker(const WireHeader& header, const std::string& kind, std::int32_t id, std::int32_t type) {
  static const std::string kNothing;
  WireMarker marker{};
  marker.header = header;
  marker.ns = wire_text(kind);
  marker.id = id;
  marker.type = type;
  marker.pose = wire_pose({});
  marker.color.a = 1;
  marker.texture_resource = marker.text = marker.mesh_resource = wire_text(kNothing);
  marker.texture.header.frame_id = marker.texture.format = marker.mesh_file.filename = wire_text(kNothing);
  return marker;
}

}  // namespace opal::ros2
