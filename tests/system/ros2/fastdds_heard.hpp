// What the robot of Fast DDS hears, in words: a line a message.
#pragma once

#include "ros2_messagesPubSubTypes.h"

#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>

#include <cmath>
#include <cstdio>
#include <iostream>
#include <mutex>
#include <sstream>
#include <string>

namespace heard {

using namespace eprosima::fastdds::dds;

inline std::mutex printing;

inline void print(const std::string& line) {
  if (line.empty()) return;
  const std::lock_guard<std::mutex> lock(printing);
  std::cout << line << std::endl;
}

inline std::string words(const builtin_interfaces::msg::dds_::Time_& time) {
  char text[40];
  std::snprintf(text, sizeof text, "%d.%09u", time.sec(), time.nanosec());
  return text;
}

template <class Message>
class Printer : public DataReaderListener {
 public:
  using Words = std::string (*)(const Message&);
  explicit Printer(Words words_of) : words_of_(words_of) {}
  void on_data_available(DataReader* reader) override {
    Message message;
    SampleInfo info;
    while (reader->take_next_sample(&message, &info) == ReturnCode_t::RETCODE_OK)
      if (info.valid_data) print(words_of_(message));
  }

 private:
  Words words_of_;
};

using Transforms = tf2_msgs::msg::dds_::TFMessage_;
using Pose = geometry_msgs::msg::dds_::PoseWithCovarianceStamped_;
using Places = geometry_msgs::msg::dds_::PoseArray_;
using Markers = visualization_msgs::msg::dds_::MarkerArray_;
using Grid = nav_msgs::msg::dds_::OccupancyGrid_;
using Diagnostics = diagnostic_msgs::msg::dds_::DiagnosticArray_;

inline std::string words_of_turn(const geometry_msgs::msg::dds_::Quaternion_& turn) {
  std::ostringstream line;
  line << std::hypot(std::hypot(turn.x(), turn.y()), std::hypot(turn.z(), turn.w())) << ' '
       << 2 * std::atan2(turn.z(), turn.w());
  return line.str();
}

/// "transform STAMP PARENT CHILD X Y NORM HEADING", those from the map only.
inline std::string words_of_transforms(const Transforms& message) {
  std::ostringstream line;
  line.precision(12);
  for (const auto& link : message.transforms())
    if (link.header().frame_id() == "map")
      line << "transform " << words(link.header().stamp()) << ' ' << link.header().frame_id() << ' '
           << link.child_frame_id() << ' ' << link.transform().translation().x() << ' '
           << link.transform().translation().y() << ' ' << words_of_turn(link.transform().rotation());
  return line.str();
}

/// "pose STAMP FRAME X Y NORM HEADING COVARIANCE..."
inline std::string words_of_pose(const Pose& message) {
  std::ostringstream line;
  line.precision(12);
  line << "pose " << words(message.header().stamp()) << ' ' << message.header().frame_id() << ' '
       << message.pose().pose().position().x() << ' ' << message.pose().pose().position().y() << ' '
       << words_of_turn(message.pose().pose().orientation());
  for (const double entry : message.pose().covariance()) line << ' ' << entry;
  return line.str();
}

inline std::string words_of_places(const Places& message) {
  return "places " + words(message.header().stamp()) + ' ' + std::to_string(message.poses().size());
}

inline std::string words_of_markers(const Markers& message) {
  std::string line = "markers " + std::to_string(message.markers().size());
  for (const auto& marker : message.markers())
    if (!marker.text().empty()) line += " \"" + marker.text() + '"';
  return line;
}

inline std::string words_of_grid(const Grid& message) {
  std::size_t occupied = 0;
  for (const unsigned char cell : message.data()) occupied += cell == 100 ? 1 : 0;
  return "map " + std::to_string(message.info().width()) + ' ' + std::to_string(message.info().height()) + ' ' +
         std::to_string(message.data().size()) + ' ' + std::to_string(occupied);
}

inline std::string words_of_diagnostics(const Diagnostics& message) {
  std::string text;
  for (const auto& status : message.status()) {
    text += (text.empty() ? "" : "\n") + std::string("diagnostic ") + std::to_string(int(status.level())) + " [" +
            status.name() + "] " + status.message() + " {";
    for (const auto& value : status.values()) text += " " + value.key() + "=" + value.value();
    text += " }";
  }
  return text;
}

}  // namespace heard
