#include "simulation/drives/rides.hpp"
#include "simulation/drives/storey_drives.hpp"

#include "map_tools/map_stack.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::simulation;

namespace {

std::shared_ptr<const SemanticMap> two_storeys_of_a_room() {
  const auto room = SemanticMap::read(OPAL_SOURCE_DIR "/maps/example_room.jsonld");
  const std::vector<StoreyPart> parts{{"low", "", {}, room}, {"top", "", {}, room}};
  return stacked_map("house", parts).map;
}

SimulationOptions quiet_world() {
  SimulationOptions options;
  options.clutter.level = 0;
  options.people = 0;
  return options;
}

/// In the middle of the room.
MapConnection lift_in(const SemanticMap& map) {
  const MapStorey& storey = map.origin().storeys.front();
  const Pose2 middle = storey.to_storey({(storey.bounds[0] + storey.bounds[1]) / 2, 0});
  return {"lift", "opal:Lift", "", 1, {{"low", middle}, {"top", middle}}};
}

}  // namespace

TEST_CASE("a ride takes the robot to another storey, and odometry shows nothing of it") {
  const auto map = two_storeys_of_a_room();
  const MapConnection lift = lift_in(*map);
  RideDriveOptions options;
  options.before_m = 5;
  options.after_m = 3;
  const auto made = record_ride(*map, quiet_world(), lift, "low", "top", options, 3);
  REQUIRE(made);
  const Ride& ride = made->ride;
  CHECK(ride.stands_s < ride.closes_s);
  CHECK(ride.closes_s < ride.opens_s);
  CHECK(ride.opens_s < ride.leaves_s);
  const auto& scans = made->recording.scans;
  for (std::size_t k = 1; k < scans.size(); ++k) {
    const double stamp_s = scans[k].scan.stamp_s;
    CHECK(stamp_s > scans[k - 1].scan.stamp_s);
    CHECK(storey_at(*map, scans[k].T_map_base.position())->id == (stamp_s <= ride.closes_s ? "low" : "top"));
    CHECK(distance_m(*scans[k].scan.T_odom_base, *scans[k - 1].scan.T_odom_base) < 0.3);
    if (scans[k - 1].scan.stamp_s > ride.stands_s && stamp_s < ride.leaves_s)
      CHECK(distance_m(*scans[k].scan.T_odom_base, *scans[k - 1].scan.T_odom_base) < 1e-9);
  }
}

TEST_CASE("behind a closed door, no beam leaves the cabin") {
  const auto map = two_storeys_of_a_room();
  RideDriveOptions options;
  options.before_m = 5;
  const auto made = record_ride(*map, quiet_world(), lift_in(*map), "low", "top", options, 4);
  REQUIRE(made);
  int closed = 0;
  for (const RecordedScan& scan : made->recording.scans) {
    if (scan.scan.stamp_s <= made->ride.closes_s || scan.scan.stamp_s > made->ride.opens_s) continue;
    ++closed;
    for (const float range_m : scan.scan.ranges_m) CHECK(!(range_m > 1.5 * options.cabin_m));
  }
  CHECK(closed > 30);
}

TEST_CASE("a ride to a storey that the lift does not serve is refused") {
  const auto map = two_storeys_of_a_room();
  MapConnection lift = lift_in(*map);
  lift.landings.pop_back();
  CHECK_THROWS_AS(record_ride(*map, quiet_world(), lift, "low", "top", {}, 1), ConfigError);
}

TEST_CASE("drives on storeys take place on one after the other, and time and odometry go on") {
  const auto map = two_storeys_of_a_room();
  DriveOptions drives;
  drives.drives = 4;
  drives.distance_m = 4;
  const Recording recording = record_on_storeys(*map, quiet_world(), drives, 5);
  REQUIRE(recording.queries.size() == 4);
  for (std::size_t k = 0; k < recording.queries.size(); ++k)
    for (const RecordedScan& scan : recording.scans)
      if (scan.scan.stamp_s >= recording.queries[k].start_s && scan.scan.stamp_s <= recording.queries[k].end_s)
        CHECK(storey_at(*map, scan.T_map_base.position())->id == (k % 2 == 0 ? "low" : "top"));
  for (std::size_t k = 1; k < recording.scans.size(); ++k) {
    CHECK(recording.scans[k].scan.stamp_s > recording.scans[k - 1].scan.stamp_s);
    CHECK(distance_m(*recording.scans[k].scan.T_odom_base, *recording.scans[k - 1].scan.T_odom_base) < 0.3);
  }
  CHECK_THROWS_AS(
      record_on_storeys(*SemanticMap::read(OPAL_SOURCE_DIR "/maps/example_room.jsonld"), quiet_world(), drives, 5),
      ConfigError);
}
