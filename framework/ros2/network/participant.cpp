#include "ros2/network/participant.hpp"

#include <opal/common/error.hpp>
#include "ros2/network/ros_names.hpp"

#include <algorithm>
#include <cstring>
#include <memory>
#include <utility>

namespace opal::ros2 {
namespace {

// Publishing must not wait for long for somebody who listens slowly.
constexpr dds_duration_t kLongestWrite = DDS_MSECS(20);
// What `ros2 node list` looks for.
constexpr const char* kUserData = "enclave=/;";

struct DeleteQos {
  void operator()(dds_qos_t* qos) const { dds_delete_qos(qos); }
};
using Qos = std::unique_ptr<dds_qos_t, DeleteQos>;

Qos qos_of(const Quality& quality) {
  Qos qos(dds_create_qos());
  dds_qset_reliability(qos.get(), quality.reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                       kLongestWrite);
  dds_qset_durability(qos.get(), quality.transient_local ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, quality.depth);
  dds_qset_writer_data_lifecycle(qos.get(), false);
  dds_qset_ignorelocal(qos.get(), DDS_IGNORELOCAL_PARTICIPANT);  // what this program publishes itself
  const dds_data_representation_id_t plain_cdr = DDS_DATA_REPRESENTATION_XCDR1;
  dds_qset_data_representation(qos.get(), 1, &plain_cdr);
  return qos;
}

Quality quality_of(const dds_qos_t* qos) {
  Quality quality;
  dds_reliability_kind_t reliability = DDS_RELIABILITY_BEST_EFFORT;
  dds_durability_kind_t durability = DDS_DURABILITY_VOLATILE;
  dds_duration_t unused = 0;
  quality.reliable = dds_qget_reliability(qos, &reliability, &unused) && reliability == DDS_RELIABILITY_RELIABLE;
  quality.transient_local = dds_qget_durability(qos, &durability) && durability >= DDS_DURABILITY_TRANSIENT_LOCAL;
  return quality;
}

Entity make_participant(const DiscoveryRange& range) {
  Qos qos(dds_create_qos());
  dds_qset_userdata(qos.get(), kUserData, std::strlen(kUserData));
  return {dds_create_participant(range.domain, qos.get(), nullptr), "a participant of DDS" + limit_words(range)};
}

bool is_own(const dds_builtintopic_endpoint_t& endpoint, const dds_guid_t& own) {
  return std::memcmp(endpoint.participant_key.v, own.v, sizeof own.v) == 0;
}

const char* name_of_policy(dds_qos_policy_id_t policy) {
  switch (policy) {
    case DDS_DURABILITY_QOS_POLICY_ID: return "durability";
    case DDS_DEADLINE_QOS_POLICY_ID: return "deadline";
    case DDS_LATENCYBUDGET_QOS_POLICY_ID: return "latency budget";
    case DDS_OWNERSHIP_QOS_POLICY_ID: return "ownership";
    case DDS_LIVELINESS_QOS_POLICY_ID: return "liveliness";
    case DDS_RELIABILITY_QOS_POLICY_ID: return "reliability";
    case DDS_PARTITION_QOS_POLICY_ID: return "partition";
    case DDS_DATA_REPRESENTATION_QOS_POLICY_ID: return "data representation";
    default: return "another policy";
  }
}

/// Who publishes in the network, as long as this lives. A node of ROS 2 has about ten publishers.
class Publications {
 public:
  explicit Publications(const Entity& reader) : reader_(reader) {
    for (std::size_t most = 512; read(most) == most && most < kMost;) {
      give_back();
      most *= 2;
    }
  }
  ~Publications() { give_back(); }
  Publications(const Publications&) = delete;
  Publications& operator=(const Publications&) = delete;

  std::vector<const dds_builtintopic_endpoint_t*> endpoints() const {
    std::vector<const dds_builtintopic_endpoint_t*> endpoints;
    for (std::size_t i = 0; i < count_; ++i)
      if (infos_[i].valid_data) endpoints.push_back(static_cast<const dds_builtintopic_endpoint_t*>(samples_[i]));
    return endpoints;
  }

