#include "live/stream_health.hpp"

#include <catch2/catch.hpp>

using namespace opal;

namespace {

constexpr double kNoClock = std::numeric_limits<double>::quiet_NaN();

/// A robot with one laser whose records arrive as they are stamped, unless a test lets them come later.
struct Listened {
  StreamHealth health{{LaserModel{}}, LiveOptions{}};
  double now_s = 1000;
  double late_s = 0;

  void hear(int records, double every_s, bool scans_too = true) {
    for (int k = 0; k < records; ++k) {
      now_s += every_s;
      RawScan scan;
      scan.stamp_s = now_s - late_s;
      health.take(OdometryRecord{now_s - late_s, Pose2()}, now_s, now_s);
      if (scans_too) health.take(scan, now_s, now_s);
    }
  }
  /// Words about one subject.
  std::vector<std::string> said(const std::string& subject, double after_s = 0.01) const {
    std::vector<std::string> words;
    for (const HealthFinding& finding : health.findings(now_s + after_s))
      if (finding.subject == subject) words.push_back(finding.words);
    return words;
  }
};

using Words = std::vector<std::string>;

}  // namespace

TEST_CASE("records at a steady rate are fine, whatever the rate") {
  const double every_s = GENERATE(0.01, 0.1, 0.9);
  Listened robot;
  robot.hear(120, every_s);
  CHECK(robot.health.findings(robot.now_s + 0.01).empty());
}

TEST_CASE("records that come more slowly than they used to are told with both rates") {
  Listened robot;
  robot.hear(60, 0.1);
  robot.hear(20, 0.2);
  // The newest tenth counts for an average of late, the newest hundredth for the usual one.
  CHECK(robot.said("odometry") == Words{"odometry: 5.3 records a second, 8.0 before"});
  CHECK(robot.said("laser") == Words{"laser: 5.3 records a second, 8.0 before"});
  robot.hear(20, 0.1);
  CHECK(robot.said("odometry").empty());
}

TEST_CASE("records that waited for the map, and come all at once, are no faster rate") {
  Listened robot;
  robot.hear(10, 1e-6);
  for (int k = 0; k < 150; ++k) {
    robot.hear(1, 0.1);
    CHECK(robot.health.findings(robot.now_s + 0.01).empty());
  }
}

TEST_CASE("a rate is known after fifty records") {
  Listened robot;
  robot.hear(30, 0.1);
  robot.hear(15, 0.2);
  CHECK(robot.said("odometry").empty());
  robot.hear(6, 0.2);
  CHECK(robot.said("odometry").size() == 1);
}

TEST_CASE("a sensor is silent after a second, and after five of its intervals") {
  Listened often, seldom;
  often.hear(60, 0.1);
  CHECK(often.said("odometry", 0.95).empty());
  CHECK(often.said("odometry", 1.2) == Words{"odometry: no odometry for 1.2 s"});
  seldom.hear(60, 0.5);
  CHECK(seldom.said("odometry", 2.4).empty());
  CHECK(seldom.said("odometry", 2.6) == Words{"odometry: no odometry for 2.6 s"});
}

TEST_CASE("a sensor that was never heard is missing after three seconds") {
  Listened robot;
  robot.hear(29, 0.1, false);
  CHECK(robot.said("laser").empty());
  robot.hear(3, 0.1, false);
  CHECK(robot.said("laser").size() == 1);
}

TEST_CASE("records that arrive late, or before their stamps, are told by how much on average") {
  Listened late, early;
  late.late_s = 0.7;
  late.hear(10, 0.1);
  CHECK(late.said("odometry") == Words{"odometry: arrives 0.70 s after its stamps"});
  late.late_s = 0;
  late.hear(10, 0.1);
  CHECK(late.said("odometry").empty());
  early.late_s = -0.3;
  early.hear(10, 0.1);
  CHECK(early.said("odometry").size() == 1);
}

TEST_CASE("stamps of an unknown clock are neither late nor early") {
  StreamHealth health({LaserModel{}}, LiveOptions{});
  for (int k = 0; k < 10; ++k) health.take(OdometryRecord{5e6 + k, Pose2()}, k * 0.1, kNoClock);
  CHECK(health.findings(1).empty());
}

