#include "live/live_core.hpp"
#include "live_robot.hpp"

#include "simulation/buildings/building.hpp"

#include <opal/sensing/replay.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <limits>

using namespace opal;

namespace {

struct Played {
  std::vector<LiveAnswer> answers;
  std::vector<std::string> said;  ///< words of health, each once

  bool says(const std::string& words) const {
    return std::ranges::any_of(said, [&](const std::string& each) { return each.find(words) != std::string::npos; });
  }
};

/// What somebody says before anything is heard of the robot.
void tell(LiveCore& core, const PoseHint& hint) {
  core.take(HintRecord{0, hint}, 0, 0, [](const LiveAnswer&) { FAIL("an answer to no scan"); });
}

Played played(LiveCore& core, const std::vector<simulation::Arrival>& arrivals) {
  Played played;
  const auto keep = [&](LiveAnswer answer) { played.answers.push_back(std::move(answer)); };
  for (const simulation::Arrival& arrival : arrivals) {
    core.take(arrival.record, arrival.at_s, arrival.at_s, keep);
    for (const HealthFinding& finding : core.health(arrival.at_s))
      if (!played.says(finding.words)) played.said.push_back(finding.words);
  }
  core.finish(keep);
  return played;
}

Played played(const std::vector<simulation::Arrival>& arrivals) {
  LiveCore core(robot().parts(), {}, nullptr);
  return played(core, arrivals);
}

Played with(simulation::Fault fault, double from_s = 30, double to_s = 40) {
  return played(simulation::with_fault(robot().arrivals, fault, {from_s, to_s}, "RLASER", Random(1)));
}

bool is_right(const LiveAnswer& answer, double later_s = 0) {
  const Pose2 truth = robot().truth_at(answer.stamp_s + later_s);
  return distance_m(answer.estimate.T_map_base, truth) < 0.5 &&
         angle_between_rad(answer.estimate.T_map_base, truth) < 0.1;
}

bool is_localized(const LiveAnswer& answer) { return answer.estimate.status == Status::localized; }

}  // namespace

TEST_CASE("a robot with two lasers is localized live, where it is") {
  const Played all = played(robot().arrivals);
  REQUIRE(all.answers.size() > 500);
  CHECK(is_localized(all.answers.back()));
  for (const LiveAnswer& answer : all.answers)
    if (is_localized(answer)) REQUIRE(is_right(answer));
  CHECK(all.said.empty());
}

TEST_CASE("a live run gives the same answers as a replay of its records, to the byte") {
  const Played live = played(robot().arrivals);
  std::vector<LogRecord> records;
  for (const simulation::Arrival& arrival : robot().arrivals) records.push_back(arrival.record);
  Localizer localizer(robot().parts());
  Replay replay(records, robot().lasers);
  std::size_t k = 0;
  while (const auto sample = replay.next()) {
    localizer.update(*sample);
    const PoseEstimate said = localizer.estimate_at(sample->stamp_s, sample->T_odom_base);
    REQUIRE(k < live.answers.size());
    REQUIRE(live.answers[k].why == localizer.why());
    REQUIRE(live.answers[k].number == k + 1);
    const PoseEstimate& answer = live.answers[k++].estimate;
    REQUIRE(said.stamp_s == answer.stamp_s);
    REQUIRE(said.status == answer.status);
    REQUIRE(said.probability == answer.probability);
    REQUIRE(distance_m(said.T_map_base, answer.T_map_base) == 0);
  }
  CHECK(k == live.answers.size());
}

TEST_CASE("the transform from odometry to the map places odometry as it was received, also after it has jumped") {
  std::vector<simulation::Arrival> arrivals = robot().arrivals;
  const Pose2 T_new_odom(40, -7, 2);
  for (simulation::Arrival& arrival : arrivals) {
    if (arrival.at_s < 30) continue;
    if (auto* odometry = std::get_if<OdometryRecord>(&arrival.record))
      odometry->T_odom_base = T_new_odom * odometry->T_odom_base;
    if (auto* scan = std::get_if<RawScan>(&arrival.record)) scan->T_odom_base.reset();
  }
  for (simulation::Arrival& arrival : arrivals)
    if (auto* scan = std::get_if<RawScan>(&arrival.record)) scan->T_odom_base.reset();
  const auto odometry_at = [&](double stamp_s) {
    Pose2 nearest;
    double best_s = std::numeric_limits<double>::infinity();
    for (const simulation::Arrival& arrival : arrivals)
      if (const auto* odometry = std::get_if<OdometryRecord>(&arrival.record);
          odometry && std::abs(odometry->stamp_s - stamp_s) < best_s) {
        best_s = std::abs(odometry->stamp_s - stamp_s);
        nearest = odometry->T_odom_base;
      }
    return nearest;
  };
  const LiveAnswer last = played(arrivals).answers.back();
  CHECK(distance_m(last.T_map_odom * odometry_at(last.stamp_s), last.estimate.T_map_base) < 0.1);
}

