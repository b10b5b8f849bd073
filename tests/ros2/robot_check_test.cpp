#include "ros2/robot_check.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::ros2;

TEST_CASE("a topic that nobody has chosen may be silent") {
  recording::TopicChoice choice;
  CHECK_FALSE(is_chosen(choice, "/idle_scan"));
  choice.scans = {"/front"};
  choice.odometry = "/odom";
  choice.slices["/points"] = {};
  for (const char* topic : {"/front", "/odom", "/points"}) CHECK(is_chosen(choice, topic));
  for (const char* topic : {"/idle_scan", "/wheels", "/tf"}) CHECK_FALSE(is_chosen(choice, topic));
}
