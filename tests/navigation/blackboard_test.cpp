#include "navigation/actions.hpp"
#include "navigation/path_drive.hpp"
#include "synthetic.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::navigation;

namespace {

/// A corridor of 2 m, y from 0 to 2, in which the legs of a chair leave 0.9 m.
void stand_before_legs(SyntheticMoment& moment, double x, double now_s) {
  moment.queries.stand(Pose2(x, 1, 0), {Pose2(x, 1, 0)}, now_s);
  for (const double y : {0.55, 1.45}) moment.queries.also_see({12, y});
  moment.blackboard.look();
}

void come_and_go(SyntheticMoment& moment, GoToGoal& drive) {
  for (double now_s = 0; now_s < 40; now_s += 0.5) {
    stand_before_legs(moment, 10 + std::fmod(now_s, 8) / 8, now_s);
    drive.tick(moment.blackboard);
  }
}

const std::vector<Point> kOuterWalls{{0, 0}, {30, 0}, {30, 12}, {0, 12}}, kBlock{{2, 2}, {2, 10}, {28, 10}, {28, 2}};

}  // namespace

TEST_CASE("a robot that comes and goes before a gap gives it up where there is another way, and keeps in mind where") {
  std::vector<Segment> ring = room_of(kOuterWalls);
  for (const Segment& face : room_of(kBlock)) ring.push_back(face);
  SyntheticMoment moment(map_of(ring), {29, 1});
  GoToGoal drive(0.3);
  come_and_go(moment, drive);
  REQUIRE(moment.blackboard.impasses().size() == 1);
  const Point given_up = moment.blackboard.impasses().front();
  CHECK((given_up - Point(11.7, 1)).norm() < 0.5);
  moment.queries.stand(Pose2(5, 1, 0), {Pose2(5.3, 1, 0)}, 300);  // odometry has drifted
  moment.blackboard.look();
  REQUIRE(moment.blackboard.impasses().size() == 1);
  CHECK((moment.blackboard.impasses().front() - given_up).norm() < 1e-9);
}

TEST_CASE("a robot that waits for somebody calls that no impasse") {
  const auto impasses_after_waiting = [](bool somebody) {
    SyntheticMoment moment(map_of(room_of({{0, 0}, {30, 0}, {30, 2}, {0, 2}})), {28, 1});
    GoToGoal drive(0.3);
    for (double now_s = 0; now_s < 9; now_s += 0.1) {
      moment.queries.stand(Pose2(10, 1, 0), {Pose2(10, 1, 0)}, now_s);
      for (ScanPoint& p : moment.queries.scan.points)
        if (std::abs(p.bearing_rad) < 0.3 && (now_s > 1 || !somebody))
          p = {0.8 * unit_vector(p.bearing_rad), 0.8, p.bearing_rad, p.beam};
      moment.blackboard.look();
      drive.tick(moment.blackboard);
    }
    return moment.blackboard.impasses().size();
  };
  CHECK(impasses_after_waiting(true) == 0);
  CHECK(impasses_after_waiting(false) > 0);
}

TEST_CASE("where a robot has just been it can be again, however narrow it is") {
  SyntheticMoment moment(map_of(room_of({{0, 0}, {30, 0}, {30, 2}, {0, 2}})), {28, 1});
  const auto price_in_gap = [&] {
    return unmapped_surcharge(moment.blackboard)[static_cast<std::size_t>(moment.blackboard.floor.cell_at({12, 1.05}))];
  };
  const auto drive = [&](double from_m, double to_m, double began_s) {
    for (double x = from_m; x < to_m; x += 0.05) {
      moment.queries.stand(Pose2(x, 1.03, 0), {Pose2(x, 1.03, 0)}, began_s + x - from_m);
      for (const double y : {0.66, 1.4}) moment.queries.also_see({12, y});  // 0.74 m apart
      moment.blackboard.look();
    }
  };
  drive(9, 11, 0);
  CHECK(price_in_gap() > 500);
  drive(11, 13, 2);
  CHECK(price_in_gap() < 50);
}

TEST_CASE("a robot that comes and goes before a gap tries it again where there is no other way") {
  SyntheticMoment moment(map_of(room_of({{0, 0}, {30, 0}, {30, 2}, {0, 2}})), {28, 1});
  GoToGoal drive(0.3);
  come_and_go(moment, drive);
  CHECK(moment.blackboard.impasses().empty());
}

TEST_CASE("a way that turns back from an impasse does not lead through it, however near it begins") {
  SyntheticMoment moment(map_of(room_of({{0, 0}, {30, 0}, {30, 2}, {0, 2}})), {28, 1});
  stand_before_legs(moment, 11.5, 0);
  moment.blackboard.give_up({11.8, 1});
  CHECK_FALSE(moment.blackboard.try_again(std::vector<Point>{{11.5, 1}, {2, 1}}));
  CHECK(moment.blackboard.impasses().size() == 1);
  CHECK(moment.blackboard.try_again(std::vector<Point>{{11.5, 1}, {28, 1}}));
  CHECK(moment.blackboard.impasses().empty());
}

TEST_CASE("a robot that gets on gives nothing up, however slow it is") {
  SyntheticMoment moment(map_of(room_of({{0, 0}, {30, 0}, {30, 2}, {0, 2}})), {28, 1});
  GoToGoal drive(0.3);
  for (double now_s = 0; now_s < 60; now_s += 0.5) {
    stand_before_legs(moment, 2 + 0.15 * now_s, now_s);
    drive.tick(moment.blackboard);
  }
  CHECK(moment.blackboard.impasses().empty());
}

TEST_CASE("beside what comes and goes a robot waits, unless it is mapped: panes do not walk") {
  const auto speed_in = [](double low_y) {  // of a room that begins there; 0.45 m beside the robot, at y = 0, it comes
    SyntheticMoment moment(map_of(room_of({{0, low_y}, {30, low_y}, {30, 3}, {0, 3}})), {28, 1});
    GoToGoal drive(0.3);
    for (int k = 0; k < 8; ++k) {
      moment.queries.stand(Pose2(10, 0.45, 0), {Pose2(10, 0.45, 0)}, 0.1 * k);
      Scan& scan = moment.queries.scan;
      const Pose2 T_map_laser = Pose2(10, 0.45, 0) * wide_laser().T_base_laser;
      std::erase_if(scan.points, [&](const ScanPoint& p) { return std::abs((T_map_laser * p.position).y()) < 0.1; });
      for (double x = 10; k > 5 && x < 11.5; x += 0.05) moment.queries.also_see({x, 0});
      moment.blackboard.look();
      drive.tick(moment.blackboard);
    }
    return moment.blackboard.velocity().linear_mps.x();
  };
  CHECK(speed_in(0) > 0.3);
  CHECK(speed_in(-3) < 0.3);
}