TEST_CASE("what goes wrong with the streams is named, and never makes a wrong place localized") {
  using simulation::Fault;
  const auto [fault, named] = GENERATE(table<Fault, std::string>({{Fault::dropped, "records a second"},
                                                                  {Fault::doubled, "doubled scan"},
                                                                  {Fault::reordered, "steps back"},
                                                                  {Fault::late, "after its stamps"},
                                                                  {Fault::laser_gone, "RLASER: no scan for"},
                                                                  {Fault::odometry_frozen, "stands still"},
                                                                  {Fault::wheels_slip, "do the wheels slip"}}));
  CAPTURE(name_of(fault));
  const Played all = with(fault);
  CHECK(all.says(named));
  for (const LiveAnswer& answer : all.answers)
    if (is_localized(answer)) REQUIRE(is_right(answer));
  CHECK(is_localized(all.answers.back()));
}

TEST_CASE("a robot whose odometry had frozen is found within 5 s once it moves") {
  constexpr double kFrom_s = 30, kTo_s = 40;
  const Played all = with(simulation::Fault::odometry_frozen, kFrom_s, kTo_s);
  const double begun_s = all.answers.front().stamp_s;
  const auto found = std::ranges::find_if(
      all.answers, [&](const LiveAnswer& each) { return each.stamp_s - begun_s > kTo_s && is_localized(each); });
  REQUIRE(found != all.answers.end());
  CHECK(is_right(*found));
  CHECK(found->stamp_s - begun_s < kTo_s + 5);
}

TEST_CASE("a clock that jumps back is named, and the robot stays found") {
  const Played all = with(simulation::Fault::clock_back);
  CHECK(all.says("clock reset"));
  CHECK(is_localized(all.answers.back()));
  CHECK(is_right(all.answers.back(), 10));
}

TEST_CASE("stamps from another computer's clock are named") {
  std::vector<simulation::Arrival> arrivals = robot().arrivals;
  for (simulation::Arrival& arrival : arrivals)
    if (auto* scan = std::get_if<RawScan>(&arrival.record)) scan->stamp_s += 0.4;
  CHECK(played(arrivals).says("in the future"));
}

TEST_CASE("a sensor that never says anything is named") {
  std::vector<simulation::Arrival> arrivals = robot().arrivals;
  std::erase_if(arrivals, [](const simulation::Arrival& arrival) {
    const auto* scan = std::get_if<RawScan>(&arrival.record);
    return scan && scan->frame == "RLASER";
  });
  const Played all = played(arrivals);
  CHECK(all.says("laser RLASER: no scan has come yet"));
  CHECK(is_localized(all.answers.back()));
}

TEST_CASE("a laser that is described backwards is named, and nothing is called localized") {
  std::vector<LaserModel> described = robot().lasers;
  for (LaserModel& laser : described) laser.T_base_laser = laser.T_base_laser * Pose2(0, 0, std::numbers::pi);
  LiveCore core(robot().parts(described), {}, nullptr);
  const Played all = played(core, robot().arrivals);
  CHECK(all.says("laser FLASER"));
  const auto& health = all.answers.back().health;
  CHECK(std::ranges::any_of(health, [](const HealthFinding& finding) {
    return finding.level == HealthFinding::Level::bad && finding.words.find("laser FLASER") != std::string::npos;
  }));
  CHECK_FALSE(is_localized(all.answers.back()));
}

TEST_CASE("the map of another building is named, and that of this one is not") {
  LiveRobot elsewhere(90);
  LiveCore right(elsewhere.parts(), {}, nullptr);
  CHECK_FALSE(played(right, elsewhere.arrivals).says("the map does not explain"));
  elsewhere.map = simulation::generate_building({"office", 1, 800, 0.2}).map;
  LiveCore wrong(elsewhere.parts(), {}, nullptr);
  CHECK(played(wrong, elsewhere.arrivals).says("the map does not explain what the robot sees: no place held for"));
}

TEST_CASE("a good hint finds the place at once, and a bad one changes nothing in the end") {
  LiveCore helped(robot().parts(), {}, nullptr);
  tell(helped, {robot().truth_at(0.2) * Pose2(0.3, -0.2, 0.1), 0.3, 0.15});
  const std::vector<simulation::Arrival> start(robot().arrivals.begin(), robot().arrivals.begin() + 60);
  CHECK(is_right(played(helped, start).answers.back()));
  LiveCore misled(robot().parts(), {}, nullptr);
  tell(misled, {Pose2(-3, 50, 2), 0.5, 0.2});
  const Played all = played(misled, robot().arrivals);
  CHECK(is_localized(all.answers.back()));
  CHECK(is_right(all.answers.back()));
}
