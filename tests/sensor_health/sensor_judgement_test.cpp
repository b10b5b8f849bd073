#include "sensor_health/sensor_judgement.hpp"

#include <catch2/catch.hpp>

using namespace opal;

namespace {

using Subject = SensorFinding::Subject;
using Verdict = SensorFinding::Verdict;

/// A drive that agrees with a laser at the origin, known to a centimetre and a hundredth.
MotionCalibration well_known() {
  MotionCalibration drive;
  drive.pairs = 10;
  drive.driven_m = 5;
  drive.turned_rad = 2;
  drive.turn_scale = drive.distance_scale = {1, 0.01};
  drive.mount_heading_rad = {0, 0.01};
  drive.mount_position_sigma_m = 0.01;
  drive.turns_better = drive.distances_better = 0.9;
  return drive;
}

std::optional<SensorFinding> found_of(Subject subject, const MotionCalibration& drive, const Pose2& described = {}) {
  for (const SensorFinding& finding : judge_motion(drive, described))
    if (finding.subject == subject) return finding;
  return std::nullopt;
}

std::vector<Subject> subjects_of(const MotionCalibration& drive) {
  std::vector<Subject> subjects;
  for (const SensorFinding& finding : judge_motion(drive, Pose2())) subjects.push_back(finding.subject);
  return subjects;
}

/// @param heading_rad  of the laser, by the drive.
SensorFinding heading_found(double heading_rad, double sigma_rad = 0.01, double described_rad = 0) {
  MotionCalibration drive = well_known();
  drive.mount_heading_rad = {heading_rad, sigma_rad};
  return found_of(Subject::mount_heading, drive, Pose2(0, 0, described_rad)).value();
}

SensorFinding turn_found(double scale) {
  MotionCalibration drive = well_known();
  drive.turn_scale.value = scale;
  return found_of(scale < 0 ? Subject::mirroring : Subject::odometry_turn, drive).value();
}

MotionPair standing_pair(double by_m, double by_rad) { return {Pose2(), Pose2(by_m, 0, by_rad)}; }

}  // namespace

TEST_CASE("a drive that is known well tells of turns, heading, distance and position") {
  const MotionCalibration drive = well_known();
  CHECK(subjects_of(drive) == std::vector{Subject::odometry_turn, Subject::mount_heading, Subject::odometry_distance,
                                          Subject::mount_position});
  for (const SensorFinding& finding : judge_motion(drive, Pose2())) {
    CHECK(finding.verdict == Verdict::fine);
    CHECK_THAT(finding.words, Catch::EndsWith(": fine"));
  }
}

TEST_CASE("nothing is said of a drive before the fifth motion") {
  MotionCalibration drive = well_known();
  drive.pairs = 4;
  CHECK(judge_motion(drive, Pose2()).empty());
  drive.pairs = 5;
  CHECK(judge_motion(drive, Pose2()).size() == 4);
}

TEST_CASE("what a drive does not know well enough is left out") {
  const auto with = [](auto change) {
    MotionCalibration drive = well_known();
    change(drive);
    return subjects_of(drive);
  };
  using enum SensorFinding::Subject;
  const std::vector<Subject> only_turn{odometry_turn}, no_turn{mount_heading, odometry_distance};
  CHECK(with([](auto& drive) { drive.turned_rad = 0.7; }) == no_turn);
  CHECK(with([](auto& drive) { drive.turn_scale.sigma = 0.09; }) == no_turn);
  CHECK(with([](auto& drive) { drive.driven_m = 0.7; }) == only_turn);
  CHECK(with([](auto& drive) { drive.distance_scale.value = 0.03; }) == only_turn);
  CHECK(with([](auto& drive) { drive.mount_heading_rad.sigma = 0.07; }) ==
        std::vector{odometry_turn, odometry_distance, mount_position});
  CHECK(with([](auto& drive) { drive.distance_scale.sigma = 0.09; }) == std::vector{odometry_turn, mount_heading});
  CHECK(with([](auto& drive) { drive.mount_position_sigma_m = 0.11; }) ==
        std::vector{odometry_turn, mount_heading, odometry_distance});
}

TEST_CASE("a difference is fine if it is small or could be chance, and wrong if it turns answers") {
  CHECK(heading_found(0.045).verdict == Verdict::fine);
  CHECK(heading_found(0.1, 0.03).verdict == Verdict::fine);
  CHECK(heading_found(0.1).verdict == Verdict::doubtful);
  CHECK(heading_found(-0.1).verdict == Verdict::doubtful);
  CHECK(heading_found(0.18).verdict == Verdict::contradicted);
  CHECK(heading_found(-0.18).verdict == Verdict::contradicted);
}

