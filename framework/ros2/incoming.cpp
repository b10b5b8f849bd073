#include "ros2/incoming.hpp"

#include <opal/common/error.hpp>
#include "common/phrases.hpp"
#include "ros2/messages/wire_types.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <set>

namespace opal::ros2 {
namespace {

// A hundred seconds of transforms; a hundred scans while the program does something else.
constexpr int kReadDepth = 1000;
// A cloud has a megabyte.
constexpr int kReadClouds = 20;
constexpr double kSilentS = 2;

std::set<std::string> topics_of_type(const std::vector<Offer>& offers, const std::string& type) {
  std::set<std::string> topics;
  for (const Offer& offer : offers)
    if (offer.type == type) topics.insert(offer.topic);
  return topics;
}

bool fits(const Offer& offer, const WantedTopic& wanted) {
  return offer.topic == wanted.topic && offer.type == wanted.type;
}

template <class Clock>
std::int64_t ns_of() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now().time_since_epoch()).count();
}

/// Tells how long something takes, also while somebody sets the clock.
std::int64_t steady_ns() { return ns_of<std::chrono::steady_clock>(); }

}  // namespace

std::int64_t system_ns() { return ns_of<std::chrono::system_clock>(); }

const dds_topic_descriptor_t& descriptor_of(const std::string& type) {
  static const std::map<std::string, const dds_topic_descriptor_t*> kTypes{
      {"sensor_msgs/msg/LaserScan", &sensor_msgs_msg_dds__LaserScan__desc},
      {"sensor_msgs/msg/PointCloud2", &sensor_msgs_msg_dds__PointCloud2__desc},
      {"nav_msgs/msg/Odometry", &nav_msgs_msg_dds__Odometry__desc},
      {"tf2_msgs/msg/TFMessage", &tf2_msgs_msg_dds__TFMessage__desc},
      {"geometry_msgs/msg/PoseWithCovarianceStamped", &geometry_msgs_msg_dds__PoseWithCovarianceStamped__desc},
      {"rosgraph_msgs/msg/Clock", &rosgraph_msgs_msg_dds__Clock__desc},
      {"std_msgs/msg/Empty", &std_msgs_msg_dds__Empty__desc}};
  const auto found = kTypes.find(type);
  if (found == kTypes.end()) throw Error(type + ": messages that cannot be read");
  return *found->second;
}

std::vector<Quality> qualities_for(const WantedTopic& wanted, const std::vector<Offer>& offers) {
  const int depth = wanted.type == "sensor_msgs/msg/PointCloud2" ? kReadClouds : kReadDepth;
  std::map<bool, Quality> qualities;  // by whether they are transient local
  for (const Offer& offer : offers) {
    if (!fits(offer, wanted)) continue;
    const bool is_kept = wanted.transient_local && offer.quality.transient_local;
    Quality& quality = qualities.try_emplace(is_kept, Quality{true, is_kept, depth}).first->second;
    quality.reliable = quality.reliable && offer.quality.reliable;
  }
  std::vector<Quality> all;
  for (const auto& [is_kept, quality] : qualities) all.push_back(quality);
  return all;
}

std::string usual_odometry(const std::vector<Offer>& offers) {
  std::set<std::string> topics;
  for (const Offer& offer : offers)
    if (offer.type == "nav_msgs/msg/Odometry") topics.insert(offer.topic);
  if (topics.contains("/odom")) return "/odom";
  return topics.size() == 1 ? *topics.begin() : "";
}

std::string complaint_about(const WantedTopic& wanted, const std::vector<Offer>& offers) {
  std::string other_type;
  for (const Offer& offer : offers) {
    if (fits(offer, wanted)) return "";
    if (offer.topic == wanted.topic) other_type = offer.type;
  }
  if (!wanted.is_needed) return "";
  if (!other_type.empty()) return wanted.topic + ": type " + other_type + ", expected " + wanted.type;
  const std::set<std::string> others = topics_of_type(offers, wanted.type);
  return wanted.topic + ": nobody publishes it" +
         (others.empty() ? "" : "; of type " + wanted.type + " there is " + listed(others));
}

