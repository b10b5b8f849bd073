#pragma once

#include "ros2/network/discovery_range.hpp"

#include <opal/recording/recording.hpp>

#include <dds/dds.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace opal::ros2 {

/// A thing of DDS, deleted with this.
class Entity {
 public:
  Entity() = default;
  /// @throws Error if the handle is a failure. @param what  was to be made: "a reader of /scan".
  Entity(dds_entity_t handle, const std::string& what);
  ~Entity();
  Entity(Entity&& other) noexcept;
  Entity& operator=(Entity&& other) noexcept;

  dds_entity_t handle() const { return handle_; }
  explicit operator bool() const { return handle_ > 0; }

 private:
  dds_entity_t handle_ = 0;
};

/// How a topic is read or written.
struct Quality {
  bool reliable = true;
  bool transient_local = false;  ///< who comes later gets the last messages, too
  int depth = 10;                ///< messages that are kept

  bool operator==(const Quality&) const = default;
};
/// "reliable, volatile"
std::string words_of(const Quality& quality);

/// What somebody on the network publishes.
struct Offer {
  std::string topic;  ///< "/scan"
  std::string type;   ///< "sensor_msgs/msg/LaserScan"
  Quality quality;
};

/// This program on the network.
class Participant {
 public:
  /// @throws Error if DDS cannot be started.
  explicit Participant(const DiscoveryRange& range);

  /// What others publish as topics of ROS.
  std::vector<Offer> offers() const;
  /// Writes or reads a topic. @param topic  "/scan"
  Entity writer(const dds_topic_descriptor_t& type, const std::string& topic, const Quality& quality) const;
  Entity reader(const dds_topic_descriptor_t& type, const std::string& topic, const Quality& quality) const;
  dds_entity_t handle() const { return participant_.handle(); }

 private:
  Entity topic_of(const dds_topic_descriptor_t& type, const std::string& topic) const;

  Entity domain_;
  Entity participant_;
  Entity publications_;  // of everyone
};

/// A message as it was on the wire, with its encapsulation header. The bytes are valid during the call.
using TakeRaw = std::function<void(recording::Bytes)>;
/// Hands over all messages that have come.
void take_raw(const Entity& reader, const TakeRaw& take);
/// The policy by which writers and this reader do not fit; nullopt: none.
std::optional<std::string> incompatible_policy(const Entity& reader);

}  // namespace opal::ros2
