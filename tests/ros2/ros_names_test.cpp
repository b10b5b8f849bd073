#include "ros2/network/ros_names.hpp"

#include <catch2/catch.hpp>

using namespace opal::ros2;

TEST_CASE("names of topics and types are those that ROS makes for DDS") {
  CHECK(dds_topic("/scan") == "rt/scan");
  CHECK(ros_topic("rt/robot1/scan") == "/robot1/scan");
  CHECK(ros_topic("rq/get_mapRequest").empty());
  CHECK(ros_type("sensor_msgs::msg::dds_::LaserScan_") == "sensor_msgs/msg/LaserScan");
  CHECK(ros_type("HelloWorld") == "HelloWorld");
}

TEST_CASE("a namespace stands before names that do not begin with a slash") {
  CHECK(topic_in("", "scan") == "/scan");
  CHECK(topic_in("robot1", "scan") == "/robot1/scan");
  CHECK(topic_in("/robot1/", "scan") == "/robot1/scan");
  CHECK(topic_in("robot1", "/tf") == "/tf");
}

TEST_CASE("names that ROS does not allow are told from those that it does") {
  for (const char* name : {"/scan", "/robot_1/front/scan"}) CHECK(is_topic_name(name));
  for (const char* name : {"", "/", "/1scan", "/scan/", "/a b", "//a"}) CHECK_FALSE(is_topic_name(name));
}
