#include "ros2/network/discovery_range.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

#include <map>

namespace {

using namespace opal;
using namespace opal::ros2;

DiscoveryRange range_with(const std::map<std::string, std::string>& variables, const DiscoveryOptions& options = {}) {
  const Environment environment = [variables](const std::string& name) -> std::optional<std::string> {
    const auto found = variables.find(name);
    if (found == variables.end()) return std::nullopt;
    return found->second;
  };
  return discovery_range(environment, options);
}

}  // namespace

TEST_CASE("without any variable nobody outside of this machine is spoken to") {
  const DiscoveryRange range = range_with({});
  CHECK(range.domain == 0);
  CHECK(range.reach == Reach::localhost);
  const std::string xml = cyclone_configuration(range);
  CHECK_THAT(xml, Catch::Contains("address=\"127.0.0.1\" multicast=\"false\""));
  CHECK_THAT(xml, Catch::Contains("<Peer address=\"127.0.0.1\"/>"));
  CHECK_THAT(xml, Catch::Contains("<SPDPInterval>1s</SPDPInterval>"));  // else who starts later is found by chance
}

TEST_CASE("the variables of ROS mean what they mean there") {
  CHECK(range_with({{"ROS_DOMAIN_ID", "42"}}).domain == 42);
  CHECK(range_with({{"ROS_LOCALHOST_ONLY", "1"}}).reach == Reach::localhost);
  CHECK(range_with({{"ROS_LOCALHOST_ONLY", "0"}}).reach == Reach::subnet);
  CHECK(range_with({{"ROS_AUTOMATIC_DISCOVERY_RANGE", "SUBNET"}}).reach == Reach::subnet);
  CHECK(range_with({{"ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST"}}).reach == Reach::localhost);
  CHECK(range_with({{"ROS_AUTOMATIC_DISCOVERY_RANGE", "SYSTEM_DEFAULT"}}).reach == Reach::system);
  CHECK(range_with({{"ROS_AUTOMATIC_DISCOVERY_RANGE", "SUBNET"}, {"ROS_LOCALHOST_ONLY", "1"}}).reach == Reach::subnet);
  CHECK(range_with({{"CYCLONEDDS_URI", "file:///etc/dds.xml"}}).reach == Reach::system);
  const std::string xml = cyclone_configuration(range_with({{"ROS_STATIC_PEERS", "10.0.0.2;robot.local"}}));
  CHECK_THAT(xml, Catch::Contains("<Peer address=\"10.0.0.2\"/><Peer address=\"robot.local\"/>"));
}

TEST_CASE("options win over variables, and the configuration of Cyclone DDS has the last word") {
  const DiscoveryRange range = range_with({{"ROS_DOMAIN_ID", "42"}, {"ROS_LOCALHOST_ONLY", "1"}}, {7, "subnet"});
  CHECK(range.domain == 7);
  CHECK(range.reach == Reach::subnet);
  CHECK(words_of(range) == "domain 7, in this network");
  CHECK_THAT(cyclone_configuration(range_with({{"CYCLONEDDS_URI", "file:///etc/dds.xml"}})),
             Catch::EndsWith(",file:///etc/dds.xml"));
}

TEST_CASE("how many programs of DDS may run is told where this program sets the limit") {
  CHECK(limit_words(range_with({{"ROS_LOCALHOST_ONLY", "0"}})).empty());
  const DiscoveryRange here = range_with({{"ROS_LOCALHOST_ONLY", "1"}});
  CHECK_THAT(limit_words(here), Catch::Contains("programs of DDS may run on this machine in domain 0") &&
                                    Catch::Contains("MaxAutoParticipantIndex"));
}

TEST_CASE("a variable that makes no sense is named with what it holds") {
  CHECK_THROWS_WITH(range_with({{"ROS_DOMAIN_ID", "233"}}), "ROS_DOMAIN_ID: '233', expected a number from 0 to 232");
  CHECK_THROWS_WITH(range_with({{"ROS_DOMAIN_ID", "-1"}}), "ROS_DOMAIN_ID: '-1', expected a number from 0 to 232");
  CHECK_THROWS_WITH(range_with({{"ROS_DOMAIN_ID", "4x"}}), "ROS_DOMAIN_ID: '4x', expected a number from 0 to 232");
  CHECK_THROWS_WITH(range_with({{"ROS_LOCALHOST_ONLY", "yes"}}), "ROS_LOCALHOST_ONLY: 'yes', expected 0 or 1");
  CHECK_THROWS_WITH(range_with({{"ROS_AUTOMATIC_DISCOVERY_RANGE", "HERE"}}),
                    "ROS_AUTOMATIC_DISCOVERY_RANGE: 'HERE', expected LOCALHOST, SUBNET or SYSTEM_DEFAULT");
  CHECK_THROWS_WITH(range_with({{"ROS_STATIC_PEERS", "a\"/><x"}}),
                    "ROS_STATIC_PEERS: 'a\"/><x', expected addresses with ; between them");
}
