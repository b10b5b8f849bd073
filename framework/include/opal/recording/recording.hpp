#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace opal::recording {

/// Bytes of a file or of a message, owned by someone else.
using Bytes = std::span<const std::byte>;
/// What is not whole, with its place, and how often.
using Defects = std::map<std::string, int>;

/// How the messages of a topic are written.
enum class Wire {
  cdr,    ///< plain CDR with its encapsulation header (OMG DDS-XTypes 1.3, 7.4.1), as ROS 2 writes it
  ros1,   ///< as ROS 1 writes it: little endian, without padding
  other,  ///< something that is not read
};

/// One topic of a recording.
struct Topic {
  std::string name;  ///< "/scan"
  std::string type;  ///< as it was recorded: "sensor_msgs/msg/LaserScan" (ROS 2), "sensor_msgs/LaserScan" (ROS 1)
  Wire wire = Wire::other;  ///< of its messages
};

/// When a message was recorded.
struct RecordedStamp {
  std::size_t topic = 0;         ///< index in Recording::topics
  std::int64_t recorded_ns = 0;  ///< since 1970, by the clock of the recorder
};

/// One recorded message.
struct Message {
  std::size_t topic = 0;         ///< index in Recording::topics
  std::int64_t recorded_ns = 0;  ///< since 1970, by the clock of the recorder
  Bytes data;                    ///< as it was sent; valid until the next message is asked for
};

/// Walks the messages of some topics by the time of their recording.
class MessageWalk {
 public:
  virtual ~MessageWalk();
  /// @return nullopt at the end. Messages that cannot be read are left out and counted.
  virtual std::optional<Message> next() = 0;
  /// What was left out so far.
  virtual const Defects& defects() const = 0;
};

/// One file of messages that robots sent each other. Walks must not outlive it. One thread at a time.
class Recording {
 public:
  virtual ~Recording();
  /// Topics of which there is a message, or of which the file says that they were recorded.
  virtual const std::vector<Topic>& topics() const = 0;
  /// When the first and the last message were recorded [ns]; zeros if there is none. Takes no time.
  virtual std::pair<std::int64_t, std::int64_t> span_ns() const = 0;
  /// All messages that the file has, by time. Taken from the file's index where it has one.
  virtual std::vector<RecordedStamp> stamps() const = 0;
  /// Messages of these topics (indices in `topics`), by time.
  virtual std::unique_ptr<MessageWalk> walk(const std::vector<std::size_t>& topics) const = 0;
  /// What of the file is not whole, as far as opening it has shown.
  virtual const Defects& defects() const = 0;
};

}  // namespace opal::recording
