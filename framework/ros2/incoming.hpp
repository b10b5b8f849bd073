#pragma once

#include "recording/ros_stream.hpp"
#include "ros2/network/participant.hpp"

#include <map>

namespace opal::ros2 {

/// A topic that is read.
struct WantedTopic {
  std::string topic;             ///< "/scan"
  std::string type;              ///< "sensor_msgs/msg/LaserScan"
  bool is_needed = true;         ///< its absence is worth a complaint
  bool transient_local = false;  ///< what was published before is wanted, too
};

/// How a topic is read of which others offer this: everything that they send, and nothing that they do not offer. Where
/// only some publishers keep what was published before, each kind of them has a reader of its own: one volatile
/// publisher must not keep what the others have kept from being read.
/// @return a quality for each reader; none if nobody offers the topic with its type.
std::vector<Quality> qualities_for(const WantedTopic& wanted, const std::vector<Offer>& offers);
/// What keeps a topic from being read, in words; empty: nothing.
std::string complaint_about(const WantedTopic& wanted, const std::vector<Offer>& offers);

/// The only topic of odometry, or /odom; empty if there is none, or several.
std::string usual_odometry(const std::vector<Offer>& offers);

/// Reads topics, with the quality that is offered. One thread at a time.
class Incoming {
 public:
  /// @param participant  must outlive it.
  explicit Incoming(const Participant& participant);

  void want(const WantedTopic& wanted);
  bool wants(const std::string& topic) const { return topics_.contains(topic); }
  /// Whether somebody publishes it, and it is read.
  bool reads(const std::string& topic) const {
    const auto found = topics_.find(topic);
    return found != topics_.end() && !found->second.readers.empty();
  }
  /// Makes readers for what is offered by now, and others where the offer has changed.
  void adapt();
  using Sink = std::function<void(recording::ReceivedMessage)>;
  /// Waits for messages and hands over all that have come. Times of receipt increase.
  void take(double timeout_s, const Sink& sink);

  /// What is wanted and does not come, by topic.
  std::vector<std::string> complaints() const;
  /// Of the messages since the last call.
  std::map<std::string, double> take_rates_hz();
  const std::vector<Offer>& offers() const { return offers_; }

 private:
  struct Reader {
    Quality quality;
    Entity entity;
  };
  struct Subscription {
    WantedTopic wanted;
    std::map<bool, Reader> readers = {};  // by whether they are transient local
    std::int64_t since_ns = 0;            // when the newest reader was made; these by a steady clock
    std::int64_t newest_ns = 0;           // when the last message came; 0: none has
    int since_asked = 0;                  // messages
  };
  void subscribe(Subscription& subscription, const Quality& quality);
  void take_from(Subscription& subscription, const Entity& reader, const Sink& sink);
  std::int64_t next_receipt_ns();

  const Participant& participant_;
  Entity waitset_;  // after the participant, before the readers that are attached to it
  std::map<std::string, Subscription> topics_;
  std::vector<Offer> offers_;
  std::int64_t last_receipt_ns_ = 0;
  std::int64_t rates_since_ns_ = 0;
};

/// What describes the messages of a type: "nav_msgs/msg/Odometry". @throws Error for one that is not known.
const dds_topic_descriptor_t& descriptor_of(const std::string& type);
/// Nanoseconds since 1970.
std::int64_t system_ns();

}  // namespace opal::ros2
