#include "deployment_text.hpp"

#include <catch2/catch.hpp>

#include <numbers>

using namespace opal;

TEST_CASE("a deployment knows whether it says where all its lasers sit") {
  const std::string scorers = R"("scorers": [{"@type": "a"}], )", mount = R"("T_base_laser": {"x_m": 0.2})";
  CHECK_FALSE(parsed(scorers + R"("sensor": {"beams": 361})").describes_mount);
  CHECK(parsed(scorers + R"("sensor": {)" + mount + "}").describes_mount);
  CHECK_FALSE(parsed(scorers + R"("sensor": [{"frame": "a", )" + mount + R"(}, {"frame": "b"}])").describes_mount);
  CHECK(parsed(scorers + R"("sensor": [{"frame": "a", )" + mount + R"(}, {"frame": "b", )" + mount + "}]")
            .describes_mount);
}

TEST_CASE("a sensor with a slice sees all around, unless it says otherwise, and heights have defaults") {
  const Deployment deployment =
      parsed(R"("sensor": { "topic": "/points", "slice": { "z_min_m": 0.4, "pitch_rad": 0.1 } })");
  const LaserModel& laser = deployment.lasers.front();
  REQUIRE(laser.slice);
  CHECK(laser.slice->z_min_m == 0.4);
  CHECK(laser.slice->z_max_m == 1.8);
  CHECK(laser.slice->pitch_rad == 0.1);
  CHECK(laser.beams == 720);
  CHECK(laser.beams * laser.angle_increment_rad == Approx(2 * std::numbers::pi));
  CHECK(parsed(R"("sensor": { "topic": "/points", "beams": 90, "slice": {} })").lasers.front().beams == 90);
  CHECK_FALSE(parsed(R"("sensor": { "topic": "/scan" })").lasers.front().slice);
}
