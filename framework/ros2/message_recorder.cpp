#include "ros2/message_recorder.hpp"

#include "common/write_error.hpp"

#include <cerrno>

namespace opal::ros2 {
namespace {

std::ofstream opened(const std::string& path) {
  errno = 0;
  std::ofstream file(path, std::ios::binary);
  if (!file) throw WriteError(path, errno);
  return file;
}

}  // namespace

void MessageRecorder::write(const recording::ReceivedMessage& message) {
  const auto [schema, is_new_type] = schemas_.try_emplace(message.topic.type, 0);
  if (is_new_type) schema->second = writer_.add_schema(message.topic.type, "ros2msg", "");
  const auto [channel, is_new_topic] = channels_.try_emplace(message.topic.name);
  if (is_new_topic) channel->second.number = writer_.add_channel(message.topic.name, schema->second, "cdr");
  writer_.write(channel->second.number, ++channel->second.messages, message.received_ns, message.received_ns,
                message.bytes());
}

FileRecorder::FileRecorder(const std::string& path) : file_(opened(path)), recorder_(file_, path) {}

}  // namespace opal::ros2
