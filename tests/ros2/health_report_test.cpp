#include "ros2/health_report.hpp"

#include <catch2/catch.hpp>

#include <sstream>

using namespace opal;
using namespace opal::ros2;

TEST_CASE("complaints are told two seconds after the start, then every five, and their end once") {
  std::ostringstream told;
  HealthReport report(told, 100);
  report.complaints({"no scans"}, 101);
  CHECK(told.str().empty());
  report.complaints({"no scans"}, 102.1);
  report.complaints({"no scans", "no odometry"}, 106);
  CHECK(told.str() == "ros2: no scans\n");
  report.complaints({}, 108);
  report.complaints({}, 120);
  CHECK(told.str() == "ros2: no scans\nros2: all that is needed is received\n");
}

TEST_CASE("a status is told when it changes, and each kind of damage once") {
  std::ostringstream told;
  HealthReport report(told, 0);
  LiveAnswer answer;
  report.status(answer);  // there is none yet
  answer.number = 1;
  answer.estimate.status = Status::lost;
  answer.why = "a reason";
  for (int k = 0; k < 2; ++k) report.status(answer);
  report.defects({{"damaged TFMessage", 1}});
  report.defects({{"damaged TFMessage", 2}, {"laser that is tilted", 1}});
  CHECK(told.str() == "ros2: lost: a reason\nros2: damaged TFMessage\nros2: laser that is tilted\n");
}
