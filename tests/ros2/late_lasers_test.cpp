#include "ros2/late_lasers.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::ros2;

namespace {

using Verdict = LateLasers::Verdict;

RawScan scan_of(const std::string& frame, std::size_t beams = 361) {
  RawScan scan;
  scan.frame = frame;
  scan.ranges_m.assign(beams, 2.0f);
  return scan;
}

LaserModel laser(const std::string& frame) {
  LaserModel model;
  model.frame = frame;
  model.beams = 361;
  return model;
}

}  // namespace

TEST_CASE("a late laser that is as described joins, and another one is left out for good") {
  LateLasers late;
  late.begin({laser("front"), laser("rear"), laser("left")}, 3, std::vector<LogRecord>{scan_of("front")});
  CHECK(late.take(scan_of("front")) == Verdict::usual);
  CHECK(late.take(OdometryRecord{1, Pose2()}) == Verdict::usual);
  CHECK(late.take(scan_of("rear")) == Verdict::joins);
  CHECK(late.take(scan_of("rear")) == Verdict::usual);
  CHECK(late.take(scan_of("left", 181)) == Verdict::does_not_fit);
  CHECK(late.objection().find("361 beams") != std::string::npos);
  CHECK(late.take(scan_of("left", 361)) == Verdict::is_left_out);
}

TEST_CASE("a late laser that the localizer was made without begins a new one, with a scan of each laser") {
  LateLasers late;
  late.begin({laser("front")}, 2, std::vector<LogRecord>{scan_of("front"), scan_of("front")});
  CHECK(late.take(scan_of("rear")) == Verdict::begins_anew);
  CHECK(late.first_scans().size() == 2);
  late.begin({laser("front"), laser("rear")}, 2, late.first_scans());
  CHECK(late.take(scan_of("rear")) == Verdict::usual);
  CHECK(late.first_scans().size() == 2);
}

TEST_CASE("a late laser with which no localizer can be made is left out") {
  LateLasers late;
  late.begin({laser("front")}, 2, std::vector<LogRecord>{scan_of("front")});
  CHECK(late.take(scan_of("rear")) == Verdict::begins_anew);
  late.leave_out("rear");
  CHECK(late.first_scans().size() == 1);
  CHECK(late.take(scan_of("rear")) == Verdict::is_left_out);
}

TEST_CASE("scans that nobody describes begin nothing where all lasers are known") {
  LateLasers late;
  late.begin({laser("front"), laser("rear")}, 2, std::vector<LogRecord>{scan_of("front"), scan_of("rear")});
  CHECK(late.take(scan_of("other")) == Verdict::usual);
  LateLasers single;
  single.begin({laser("")}, 1, std::vector<LogRecord>{scan_of("any")});
  CHECK(single.take(scan_of("other")) == Verdict::usual);
}