Incoming::Incoming(const Participant& participant)
    : participant_(participant),
      waitset_(dds_create_waitset(participant.handle()), "a set of readers"),
      rates_since_ns_(steady_ns()) {}

void Incoming::want(const WantedTopic& wanted) {
  descriptor_of(wanted.type);  // complains at once
  topics_[wanted.topic].wanted = wanted;
}

void Incoming::subscribe(Subscription& subscription, const Quality& quality) {
  Reader& reader = subscription.readers[quality.transient_local];
  if (reader.entity) dds_waitset_detach(waitset_.handle(), reader.entity.handle());
  reader.entity = {};
  const WantedTopic& wanted = subscription.wanted;
  reader.entity = participant_.reader(descriptor_of(wanted.type), wanted.topic, quality);
  reader.quality = quality;
  subscription.since_ns = steady_ns();
  dds_set_status_mask(reader.entity.handle(), DDS_DATA_AVAILABLE_STATUS);
  dds_waitset_attach(waitset_.handle(), reader.entity.handle(), 0);
}

void Incoming::adapt() {
  offers_ = participant_.offers();
  for (auto& [topic, subscription] : topics_)
    for (const Quality& quality : qualities_for(subscription.wanted, offers_)) {
      const auto reader = subscription.readers.find(quality.transient_local);
      const bool is_served =
          reader != subscription.readers.end() && (quality.reliable || !reader->second.quality.reliable);
      if (!is_served) subscribe(subscription, quality);
    }
}

std::int64_t Incoming::next_receipt_ns() { return last_receipt_ns_ = std::max(system_ns(), last_receipt_ns_ + 1); }

void Incoming::take_from(Subscription& subscription, const Entity& reader, const Sink& sink) {
  take_raw(reader, [&](recording::Bytes bytes) {
    subscription.newest_ns = steady_ns();
    ++subscription.since_asked;
    sink({{subscription.wanted.topic, subscription.wanted.type, recording::Wire::cdr},
          next_receipt_ns(),
          {bytes.begin(), bytes.end()}});
  });
}

void Incoming::take(double timeout_s, const Sink& sink) {
  dds_waitset_wait(waitset_.handle(), nullptr, 0, static_cast<dds_duration_t>(timeout_s * 1e9));
  for (auto& [topic, subscription] : topics_)
    for (const auto& [is_kept, reader] : subscription.readers) take_from(subscription, reader.entity, sink);
}

std::vector<std::string> Incoming::complaints() const {
  std::vector<std::string> complaints;
  for (const auto& [topic, subscription] : topics_) {
    std::string words = complaint_about(subscription.wanted, offers_);
    const std::int64_t awaited_since_ns = std::max(subscription.newest_ns, subscription.since_ns);
    const double silent_s = 1e-9 * static_cast<double>(steady_ns() - awaited_since_ns);
    if (words.empty() && subscription.readers.size() == 1)  // two are there, because publishers differ
      if (const auto policy = incompatible_policy(subscription.readers.begin()->second.entity))
        words = topic + ": somebody publishes it with another quality of service: " + *policy;
    if (words.empty() && subscription.wanted.is_needed && silent_s > kSilentS && !subscription.wanted.transient_local)
      words = topic + (subscription.newest_ns == 0 ? ": somebody publishes it, but no message has come"
                                                   : fmt::format(": no message for {:.0f} s", silent_s));
    if (!words.empty()) complaints.push_back(words);
  }
  return complaints;
}

std::map<std::string, double> Incoming::take_rates_hz() {
  std::map<std::string, double> rates_hz;
  const double since_s = std::max(1e-3, 1e-9 * static_cast<double>(steady_ns() - rates_since_ns_));
  for (auto& [topic, subscription] : topics_) {
    if (subscription.newest_ns != 0) rates_hz[topic] = subscription.since_asked / since_s;
    subscription.since_asked = 0;
  }
  rates_since_ns_ = steady_ns();
  return rates_hz;
}

}  // namespace opal::ros2