TEST_CASE("what is odd in records is told for a while, by how often it came since it began to be told") {
  Listened robot;
  robot.hear(60, 0.1);
  robot.health.note({{"gap", 4}}, robot.now_s);
  CHECK(robot.said("scans") == Words{"gap: 4 times of late"});
  robot.hear(20, 0.1);
  robot.health.note({{"gap", 6}}, robot.now_s);
  CHECK(robot.said("scans") == Words{"gap: 6 times of late"});
  robot.hear(31, 0.1);
  robot.health.note({{"gap", 6}}, robot.now_s);
  CHECK(robot.said("scans").empty());
  robot.health.note({{"gap", 7}, {"clock reset", 1}, {"odometry jump", 2}}, robot.now_s);
  CHECK(robot.said("scans") == Words{"gap: 1 times of late"});
  CHECK(robot.said("clock") == Words{"clock reset: 1 times of late"});
  CHECK(robot.said("odometry") == Words{"odometry jump: 2 times of late"});
}

TEST_CASE("scans and odometry that are stamped by two clocks are told by how much, whatever the clock of arrival") {
  const double apart_s = GENERATE(2.0, -2.0, 0.8);
  StreamHealth health({LaserModel{}}, LiveOptions{});
  double now_s = 50;
  for (int k = 0; k < 10; ++k, now_s += 0.1) {
    RawScan scan;
    scan.stamp_s = 5e6 + now_s + apart_s;
    health.take(OdometryRecord{5e6 + now_s, Pose2()}, now_s, kNoClock);
    health.take(scan, now_s + 0.02, kNoClock);
  }
  Words words;
  for (const HealthFinding& finding : health.findings(now_s)) words.push_back(finding.words);
  const std::string end = " than odometry that arrives with them; are the clocks of two computers apart?";
  if (apart_s > 1) CHECK(words == Words{"laser: scans are stamped 2.0 s later" + end});
  if (apart_s < 0) CHECK(words == Words{"laser: scans are stamped 2.0 s earlier" + end});
  if (apart_s == 0.8) CHECK(words.empty());
}

TEST_CASE("scans are of the laser whose frame they name; a single laser without a frame takes all of them") {
  const auto missing = [](const std::vector<std::string>& frames, const std::string& of_scans) {
    std::vector<LaserModel> lasers(frames.size());
    for (std::size_t k = 0; k < frames.size(); ++k) lasers[k].frame = frames[k];
    StreamHealth health(lasers, LiveOptions{});
    for (int k = 0; k < 50; ++k) {
      RawScan scan;
      scan.stamp_s = 0.1 * k;
      scan.frame = of_scans;
      health.take(OdometryRecord{scan.stamp_s, Pose2()}, scan.stamp_s, scan.stamp_s);
      health.take(scan, scan.stamp_s, scan.stamp_s);
    }
    Words words;
    for (const HealthFinding& finding : health.findings(5)) words.push_back(finding.subject);
    return words;
  };
  CHECK(missing({""}, "front").empty());
  CHECK(missing({"front"}, "front").empty());
  CHECK(missing({"front"}, "rear") == Words{"laser"});
  CHECK(missing({"front", "rear"}, "front") == Words{"laser rear"});
  CHECK(missing({"front", "rear"}, "rear") == Words{"laser front"});
  CHECK(missing({"", "rear"}, "front").size() == 2);
}

TEST_CASE("two sensors whose records come equally late are of one clock, however late the one of them begins") {
  const double late_s = GENERATE(0.0, 0.4, 0.9);
  LiveOptions options;
  options.pairing.odometry_wait_s = 0.1;
  StreamHealth health({LaserModel{}}, options);
  for (int k = 0; k < 60; ++k) {
    const double stamp_s = 10 + 0.1 * k, received_s = stamp_s + late_s;
    health.take(OdometryRecord{stamp_s, Pose2()}, received_s, kNoClock);
    if (k < 50) continue;
    RawScan scan;
    scan.stamp_s = stamp_s;
    health.take(scan, received_s, kNoClock);
    for (const HealthFinding& finding : health.findings(received_s)) CHECK(finding.subject != "clock");
  }
}
