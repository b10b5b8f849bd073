#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace opal::ros2 {

/// With whom messages are exchanged.
enum class Reach {
  localhost,  ///< with programs on this machine
  subnet,     ///< with machines that multicast reaches, too
  system,     ///< as the configuration of Cyclone DDS says
};

/// How other participants are found.
struct DiscoveryRange {
  unsigned domain = 0;
  Reach reach = Reach::localhost;
  std::vector<std::string> peers;  ///< addresses that are asked beside those
  std::string configuration;       ///< CYCLONEDDS_URI: it has the last word
};

/// What options say; they win over the environment.
struct DiscoveryOptions {
  std::optional<unsigned> domain;
  std::string reach;  ///< "localhost", "subnet", "system"; empty: as the environment says
};

/// The value of a variable, nullopt if it is not set.
using Environment = std::function<std::optional<std::string>(const std::string& name)>;
/// That of this process.
Environment process_environment();

/// What ROS_DOMAIN_ID, ROS_AUTOMATIC_DISCOVERY_RANGE, ROS_LOCALHOST_ONLY, ROS_STATIC_PEERS and CYCLONEDDS_URI say.
/// Without any of them nobody outside of this machine is spoken to.
/// @throws ConfigError naming the variable, what it holds and what was expected.
DiscoveryRange discovery_range(const Environment& environment, const DiscoveryOptions& options = {});

/// The same for Cyclone DDS: XML.
std::string cyclone_configuration(const DiscoveryRange& range);
/// In words: "domain 0, on this machine only".
std::string words_of(const DiscoveryRange& range);
/// What DDS allows no more of, if no participant can be made; empty: this program sets no limit.
std::string limit_words(const DiscoveryRange& range);

}  // namespace opal::ros2
