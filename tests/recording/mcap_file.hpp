#pragma once

#include "recording/containers/mcap_writer.hpp"

#include <opal/recording/mcap_recording.hpp>

#include <sstream>

namespace opal::recording_tests {

using recording::McapOptions;

inline recording::Bytes bytes_of(const std::string& text) { return std::as_bytes(std::span(text)); }

/// Two topics with `messages` each, by turns, a tenth of a second apart; the first message is at 1 s.
inline std::string two_topics(const McapOptions& options, int messages) {
  std::ostringstream out;
  recording::McapWriter writer(out, "made.mcap", options);
  const auto schema = writer.add_schema("sensor_msgs/msg/LaserScan", "ros2msg", "float32[] ranges");
  const auto front = writer.add_channel("/front", schema, "cdr", {{"offered_qos_profiles", ""}});
  const auto rear = writer.add_channel("/rear", schema, "cdr");
  for (int i = 0; i < messages; ++i) {
    const std::int64_t stamp_ns = 1'000'000'000 + 100'000'000LL * i;
    const auto number = static_cast<std::uint32_t>(i);
    writer.write(front, number, stamp_ns, stamp_ns, bytes_of("front " + std::to_string(i)));
    writer.write(rear, number, stamp_ns + 1, stamp_ns, bytes_of("rear " + std::to_string(i)));
  }
  writer.finish();
  return out.str();
}

struct ReadFile {
  std::vector<std::string> messages;
  recording::Defects defects;  // of the file and of its messages
  std::vector<recording::Topic> topics;
  std::size_t stamps = 0;
};

inline ReadFile read_file(const std::string& bytes) {
  const auto file = recording::read_mcap(std::make_unique<std::istringstream>(bytes), "made.mcap");
  ReadFile read{{}, file->defects(), file->topics(), file->stamps().size()};
  std::vector<std::size_t> topics;
  for (std::size_t i = 0; i < file->topics().size(); ++i) topics.push_back(i);
  const auto walk = file->walk(topics);
  while (const auto message = walk->next())
    read.messages.emplace_back(reinterpret_cast<const char*>(message->data.data()), message->data.size());
  for (const auto& [cause, times] : walk->defects()) read.defects[cause] += times;
  return read;
}

}  // namespace opal::recording_tests
