#pragma once

#include "ros2/messages/diagnosis.hpp"

#include <opal/common/geometry.hpp>

#include <ros2_messages.h>

#include <string>
#include <vector>

namespace opal::ros2 {

// Messages that point into what somebody else owns; nothing of them is ever freed.

using WireTime = builtin_interfaces_msg_dds__Time_;
using WireHeader = std_msgs_msg_dds__Header_;
using WirePose = geometry_msgs_msg_dds__Pose_;
using WireQuaternion = geometry_msgs_msg_dds__Quaternion_;
using WireMarker = visualization_msgs_msg_dds__Marker_;

/// Seconds since 1970, rounded to nanoseconds; what lies before 1970 is 0.
WireTime wire_time(double stamp_s);
/// @param frame  has to outlive the header.
WireHeader wire_header(double stamp_s, const std::string& frame);
/// On the floor, with a unit quaternion.
WireQuaternion wire_turn(double heading_rad);
WirePose wire_pose(const Pose2& pose);
/// A text as C writes it; has to outlive the message.
inline char* wire_text(const std::string& text) { return const_cast<char*>(text.c_str()); }

/// A sequence whose elements somebody else owns.
template <class Sequence, class Element>
Sequence wire_sequence(std::vector<Element>& elements) {
  Sequence sequence{};
  sequence._length = sequence._maximum = static_cast<std::uint32_t>(elements.size());
  sequence._buffer = reinterpret_cast<decltype(sequence._buffer)>(elements.data());
  return sequence;
}

/// A marker with nothing in it but what each one needs. @param kind  "walls". @param frame  has to outlive it, as kind.
WireMarker wire_marker(const WireHeader& header, const std::string& kind, std::int32_t id, std::int32_t type);

}  // namespace opal::ros2
