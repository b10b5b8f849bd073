#include "ros2/incoming.hpp"
#include "ros2/pose_hint.hpp"
#include "tests/plugins/logs/bag_writer.hpp"

#include <catch2/catch.hpp>

#include <numbers>

namespace {

using namespace opal;
using namespace opal::ros2;

const WantedTopic kScans{"/scan", "sensor_msgs/msg/LaserScan"};
const WantedTopic kFixed{"/tf_static", "tf2_msgs/msg/TFMessage", true, true};

Offer offer(const WantedTopic& wanted, bool reliable, bool transient_local) {
  return {wanted.topic, wanted.type, {reliable, transient_local, 1}};
}

std::string hint_bytes(double x, double heading_rad, double variance) {
  log_tests::CdrWriter cdr;
  cdr.header(5, "map").pose({x, 2, 0, 0, 0, std::sin(heading_rad / 2), std::cos(heading_rad / 2)});
  for (int i = 0; i < 36; ++i) cdr.number(i == 0 || i == 7 || i == 35 ? variance : 0.0);
  return cdr.bytes();
}

recording::Bytes as_bytes(const std::string& text) { return std::as_bytes(std::span(text)); }

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

TEST_CASE("a pose of RViz becomes a hint with its spread") {
  const auto framed = decode_pose_hint(as_bytes(hint_bytes(1, 2.5, 0.04)));
  REQUIRE(framed);
  CHECK(framed->frame == "map");
  CHECK(framed->hint.T_map_base.x() == 1);
  CHECK(framed->hint.T_map_base.heading_rad() == Approx(2.5));
  CHECK(framed->hint.sigma_m == Approx(0.2));
  CHECK(decode_pose_hint(as_bytes(hint_bytes(1, 2.5, 0)))->hint.sigma_m == Approx(0.5));
}

TEST_CASE("a hint that is no pose, or cut anywhere, is none") {
  const std::string whole = hint_bytes(1, 0, 1);
  for (std::size_t length = 0; length < whole.size(); ++length)
    CHECK_FALSE(decode_pose_hint(as_bytes(whole.substr(0, length))));
  CHECK_FALSE(decode_pose_hint(as_bytes(hint_bytes(std::numeric_limits<double>::quiet_NaN(), 0, 1))));
}

TEST_CASE("of several topics of odometry the usual one is taken, or none") {
  const std::string type = "nav_msgs/msg/Odometry";
  CHECK(usual_odometry({}).empty());
  CHECK(usual_odometry({{"/wheels", type, {}}}) == "/wheels");
  CHECK(usual_odometry({{"/wheels", type, {}}, {"/fused", type, {}}}).empty());
  CHECK(usual_odometry({{"/wheels", type, {}}, {"/odom", type, {}}}) == "/odom");
}
