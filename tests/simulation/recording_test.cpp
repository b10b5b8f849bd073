#include "tests/kit/file_content.hpp"
#include "tests/kit/temporary_folder.hpp"

#include "evaluation/site.hpp"
#include "simulation/drives/recording.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::simulation;

namespace {

std::shared_ptr<const SemanticMap> room() { return SemanticMap::read(OPAL_SOURCE_DIR "/maps/example_room.jsonld"); }

SimulationOptions clean() {
  SimulationOptions options;
  options.clutter.level = 0;
  options.people = 0;
  options.laser_errors = {0, 0, 0, 0, 0.2, 0};
  options.odometry_errors = {0, 0, 0, 0, 0, 0, 0, 0, 0};
  return options;
}

Recording recorded(const SimulationOptions& options, std::uint64_t seed) {
  Simulation simulation(room(), options, seed);
  DriveOptions drives;
  drives.drives = 2;
  drives.distance_m = 5;
  return record(simulation, drives, Random(seed));
}

}  // namespace

TEST_CASE("the same seed gives the same files to the byte, another seed others") {
  const TemporaryFolder folder;
  const auto write = [&](std::uint64_t seed, const char* name) {
    write_recording(recorded({}, seed), folder.path_of(name), "room");
    return folder.path_of(name);
  };
  const std::string a = write(7, "a"), b = write(7, "b"), c = write(8, "c");
  for (const char* end : {".log.gz", ".gt.csv", ".info.json", ".queries.json"})
    CHECK(content_of(a + end) == content_of(b + end));
  CHECK(content_of(a + ".log.gz") != content_of(c + ".log.gz"));
}

TEST_CASE("who reads a simulated recording knows how far its laser sees") {
  SimulationOptions options = clean();
  options.laser.range_max_m = 3.5;
  const TemporaryFolder folder;
  write_recording(recorded(options, 3), folder.path_of("near"), "room");
  const LaserModel laser = read_site_laser(folder.path_of("near.info.json"));
  CHECK(laser.range_max_m == 3.5);
  CHECK(laser.no_return_m == options.laser.no_return_m);
}

TEST_CASE("a sweep that takes time reads the walls beam after beam, and its stamp is that of the first beam") {
  SimulationOptions options = clean();
  options.laser.sweep_s = 0.1;
  Random closed(1);
  const RayCaster walls(building_solids(*room(), 0, closed));
  Simulation simulation(room(), options, 3);
  Random random(3);
  simulation.place({simulation.floor().anywhere(random), 0});
  for (int k = 0; k < 4; ++k) simulation.drive({Point(0, 0), 1.5}, 0.05);
  const RawScan scan = simulation.scan();
  CHECK(scan.stamp_s == Approx(0.1));
  CHECK(simulation.T_map_base_at(scan.stamp_s).heading_rad() == Approx(0.15));
  REQUIRE(scan.T_odom_base);
  CHECK((scan.T_odom_base->inverse() * simulation.T_odom_base()).heading_rad() == Approx(0.15));
  const LaserModel& laser = options.laser;
  for (int beam : {0, 135, 270, 405, 540}) {
    CAPTURE(beam);
    const double measured_s = scan.stamp_s + 0.1 * beam / (laser.beams - 1);
    const Pose2 T_map_laser = simulation.T_map_base_at(measured_s) * laser.T_base_laser;
    const Point along = T_map_laser.rotate(unit_vector(laser.angle_min_rad + beam * laser.angle_increment_rad));
    const RayHit hit = walls.cast(T_map_laser.position(), along, laser.range_max_m);
    CHECK(static_cast<double>(scan.ranges_m[static_cast<std::size_t>(beam)]) ==
          Approx(hit.solid < 0 ? laser.no_return_m : hit.range_m).margin(1e-4));
  }
}

TEST_CASE("without errors the laser reads the walls, and odometry is the way") {
  const Recording recording = recorded(clean(), 3);
  Random closed(1);
  const RayCaster walls(building_solids(*room(), 0, closed));
  REQUIRE(recording.scans.size() > 20);
  const RecordedScan& first = recording.scans.front();
  for (const RecordedScan& recorded : recording.scans) {
    if (recorded.scan.stamp_s > recording.queries.front().end_s) break;
    const Pose2 T_map_laser = recorded.T_map_base * recording.laser.T_base_laser;
    for (int beam = 0; beam < recording.laser.beams; beam += 50) {
      const double bearing = recording.laser.angle_min_rad + beam * recording.laser.angle_increment_rad;
      const RayHit hit = walls.cast(T_map_laser.position(), T_map_laser.rotate(unit_vector(bearing)), 30);
      const double expected = hit.solid < 0 ? recording.laser.no_return_m : hit.range_m;
      CHECK(recorded.scan.ranges_m[beam] == Approx(expected).margin(1e-3));
    }
    const Pose2 by_odometry = first.scan.T_odom_base->inverse() * *recorded.scan.T_odom_base;
    const Pose2 truly = first.T_map_base.inverse() * recorded.T_map_base;
    CHECK(distance_m(by_odometry, truly) < 1e-6);
    CHECK(angle_between_rad(by_odometry, truly) < 1e-6);
  }
}

