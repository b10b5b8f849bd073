#pragma once

#include "recording/containers/mcap_writer.hpp"
#include "recording/ros_log_reader.hpp"
#include "recording/ros_stream.hpp"
#include "tests/plugins/logs/bag_writer.hpp"

#include <opal/recording/mcap_recording.hpp>
#include <opal/recording/ros_log.hpp>

#include <map>
#include <sstream>
#include <string>
#include <vector>

/// What a robot with a laser sends, as tests make it.
namespace robot_messages {

using namespace opal;
using namespace opal::recording;

inline const Topic kScan{"/scan", "sensor_msgs/msg/LaserScan", Wire::cdr};
inline const Topic kTf{"/tf", "tf2_msgs/msg/TFMessage", Wire::cdr};
inline const Topic kStatic{"/tf_static", "tf2_msgs/msg/TFMessage", Wire::cdr};

inline ReceivedMessage received(const Topic& topic, double at_s, const std::string& data) {
  const auto* bytes = reinterpret_cast<const std::byte*>(data.data());
  return {topic, static_cast<std::int64_t>(at_s * 1e9), {bytes, bytes + data.size()}};
}

inline std::string scan_of(double stamp_s) {
  log_tests::LaserScanMessage scan;
  scan.stamp_s = stamp_s;
  return scan.bytes();
}

inline std::string odometry_link(double stamp_s, double x_m) {
  return log_tests::transforms_bytes({{"odom", "base", {x_m, 0, 0, 0, 0, 0, 1}}}, stamp_s);
}

inline std::string laser_link(double x_m) {
  return log_tests::transforms_bytes({{"base", "laser", {x_m, 0, 0, 1, 0, 0, 0}}});  // upside down
}

inline std::vector<LogRecord> streamed(RosStream& stream, const std::vector<ReceivedMessage>& messages) {
  std::vector<LogRecord> records;
  for (const ReceivedMessage& message : messages) {
    stream.take(message);
    while (const auto next = stream.next())
      if (next->record) records.push_back(*next->record);
  }
  return records;
}

/// A recording of them.
inline Parts parts_of(const std::vector<ReceivedMessage>& messages) {
  std::ostringstream out;
  McapWriter writer(out, "made.mcap");
  std::map<std::string, std::uint16_t> channels;
  for (const ReceivedMessage& message : messages) {
    const auto [channel, is_new] = channels.try_emplace(message.topic.name, 0);
    if (is_new)
      channel->second =
          writer.add_channel(message.topic.name, writer.add_schema(message.topic.type, "ros2msg", ""), "cdr");
    writer.write(channel->second, 0, message.received_ns, message.received_ns, message.bytes());
  }
  writer.finish();
  Parts parts;
  parts.push_back(read_mcap(std::make_unique<std::istringstream>(out.str()), "made.mcap"));
  return parts;
}

/// What a reader makes of that.
struct Recorded {
  explicit Recorded(const std::vector<ReceivedMessage>& messages, const TopicChoice& wanted = {}) {
    Parts parts = parts_of(messages);
    ChosenTopics chosen = choose_topics("made.mcap", parts, wanted);
    RosLogReader reader(std::move(parts), std::move(chosen));
    while (auto record = reader.next()) records.push_back(std::move(*record));
    defects = reader.defects();
  }
  std::vector<LogRecord> records;
  Defects defects;
};

}  // namespace robot_messages
