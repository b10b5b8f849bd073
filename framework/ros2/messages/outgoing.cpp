#include "ros2/messages/outgoing.hpp"

#include "ros2/messages/wire_types.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace opal::ros2 {
namespace {

// As visualization_msgs/Marker numbers them.
constexpr std::int32_t kArrow = 0, kText = 9, kDeleteAll = 3;

const Quality kStream{true, false, 100};
const Quality kLatched{true, true, 1};  // as map_server and AMCL offer it

const std::string kPlacesKind = "opal places";

// Row by row of a 6 x 6 matrix of x, y, z and the turns about them.
constexpr int kXX = 0, kXY = 1, kYX = 6, kYY = 7, kHeading = 35;

/// Whoever listens slowly loses messages: that is not this program's failure.
void send(const Entity& writer, const void* message) { dds_write(writer.handle(), message); }

WireMarker place_marker(const WireHeader& header, std::int32_t id, const PossiblePlace& place, std::int32_t type) {
  WireMarker marker = wire_marker(header, kPlacesKind, 2 * id + (type == kText ? 1 : 0), type);
  marker.pose = wire_pose(place.T_map_base);
  marker.scale.x = 0.8;  // [m]: as long as a robot
  marker.scale.y = marker.scale.z = type == kText ? 0.4 : 0.15;
  marker.pose.position.z = type == kText ? 0.6 : 0.05;
  const auto share = static_cast<float>(std::clamp(place.probability, 0.0, 1.0));
  marker.color.r = 1;
  marker.color.g = 1 - share;
  marker.color.a = 0.4f + 0.6f * share;
  return marker;
}

void send_markers(const Entity& writer, std::vector<WireMarker>& markers) {
  visualization_msgs_msg_dds__MarkerArray_ message{};
  message.markers = wire_sequence<decltype(message.markers)>(markers);
  send(writer, &message);
}

void send_transform(const Entity& writer, const PlacedFrame& frame) {
  geometry_msgs_msg_dds__TransformStamped_ transform{};
  transform.header = wire_header(frame.stamp_s, frame.parent);
  transform.child_frame_id = wire_text(frame.child);
  transform.transform.translation.x = frame.T_parent_child.x();
  transform.transform.translation.y = frame.T_parent_child.y();
  transform.transform.rotation = wire_turn(frame.T_parent_child.heading_rad());
  std::vector<geometry_msgs_msg_dds__TransformStamped_> transforms{transform};
  tf2_msgs_msg_dds__TFMessage_ message{};
  message.transforms = wire_sequence<decltype(message.transforms)>(transforms);
  send(writer, &message);
}

void send_pose(const Entity& writer, const LocalizedPose& pose, const std::string& frame) {
  geometry_msgs_msg_dds__PoseWithCovarianceStamped_ message{};
  message.header = wire_header(pose.stamp_s, frame);
  message.pose.pose = wire_pose(pose.T_map_base);
  message.pose.covariance[kXX] = pose.covariance(0, 0);
  message.pose.covariance[kXY] = message.pose.covariance[kYX] = pose.covariance(0, 1);
  message.pose.covariance[kYY] = pose.covariance(1, 1);
  message.pose.covariance[kHeading] = pose.covariance(2, 2);
  send(writer, &message);
}

}  // namespace

Outgoing::Outgoing(const Participant& participant, const OutgoingTopics& topics, FrameOptions frames)
    : frames_(std::move(frames)),
      tf_(participant.writer(tf2_msgs_msg_dds__TFMessage__desc, topics.tf, kStream)),
      pose_(participant.writer(geometry_msgs_msg_dds__PoseWithCovarianceStamped__desc, topics.pose, kLatched)),
      places_(participant.writer(geometry_msgs_msg_dds__PoseArray__desc, topics.places, kLatched)),
      markers_(participant.writer(visualization_msgs_msg_dds__MarkerArray__desc, topics.markers, kLatched)),
      map_(participant.writer(nav_msgs_msg_dds__OccupancyGrid__desc, topics.map, kLatched)),
      walls_(participant.writer(visualization_msgs_msg_dds__MarkerArray__desc, topics.walls, kLatched)),
      diagnostics_(participant.writer(diagnostic_msgs_msg_dds__DiagnosticArray__desc, topics.diagnostics, kStream)) {}

void Outgoing::publish(const Announcement& announcement) {
  if (announcement.map_to_odom) send_transform(tf_, *announcement.map_to_odom);
  if (announcement.pose) send_pose(pose_, *announcement.pose, frames_.map);
  const bool show = !announcement.places.empty();
  if (!show && !std::exchange(shows_places_, show)) return;  // said already that there are none
  shows_places_ = show;
  const WireHeader header = wire_header(announcement.stamp_s, frames_.map);
  std::vector<WirePose> poses;
  std::vector<WireMarker> markers{wire_marker(header, kPlacesKind, 0, kArrow)};
  markers.front().action = kDeleteAll;
  std::vector<std::string> texts;
  for (const PossiblePlace& place : announcement.places)
    texts.push_back(fmt::format("{:.0f} %", 100 * place.probability));
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const PossiblePlace& place = announcement.places[i];
    poses.push_back(wire_pose(place.T_map_base));
    markers.push_back(place_marker(header, static_cast<std::int32_t>(i), place, kArrow));
    markers.push_back(place_marker(header, static_cast<std::int32_t>(i), place, kText));
    markers.back().text = wire_text(texts[i]);
  }
  geometry_msgs_msg_dds__PoseArray_ message{};
  message.header = header;
  message.poses = wire_sequence<decltype(message.poses)>(poses);
  send(places_, &message);
  send_markers(markers_, markers);
}

void Outgoing::publish(const std::vector<Diagnosis>& diagnoses, double now_s) {
  using WireKeyValues = std::vector<diagnostic_msgs_msg_dds__KeyValue_>;
  static const std::string kNoFrame, kHardware = "opal";
  std::vector<WireKeyValues> values(diagnoses.size());
  std::vector<diagnostic_msgs_msg_dds__DiagnosticStatus_> statuses(diagnoses.size());
  for (std::size_t i = 0; i < diagnoses.size(); ++i) {
    for (const auto& [key, value] : diagnoses[i].values) values[i].push_back({wire_text(key), wire_text(value)});
    statuses[i].level = static_cast<std::uint8_t>(diagnoses[i].level);
    statuses[i].name = wire_text(diagnoses[i].name);
    statuses[i].message = wire_text(diagnoses[i].message);
    statuses[i].hardware_id = wire_text(kHardware);
    statuses[i].values = wire_sequence<decltype(statuses[i].values)>(values[i]);
  }
  diagnostic_msgs_msg_dds__DiagnosticArray_ message{};
  message.header = wire_header(now_s, kNoFrame);
  message.status = wire_sequence<decltype(message.status)>(statuses);
  send(diagnostics_, &message);
}

}  // namespace opal::ros2