 private:
  static constexpr std::size_t kMost = 1 << 17;

  std::size_t read(std::size_t most) {
    samples_.assign(most, nullptr);
    infos_.resize(most);
    const dds_return_t count =
        dds_read_mask(reader_.handle(), samples_.data(), infos_.data(), most, static_cast<std::uint32_t>(most),
                      DDS_ANY_SAMPLE_STATE | DDS_ANY_VIEW_STATE | DDS_ALIVE_INSTANCE_STATE);
    return count_ = static_cast<std::size_t>(std::max<dds_return_t>(0, count));
  }
  void give_back() {
    if (count_ > 0) dds_return_loan(reader_.handle(), samples_.data(), static_cast<std::int32_t>(count_));
    count_ = 0;
  }

  const Entity& reader_;
  std::vector<void*> samples_;
  std::vector<dds_sample_info_t> infos_;
  std::size_t count_ = 0;
};

}  // namespace

Entity::Entity(dds_entity_t handle, const std::string& what) : handle_(handle) {
  if (handle < 0) throw Error(what + ": cannot be made: " + dds_strretcode(handle));
}

Entity::~Entity() {
  if (handle_ > 0) dds_delete(handle_);
}

Entity::Entity(Entity&& other) noexcept : handle_(std::exchange(other.handle_, 0)) {}

Entity& Entity::operator=(Entity&& other) noexcept {
  std::swap(handle_, other.handle_);
  return *this;
}

std::string words_of(const Quality& quality) {
  return std::string(quality.reliable ? "reliable" : "best effort") + ", " +
         (quality.transient_local ? "transient local" : "volatile");
}

Participant::Participant(const DiscoveryRange& range)
    : domain_(dds_create_domain(range.domain, cyclone_configuration(range).c_str()),
              "DDS domain " + std::to_string(range.domain)),
      participant_(make_participant(range)),
      publications_(dds_create_reader(participant_.handle(), DDS_BUILTIN_TOPIC_DCPSPUBLICATION, nullptr, nullptr),
                    "a reader of who publishes") {}

std::vector<Offer> Participant::offers() const {
  dds_guid_t own{};
  dds_get_guid(participant_.handle(), &own);
  const Publications all(publications_);
  std::vector<Offer> offers;
  for (const dds_builtintopic_endpoint_t* endpoint : all.endpoints()) {
    if (is_own(*endpoint, own)) continue;
    Offer offer{ros_topic(endpoint->topic_name), ros_type(endpoint->type_name), quality_of(endpoint->qos)};
    if (!offer.topic.empty()) offers.push_back(std::move(offer));
  }
  return offers;
}

Entity Participant::topic_of(const dds_topic_descriptor_t& type, const std::string& topic) const {
  return {dds_create_topic(participant_.handle(), &type, dds_topic(topic).c_str(), nullptr, nullptr), "topic " + topic};
}

Entity Participant::writer(const dds_topic_descriptor_t& type, const std::string& topic, const Quality& quality) const {
  const Entity of = topic_of(type, topic);  // lives on in what uses it
  return {dds_create_writer(participant_.handle(), of.handle(), qos_of(quality).get(), nullptr),
          "a writer of " + topic};
}

Entity Participant::reader(const dds_topic_descriptor_t& type, const std::string& topic, const Quality& quality) const {
  const Entity of = topic_of(type, topic);
  return {dds_create_reader(participant_.handle(), of.handle(), qos_of(quality).get(), nullptr),
          "a reader of " + topic};
}

std::optional<std::string> incompatible_policy(const Entity& reader) {
  dds_requested_incompatible_qos_status_t status{};
  if (dds_get_requested_incompatible_qos_status(reader.handle(), &status) != DDS_RETCODE_OK || status.total_count == 0)
    return std::nullopt;
  return name_of_policy(static_cast<dds_qos_policy_id_t>(status.last_policy_id));
}

}  // namespace opal::ros2