TEST_CASE("a robot never drives into anything, whoever walks about") {
  SimulationOptions options;
  options.clutter.level = 2;
  options.people = 6;
  Simulation simulation(room(), options, GENERATE(1, 2, 3));
  Random random(5);
  for (int k = 0; k < 2000; ++k) {
    const Velocity velocity{{random.uniform(-1, 1), random.uniform(-1, 1)}, random.uniform(-1, 1)};
    const Pose2 before = simulation.T_map_base();
    const auto touched = simulation.drive(velocity, 0.1);
    if (touched) CHECK(distance_m(before, simulation.T_map_base()) == 0);
    if (distance_m(before, simulation.T_map_base()) > 0)
      CHECK_FALSE(simulation.solids().touches(simulation.T_map_base().position(), options.robot_radius_m));
  }
}

TEST_CASE("errors of odometry grow with the way as they are said to") {
  OdometryErrors errors{0.1, 0, 0, 0, 0, 0, 0, 0, 0};
  double squares = 0;
  constexpr int kRobots = 2000, kSteps = 50;
  Random random(11);
  for (int robot = 0; robot < kRobots; ++robot) {
    WheelOdometry odometry(Drive::differential, errors, random.branch());
    const Pose2 start = odometry.T_odom_base();
    for (int k = 0; k < kSteps; ++k) odometry.move(Pose2(0.1, 0, 0));
    const double error = (start.inverse() * odometry.T_odom_base()).x() - 5;
    squares += error * error;
  }
  CHECK(std::sqrt(squares / kRobots) == Approx(0.1 * std::sqrt(5)).epsilon(0.06));
}

TEST_CASE("an arc is many short straight pieces") {
  const Velocity velocity{{0.6, 0.2}, 0.8};
  Pose2 pose;
  for (int k = 0; k < 10000; ++k) pose = pose * Pose2(Point(velocity.linear_mps * 1e-4), velocity.turn_radps * 1e-4);
  const Pose2 arc = moved(velocity, 1);
  CHECK(distance_m(arc, pose) < 1e-3);
  CHECK(arc.heading_rad() == Approx(0.8));
}

TEST_CASE("the way between two places stays on the floor") {
  Simulation simulation(room(), clean(), 1);
  Random random(2);
  for (int k = 0; k < 50; ++k) {
    const Point from = simulation.floor().anywhere(random), to = simulation.floor().anywhere(random);
    const auto way = simulation.floor().way(from, to);
    REQUIRE(way);
    CHECK((way->front() - from).norm() < 1e-9);
    CHECK((way->back() - to).norm() < 1e-9);
    for (const Point& p : *way) CHECK(simulation.floor().holds(p));
  }
  CHECK_FALSE(simulation.floor().way({1e6, 0}, simulation.floor().anywhere(random)));
}

TEST_CASE("an open door stands in its room, not across a corridor, though another door lies opposite") {
  std::vector<MapObject> objects;
  std::vector<MapFeature> features;
  const auto add = [&](const std::string& type, const std::string& sensor, const Segment& face) {
    const std::string id = "object-" + std::to_string(objects.size());
    MapFeature feature;
    feature.id = id + "/face";
    feature.object = MapObjectNumber(objects.size());
    feature.type = type;
    feature.sensor = sensor;
    feature.geometry = face;
    objects.push_back({id, type});
    features.push_back(feature);
  };
  for (const double y : {0.0, 2.0}) {  // sides of the corridor, with a door in the middle of each
    add("opal:Wall", "laser", {{-5, y}, {-0.5, y}});
    add("opal:Wall", "laser", {{0.5, y}, {5, y}});
    add("opal:Door", "", {{-0.5, y}, {0.5, y}});
  }
  for (const double y : {-4.0, 6.0}) add("opal:Wall", "laser", {{-5, y}, {5, y}});  // the rooms' far sides
  const auto map = SemanticMap::make("corridor", objects, features);
  Random random(1);
  for (int k = 0; k < 20; ++k) {
    const RayCaster open(building_solids(*map, 1, random));
    CHECK(open.cast({-4, 1}, {1, 0}, 8).solid == -1);
    CHECK(open.cast({-4, 0.2}, {1, 0}, 8).solid == -1);
    CHECK(open.cast({-4, 1.8}, {1, 0}, 8).solid == -1);
  }
}

TEST_CASE("a door that is open leaves its opening, as a whole") {
  const Segment a{{1, 0}, {2, 0}}, b{{2, 0.05}, {1, 0.05}};
  std::vector<MapFeature> features;
  for (const Segment& piece : {a, b}) {
    MapFeature feature;
    feature.id = "leaf-" + std::to_string(features.size());
    feature.object = MapObjectNumber(0);
    feature.type = "opal:Door";
    feature.geometry = piece;
    features.push_back(feature);
  }
  const auto map = SemanticMap::make("door", {{"door", "opal:Door"}}, features);
  Random random(1);
  for (int k = 0; k < 20; ++k) {
    const RayCaster closed(building_solids(*map, 0, random)), open(building_solids(*map, 1, random));
    CHECK(closed.cast({1.5, -3}, {0, 1}, 10).range_m == Approx(3));
    const auto& moved_a = std::get<Segment>(open.solids()[0].shape);
    const auto& moved_b = std::get<Segment>(open.solids()[1].shape);
    CHECK(open.cast({1.5, -3}, {0, 1}, 10).solid == -1);
    CHECK((moved_a.begin - moved_b.end).norm() == Approx(0.05));
    CHECK((moved_a.end - moved_b.begin).norm() == Approx(0.05));
  }
}
