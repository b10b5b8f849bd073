#include "localization/decision/map_agreement.hpp"
#include "tests/localization/synthetic_scene.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::synthetic;

TEST_CASE("a map agrees with what is seen in it, and less with what is seen elsewhere") {
  const auto map = view_of(room());
  const Robot robot(map, {4, 3, 0.4});
  const Observation seen = robot.observation();
  const MapAgreement here = agreement(seen, *map, robot.T_map_base());
  CHECK(here.share() > 0.95);
  CHECK(here.met > 0.9);
  const MapAgreement turned = agreement(seen, *map, robot.T_map_base() * Pose2(0, 0, 1.2));
  CHECK(turned.share() < 0.7);
  CHECK(turned.met + turned.passed <= 1 + 1e-9);
}

TEST_CASE("agreement does not depend on where the map's origin is") {
  const Pose2 motion(30, -12, 0.7);
  const auto map = view_of(room()), elsewhere = view_of(moved(motion, room()));
  const Robot robot(map, {4, 3, 0.4});
  const Observation seen = robot.observation();
  const Pose2 off = robot.T_map_base() * Pose2(0.5, 0.3, 0.1);
  const MapAgreement a = agreement(seen, *map, off), b = agreement(seen, *elsewhere, motion * off);
  CHECK(a.met == Approx(b.met).margin(0.05));  // lookups are by cells of 0.1 m
  CHECK(a.passed == Approx(b.passed).margin(0.05));
}

TEST_CASE("nothing that is seen, or nothing mapped in view, disagrees with nothing") {
  const auto map = view_of(room());
  Robot robot(map, {4, 3, 0});
  CHECK(agreement(robot.observation(), *map, Pose2(500, 500, 0)).share() == 1);
  robot.drive_blind_to({5, 3, 0});
  CHECK(agreement(robot.observation(), *map, robot.T_map_base()).met == 0);
  CHECK(agreement(robot.observation(), *map, robot.T_map_base()).passed == 0);
  CHECK(agreement(robot.observation(), *map, robot.T_map_base()).share() == 1);
}

TEST_CASE("a mean of agreements follows the newest, and parts of evidence count as parts") {
  MeanAgreement mean;
  CHECK(mean.share() == 1);
  mean.add({0.2, 0.6}, 1);
  CHECK(mean.share() == Approx(0.25));
  for (int k = 0; k < 40; ++k) mean.add({0.6, 0.2}, 1);
  CHECK(mean.share() == Approx(0.75).margin(0.001));
  MeanAgreement whole, halves;
  whole.add({0.5, 0.5}, 1);
  halves.add({0.5, 0.5}, 1);
  whole.add({0.9, 0.1}, 1);
  halves.add({0.9, 0.1}, 0.5);
  halves.add({0.9, 0.1}, 0.5);
  CHECK(whole.share() == Approx(halves.share()));
}

TEST_CASE("agreement falls if it drops by far more than it usually changes, and enough beams tell") {
  AgreementFall steady;
  for (int k = 0; k < 40; ++k) CHECK_FALSE(steady.add({k % 2 == 0 ? 0.9 : 0.88, 0.1}));
  AgreementFall few = steady, up_and_down;
  CHECK_FALSE(few.add({0.1, 0.15}));  // most beams end before anything mapped
  CHECK(steady.add({0.5, 0.45}));
  CHECK_FALSE(steady.add({0.5, 0.45}));  // it stays where it is
  for (int k = 0; k < 40; ++k) up_and_down.add({k % 2 == 0 ? 0.8 : 0.6, k % 2 == 0 ? 0.2 : 0.4});
  CHECK_FALSE(up_and_down.add({0.5, 0.45}));  // as on a map that is wrong in many places
}

TEST_CASE("what a map says of a scan is told anew for another pose and another scan") {
  const auto map = view_of(room());
  const Robot robot(map, {4, 3, 0.4});
  const Observation seen = robot.observation();
  const Pose2 turned = robot.T_map_base() * Pose2(0, 0, 1.2);
  ScanAgreement newest;
  CHECK(newest.at(robot.T_map_base(), seen, *map).share() == agreement(seen, *map, robot.T_map_base()).share());
  CHECK(newest.at(turned, seen, *map).share() == agreement(seen, *map, turned).share());
  newest.clear();
  const Observation elsewhere = Robot(map, {6, 4, 1}).observation();
  CHECK(newest.at(turned, elsewhere, *map).share() == agreement(elsewhere, *map, turned).share());
}

TEST_CASE("of sixty returns each has a say, of more an even share of them") {
  const auto map = view_of({{"opal:Wall", Segment{{10, -5}, {10, 5}}}});
  const LocalMap nothing({}, nullptr);
  const auto share_of = [&](int returns, int every) {
    ObservedScan scan;
    for (int k = 0; k < returns; ++k)  // on the wall, or far behind it
      scan.points.emplace_back(k % every == 0 ? Point(10, -3 + 0.01 * k) : Point(14, -3 + 0.01 * k));
    return agreement(Observation{nothing, {scan}}, *map, Pose2()).share();
  };
  CHECK(share_of(60, 2) == Approx(0.5));
  CHECK(share_of(59, 59) == Approx(1. / 59));
  CHECK(share_of(120, 2) == 1);  // every second one
  CHECK(share_of(61, 2) == 1);
}

TEST_CASE("a return behind a wall has passed it from nearby, and from afar may be its own") {
  const LocalMap nothing({}, nullptr);
  const auto behind = [&](double wall_m) {
    const auto map = view_of({{"opal:Wall", Segment{{wall_m, -5}, {wall_m, 5}}}});
    ObservedScan scan;
    scan.points = {Point(wall_m + 0.3, 0)};
    return agreement(Observation{nothing, {scan}}, *map, Pose2()).passed;
  };
  CHECK(behind(2) == 1);
  CHECK(behind(20) == 0);
}

TEST_CASE("a return well before a wall is neither met nor passed") {
  const auto map = view_of({{"opal:Wall", Segment{{10, -5}, {10, 5}}}});
  const auto met_at = [&](double range_m) {
    const LocalMap nothing({}, nullptr);
    Scan scan;
    scan.range_max_m = 30;
    scan.points.push_back({{range_m, 0}, range_m, 0, 0});
    const Sample sample = sample_of(std::move(scan), Pose2());
    return agreement(observe(nothing, sample, {}), *map, Pose2());
  };
  CHECK(met_at(9.9).met == 1);
  for (const double range_m : {9.6, 9.0, 5.0}) {
    CHECK(met_at(range_m).met == 0);
    CHECK(met_at(range_m).passed == 0);
  }
}
