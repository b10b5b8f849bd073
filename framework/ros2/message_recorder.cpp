#include "ros2/message_recorder.hpp"

#include "common/write_error.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

namespace opal::ros2 {
namespace {

/// drive.mcap, drive-2.mcap, drive-3.mcap ...
std::string numbered(const std::filesystem::path& path, int number) {
  if (number == 1) return path.string();
  const std::string name = path.stem().string() + "-" + std::to_string(number) + path.extension().string();
  return (path.parent_path() / name).string();
}

/// Makes a file that nobody else has: another node may ask for the same name at the same time.
std::string new_file(const std::string& path) {
  for (int number = 1;; ++number) {
    const std::string name = numbered(path, number);
    const int file = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file < 0 && errno != EEXIST) throw WriteError(name, errno);
    if (file < 0) continue;
    close(file);
    return name;
  }
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

FileRecorder::FileRecorder(const std::string& path)
    : path_(new_file(path)), file_(path_, std::ios::binary), recorder_(file_, path_) {}

}  // namespace opal::ros2