TEST_CASE("a drive whose single motions do not speak against the description says nothing of it") {
  MotionCalibration drive = well_known();
  drive.mount_heading_rad.value = 0.3;
  drive.turn_scale.value = 3;
  drive.turns_better = drive.distances_better = 0.75;
  CHECK(subjects_of(drive) == std::vector{Subject::odometry_distance, Subject::mount_position});
}

TEST_CASE("a heading is held against the described one the short way round") {
  const SensorFinding finding = heading_found(-3.1, 0.01, 3.1);
  CHECK(finding.verdict == Verdict::doubtful);
  CHECK(finding.found == Approx(-3.1));
  CHECK(finding.described == Approx(3.1));
  CHECK(finding.sigma == 0.01);
  CHECK_THAT(finding.words, Catch::Contains("-177.6 +- 0.6 degrees") && Catch::Contains("described at 177.6"));
}

TEST_CASE("the question about a heading depends on how far it is off") {
  const auto degrees = [](double off) { return heading_found(off * std::numbers::pi / 180).words; };
  for (const double off : {155.0, -155.0, 179.0}) CHECK_THAT(degrees(off), Catch::Contains("at 180 degrees?"));
  for (const double off : {72.0, 90.0, 108.0, -90.0}) CHECK_THAT(degrees(off), Catch::Contains("sideways"));
  for (const double off : {30.0, 68.0, 112.0, -68.0, 145.0}) CHECK_THAT(degrees(off), Catch::Contains("first angle"));
}

TEST_CASE("turns are contradicted from twice or half on") {
  CHECK(turn_found(1.08).verdict == Verdict::fine);
  for (const double scale : {1.3, 0.7, 1.9, 0.55}) CHECK(turn_found(scale).verdict == Verdict::doubtful);
  for (const double scale : {2.1, 0.45}) CHECK(turn_found(scale).verdict == Verdict::contradicted);
  CHECK_THAT(turn_found(1.3).words, Catch::Contains("scans turn by 2.60 rad where odometry turns by 2.00") &&
                                        Catch::Contains("heading scaled"));
  CHECK(turn_found(1.3).found == 1.3);
}

TEST_CASE("turns the other way are a mirrored laser, whatever their scale") {
  for (const double scale : {-1.0, -0.7}) {
    const SensorFinding finding = turn_found(scale);
    CHECK(finding.verdict == Verdict::contradicted);
    CHECK(finding.found == -1);
    CHECK(finding.described == 1);
    CHECK_THAT(finding.words, Catch::Contains("upside down"));
  }
}

TEST_CASE("distances are told in metres, and contradicted from twice or half on") {
  MotionCalibration drive = well_known();
  const auto told = [&](double scale) {
    drive.distance_scale.value = scale;
    return found_of(Subject::odometry_distance, drive).value();
  };
  CHECK(told(1.08).verdict == Verdict::fine);
  CHECK(told(1.3).verdict == Verdict::doubtful);
  CHECK(told(0.45).verdict == Verdict::contradicted);
  CHECK_THAT(told(1.3).words,
             Catch::Contains("scans move by 6.50 m where odometry moves by 5.00: is the wheel radius"));
}

TEST_CASE("a position is held against the described one by their distance") {
  MotionCalibration drive = well_known();
  drive.mount_position_m = {0.6, 0.9};
  const auto told = [&](double x, double y) {
    return found_of(Subject::mount_position, drive, Pose2(x, y, 0)).value();
  };
  CHECK(told(0, 0.1).verdict == Verdict::contradicted);
  CHECK(told(0, 0.1).found == Approx(1));
  CHECK(told(0.6, 0.7).verdict == Verdict::doubtful);
  CHECK(told(0.6, 0.85).verdict == Verdict::fine);
  CHECK_THAT(told(0, 0.1).words, Catch::Contains("(0.60, 0.90) m") && Catch::EndsWith("described at (0.00, 0.10)"));
}

TEST_CASE("three motions without odometry contradict it, two do not, and small ones do not count") {
  std::vector<MotionPair> standing{standing_pair(0.3, 0), standing_pair(0.09, 0.07), standing_pair(0, -0.2)};
  CHECK(judge_standing(standing).empty());
  standing.push_back(standing_pair(-0.2, 0.1));
  const auto found = judge_standing(standing);
  REQUIRE(found.size() == 1);
  CHECK(found[0].subject == Subject::standing_odometry);
  CHECK(found[0].verdict == Verdict::contradicted);
  CHECK(found[0].found == Approx(0.5));
  CHECK_THAT(found[0].words, Catch::Contains("scans move by 0.50 m and turn by 0.30 rad"));
}
