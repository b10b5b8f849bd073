#pragma once

#include "recording/containers/mcap_writer.hpp"
#include "recording/ros_stream.hpp"

#include <fstream>

namespace opal::ros2 {

/// Keeps messages as they were received, as MCAP.
class MessageRecorder {
 public:
  /// @param out  must outlive it. @param name  what errors call it.
  MessageRecorder(std::ostream& out, const std::string& name) : writer_(out, name) {}
  /// @throws WriteError
  void write(const recording::ReceivedMessage& message);
  void finish() { writer_.finish(); }

 private:
  struct Channel {
    std::uint16_t number = 0;
    std::uint32_t messages = 0;
  };
  recording::McapWriter writer_;
  std::map<std::string, std::uint16_t> schemas_;  // by type
  std::map<std::string, Channel> channels_;       // by topic
};

/// The same into a new file. What was recorded before stays: beside drive.mcap the next one is drive-2.mcap.
class FileRecorder {
 public:
  /// @throws WriteError if the file cannot be made.
  explicit FileRecorder(const std::string& path);
  const std::string& path() const { return path_; }
  void write(const recording::ReceivedMessage& message) { recorder_.write(message); }
  void finish() { recorder_.finish(); }

 private:
  std::string path_;
  std::ofstream file_;
  MessageRecorder recorder_;
};

}  // namespace opal::ros2
