#include "ros2/network/discovery_range.hpp"

#include <opal/common/error.hpp>
#include "common/phrases.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <sstream>

namespace opal::ros2 {
namespace {

// The ports of domains above end in those that the system gives away (DDSI-RTPS 2.5, 9.6.2.3).
constexpr unsigned kLastDomain = 232;
// So many participants may run on one machine without multicast: each is asked by its port.
constexpr int kMostNeighbours = 32;

unsigned domain_of(const std::string& text) {
  std::size_t read = 0;
  unsigned long domain = kLastDomain + 1;
  try {
    domain = std::stoul(text, &read);
  } catch (const std::exception&) {
  }
  if (read != text.size() || domain > kLastDomain || text.starts_with('-'))
    throw ConfigError("ROS_DOMAIN_ID: " + in_quotes(text) +
                      fmt::format(", expected a number from 0 to {}", kLastDomain));
  return static_cast<unsigned>(domain);
}

Reach reach_of(const std::string& place, const std::string& text) {
  if (text == "LOCALHOST" || text == "localhost" || text == "OFF") return Reach::localhost;
  if (text == "SUBNET" || text == "subnet") return Reach::subnet;
  if (text == "SYSTEM_DEFAULT" || text == "system") return Reach::system;
  throw ConfigError(place + ": " + in_quotes(text) + ", expected LOCALHOST, SUBNET or SYSTEM_DEFAULT");
}

/// Jazzy's variable wins over Humble's, as in ROS.
Reach reach_by(const Environment& environment) {
  const char* const kRange = "ROS_AUTOMATIC_DISCOVERY_RANGE";
  const char* const kLocalhost = "ROS_LOCALHOST_ONLY";
  if (const auto range = environment(kRange); range && !range->empty()) return reach_of(kRange, *range);
  const std::string only = environment(kLocalhost).value_or("");
  if (only == "1") return Reach::localhost;
  if (only == "0") return Reach::subnet;
  if (!only.empty()) throw ConfigError(std::string(kLocalhost) + ": " + in_quotes(only) + ", expected 0 or 1");
  return environment("CYCLONEDDS_URI").value_or("").empty() ? Reach::localhost : Reach::system;
}

std::vector<std::string> addresses_in(const std::string& list) {
  std::vector<std::string> addresses;
  std::istringstream words(list);
  for (std::string address; std::getline(words, address, ';');) {
    if (address.empty()) continue;
    if (address.find_first_of("<>\"'& ") != std::string::npos)
      throw ConfigError("ROS_STATIC_PEERS: " + in_quotes(address) + ", expected addresses with ; between them");
    addresses.push_back(address);
  }
  return addresses;
}

std::string peers_xml(const DiscoveryRange& range) {
  std::string xml = range.reach == Reach::localhost ? "<Peer address=\"127.0.0.1\"/>" : "";
  for (const std::string& peer : range.peers) xml += "<Peer address=\"" + peer + "\"/>";
  return xml.empty() ? "" : "<Peers>" + xml + "</Peers>";
}

}  // namespace

Environment process_environment() {
  return [](const std::string& name) -> std::optional<std::string> {
    const char* value = std::getenv(name.c_str());
    if (value == nullptr) return std::nullopt;
    return value;
  };
}

DiscoveryRange discovery_range(const Environment& environment, const DiscoveryOptions& options) {
  DiscoveryRange range;
  const std::string domain = environment("ROS_DOMAIN_ID").value_or("");
  if (!domain.empty()) range.domain = domain_of(domain);
  if (options.domain) range.domain = *options.domain;
  range.reach = options.reach.empty() ? reach_by(environment) : reach_of("--reach", options.reach);
  range.peers = addresses_in(environment("ROS_STATIC_PEERS").value_or(""));
  range.configuration = environment("CYCLONEDDS_URI").value_or("");
  return range;
}

std::string cyclone_configuration(const DiscoveryRange& range) {
  std::string general, discovery = peers_xml(range);
  if (range.reach == Reach::localhost) {
    general =
        "<General><Interfaces><NetworkInterface address=\"127.0.0.1\" multicast=\"false\"/></Interfaces>"
        "<AllowMulticast>false</AllowMulticast></General>";
    discovery += "<SPDPInterval>1s</SPDPInterval>";  // without multicast who starts later is found by being asked
    discovery +=
        fmt::format("<ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>{}</MaxAutoParticipantIndex>",
                    kMostNeighbours);
  }
  const std::string ours = "<CycloneDDS><Domain id=\"any\">" + general +
                           (discovery.empty() ? "" : "<Discovery>" + discovery + "</Discovery>") +
                           "</Domain></CycloneDDS>";
  return range.configuration.empty() ? ours : ours + "," + range.configuration;
}

std::string words_of(const DiscoveryRange& range) {
  const char* const reach = range.reach == Reach::localhost ? "on this machine only"
                            : range.reach == Reach::subnet  ? "in this network"
                                                            : "as CYCLONEDDS_URI says";
  return fmt::format("domain {}, {}", range.domain, reach) +
         (range.peers.empty() ? "" : ", beside " + listed(range.peers));
}

std::string limit_words(const DiscoveryRange& range) {
  if (range.reach != Reach::localhost) return "";
  return fmt::format(
      " ({} programs of DDS may run on this machine in domain {}; end one, or raise MaxAutoParticipantIndex in "
      "CYCLONEDDS_URI)",
      kMostNeighbours + 1, range.domain);
}

}  // namespace opal::ros2
