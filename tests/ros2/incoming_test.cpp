#include "ros2/incoming.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace opal;
using namespace opal::ros2;

const WantedTopic kScans{"/scan", "sensor_msgs/msg/LaserScan"};
const WantedTopic kFixed{"/tf_static", "tf2_msgs/msg/TFMessage", true, true};

Offer offer(const WantedTopic& wanted, bool reliable, bool transient_local) {
  return {wanted.topic, wanted.type, {reliable, transient_local, 1}};
}

}  // namespace

TEST_CASE("a topic is read with the quality that all who publish it offer") {
  CHECK(qualities_for(kScans, {}).empty());
  const auto reliable = [](const std::vector<Offer>& offers) { return qualities_for(kScans, offers).at(0).reliable; };
  CHECK(reliable({offer(kScans, true, false)}));
  CHECK_FALSE(reliable({offer(kScans, true, false), offer(kScans, false, false)}));
  const std::vector<Quality> kept = qualities_for(kScans, {offer(kScans, true, true), offer(kScans, true, false)});
  REQUIRE(kept.size() == 1);  // what was published before is not wanted
  CHECK_FALSE(kept[0].transient_local);
}

TEST_CASE("one volatile publisher does not keep from being read what others have kept") {
  const auto kinds = [](const std::vector<Offer>& offers) {
    std::vector<bool> all;
    for (const Quality& quality : qualities_for(kFixed, offers)) all.push_back(quality.transient_local);
    return all;
  };
  CHECK(kinds({offer(kFixed, true, true)}) == std::vector<bool>{true});
  CHECK(kinds({offer(kFixed, true, false)}) == std::vector<bool>{false});
  CHECK(kinds({offer(kFixed, true, true), offer(kFixed, false, false)}) == std::vector<bool>{false, true});
}

TEST_CASE("a topic that is not there is told, with others of its type") {
  CHECK(complaint_about(kScans, {offer(kScans, true, false)}).empty());
  CHECK(complaint_about(kScans, {}) == "/scan: nobody publishes it");
  const Offer front{"/front", kScans.type, {}};
  CHECK(complaint_about(kScans, {front}) ==
        "/scan: nobody publishes it; of type sensor_msgs/msg/LaserScan there is /front");
  const Offer cloud{"/scan", "sensor_msgs/msg/PointCloud2", {}};
  CHECK(complaint_about(kScans, {cloud}) ==
        "/scan: type sensor_msgs/msg/PointCloud2, expected sensor_msgs/msg/LaserScan");
  WantedTopic optional = kScans;
  optional.is_needed = false;
  CHECK(complaint_about(optional, {}).empty());
}

TEST_CASE("of several topics of odometry the usual one is taken, or none") {
  const std::string type = "nav_msgs/msg/Odometry";
  CHECK(usual_odometry({}).empty());
  CHECK(usual_odometry({{"/wheels", type, {}}}) == "/wheels");
  CHECK(usual_odometry({{"/wheels", type, {}}, {"/fused", type, {}}}).empty());
  CHECK(usual_odometry({{"/wheels", type, {}}, {"/odom", type, {}}}) == "/odom");
}
