#include "bag_writer.hpp"
#include "tests/kit/temporary_folder.hpp"

#include <opal/common/error.hpp>
#include <opal/sensing/replay.hpp>
#include "plugins/ros2_bag/ros2_bag.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

namespace {

using namespace opal;
using namespace opal::log_tests;
using ros2_bag::Ros2Bag;

using Counts = std::map<std::string, int>;

const std::vector<double> kHere{0, 0, 0, 0, 0, 0, 1};
const double kHalf = std::sqrt(0.5);  // quaternions of quarter turns

struct WalkedBag {
  std::vector<LogRecord> records;
  Counts defects;
};

WalkedBag walk_bag(const std::string& path, const recording::TopicChoice& topics = {}) {
  const auto reader = Ros2Bag(topics).open(path);
  WalkedBag walked{read_all(*reader), {}};
  walked.defects = reader->defects();
  CHECK(reader->progress() == 1);
  return walked;
}

LaserScanMessage scan_at(double stamp_s) {
  LaserScanMessage scan;
  scan.stamp_s = stamp_s;
  return scan;
}

/// One scan and one odometry message, and what is fixed to what.
WalkedBag walk_mounted(const std::vector<Link>& links) {
  const TemporaryFolder folder;
  {
    BagWriter bag(folder.path_of("a.db3"));
    bag.message(bag.scans(), 1, scan_at(1).bytes());
    bag.message(bag.odometry(), 1, odometry_bytes(1, kHere));
    bag.message(bag.static_transforms(), 2, transforms_bytes(links));  // too late, but it holds all the same
  }
  return walk_bag(folder.path_of("a.db3"));
}

}  // namespace

TEST_CASE("scans and odometry of a recording become records in either byte order") {
  const bool big_endian = GENERATE(false, true);
  CAPTURE(big_endian);
  const TemporaryFolder folder;
  {
    BagWriter bag(folder.path_of("a.db3"));
    LaserScanMessage scan = scan_at(1000.25);
    scan.ranges_m = {0.05f, 2, 13, std::numeric_limits<float>::infinity(), 12};
    scan.big_endian = big_endian;
    bag.message(bag.scans(), 1000.5, scan.bytes());
    bag.message(bag.odometry(), 1000.4,
                odometry_bytes(1000.125, {1, 2, 0.1, 0, 0, kHalf, kHalf}, "base_link", big_endian));
    bag.message(bag.topic("/chatter", "std_msgs/msg/String"), 1000.3, "no CDR at all");
  }
  const WalkedBag walked = walk_bag(folder.path_of("a.db3"));
  REQUIRE(walked.records.size() == 2);
  const auto& odometry = std::get<OdometryRecord>(walked.records[0]);  // recorded first
  CHECK(odometry.stamp_s == 1000.125);
  CHECK(odometry.T_odom_base.y() == 2);
  CHECK(odometry.T_odom_base.heading_rad() == Approx(std::numbers::pi / 2));
  const auto& scan = std::get<RawScan>(walked.records[1]);
  CHECK(scan.stamp_s == 1000.25);
  CHECK(scan.frame == "laser");
  CHECK(*scan.angle_min_rad == -1);
  CHECK(*scan.angle_increment_rad == 0.5);
  REQUIRE(scan.ranges_m.size() == 5);
  CHECK(std::isnan(scan.ranges_m[0]));  // below range_min
  CHECK(scan.ranges_m[1] == 2);
  CHECK(std::isinf(scan.ranges_m[2]));  // above range_max
  CHECK(std::isinf(scan.ranges_m[3]));
  CHECK(scan.ranges_m[4] == 12);
  CHECK(walked.defects == Counts{{"no static transform from base_link to laser", 1}});
}

TEST_CASE("the laser's mount is followed through all that is fixed, in three dimensions") {
  // Two links that each turn about another axis: one quarter about z, then the laser lies 1 m ahead of that.
  const WalkedBag walked = walk_mounted({{"base_link", "mast", {0.5, 0, 1, 0, 0, kHalf, kHalf}},
                                         {"/mast", "laser", {1, 0, 0, 0, 0, 0, 1}},
                                         {"base_footprint", "base_link", {7, 7, 0, 0, 0, 0, 1}}});
  const auto& mount = std::get<MountRecord>(walked.records.at(0));
  CHECK(mount.parent == "base_link");
  CHECK(mount.child == "laser");
  CHECK((mount.T_parent_child.position() - Point(0.5, 1)).norm() < 1e-9);
  CHECK(mount.T_parent_child.heading_rad() == Approx(std::numbers::pi / 2));
  CHECK(walked.defects == Counts{});
}

TEST_CASE("the beams of a laser that hangs upside down are turned the right way round") {
  const WalkedBag walked = walk_mounted({{"base_link", "laser", {0, 0, 0, 1, 0, 0, 0}}});  // half a turn about x
  const auto& scan = std::get<RawScan>(walked.records.at(1));
  LaserModel laser;
  laser.geometry_from_log = true;
  laser = with_log_geometry(laser, walked.records);
  const Scan clean = make_scan(scan, laser);
  REQUIRE(clean.points.size() == 3);
  // The beam at -1 rad in the laser's own frame points to +1 rad on the floor.
  CHECK(clean.points.back().beam == 0);
  CHECK((laser.T_base_laser * clean.points.back().position - unit_vector(1.0)).norm() < 1e-6);
}

TEST_CASE("a tilted laser, an unconnected one and a circle of frames are told") {
  const double tilt_rad = 0.4;
  const std::vector<double> tilted{0, 0, 0, 0, std::sin(tilt_rad / 2), 0, std::cos(tilt_rad / 2)};
  CHECK(walk_mounted({{"base_link", "laser", tilted}}).defects == Counts{{"laser that is tilted", 1}});
  const Counts unconnected{{"no static transform from base_link to laser", 1}};
  CHECK(walk_mounted({{"mast", "laser", kHere}}).defects == unconnected);
  CHECK(walk_mounted({}).defects == unconnected);
  const WalkedBag circle = walk_mounted({{"laser", "mast", kHere}, {"mast", "laser", kHere}});
  CHECK(circle.records.size() == 2);
  CHECK(circle.defects == unconnected);
}

TEST_CASE("damaged messages are counted, and the next one is read") {
  const TemporaryFolder folder;
  const std::string good_scan = scan_at(3).bytes();
  const std::string good_odometry = odometry_bytes(3, kHere);
  {
    BagWriter bag(folder.path_of("a.db3"));
    const int scans = bag.scans(), odometry = bag.odometry();
    bag.message(scans, 1, "");
    bag.message(scans, 1, good_scan.substr(0, good_scan.size() / 2));
    bag.message(scans, 1, std::string(good_scan.size(), '\xff'));
    LaserScanMessage standing = scan_at(1);
    standing.angle_increment_rad = 0;
    bag.message(scans, 1, standing.bytes());
    bag.message(scans, 3, good_scan);
    bag.message(odometry, 1, good_odometry.substr(0, 40));
    bag.message(odometry, 1, odometry_bytes(1, {NAN, 0, 0, 0, 0, 0, 1}));
    bag.message(odometry, 1, odometry_bytes(1, {0, 0, 0, 0, 0, 0, 0}));  // no rotation at all
    bag.message(odometry, 3, good_odometry);
    bag.message(bag.static_transforms(), 1, "damaged");
  }
  const WalkedBag walked = walk_bag(folder.path_of("a.db3"));
  CHECK(walked.records.size() == 2);
  CHECK(walked.defects == Counts{{"damaged LaserScan message", 4},
                                 {"damaged Odometry message", 3},
                                 {"damaged TFMessage", 1},
                                 {"no static transform from base_link to laser", 1}});
}

TEST_CASE("wherever a message is cut, it is damaged before its ranges end") {
  const std::string whole = scan_at(5).bytes();
  const std::size_t needed = whole.size() - 4;  // the length of the intensities, which are not used
  for (std::size_t length = 0; length <= whole.size(); ++length) {
    CAPTURE(length);
    const TemporaryFolder folder;
    {
      BagWriter bag(folder.path_of("a.db3"));
      bag.message(bag.scans(), 1, whole.substr(0, length));
    }
    CHECK(walk_bag(folder.path_of("a.db3")).records.size() == (length >= needed ? 1 : 0));
  }
}

TEST_CASE("a stamp that was never set is the time of recording") {
  const TemporaryFolder folder;
  {
    BagWriter bag(folder.path_of("a.db3"));
    bag.message(bag.scans(), 12.5, scan_at(0).bytes());
    bag.message(bag.odometry(), 13.5, odometry_bytes(0, kHere));
  }
  const WalkedBag walked = walk_bag(folder.path_of("a.db3"));
  CHECK(std::get<RawScan>(walked.records.at(0)).stamp_s == 12.5);
  CHECK(std::get<OdometryRecord>(walked.records.at(1)).stamp_s == 13.5);
}

TEST_CASE("of several topics the usual one is read, or the one that is asked for") {
  const TemporaryFolder folder;
  const std::string path = folder.path_of("a.db3");
  {
    BagWriter bag(path);
    bag.message(bag.scans("/scan"), 1, scan_at(1).bytes());
    bag.message(bag.scans("/rear/scan"), 2, scan_at(2).bytes());
    bag.message(bag.odometry("/wheels"), 3, odometry_bytes(3, kHere));
    bag.message(bag.odometry("/fused"), 4, odometry_bytes(4, kHere));
  }
  CHECK_THROWS_WITH(walk_bag(path), path +
                                        ": several topics of type nav_msgs/Odometry (/fused, /wheels), expected an "
                                        "option to choose one: odometry_topic=/fused");
  const WalkedBag usual = walk_bag(path, {{}, "/wheels"});
  REQUIRE(usual.records.size() == 2);
  CHECK(std::get<RawScan>(usual.records[0]).stamp_s == 1);
  CHECK(std::get<OdometryRecord>(usual.records[1]).stamp_s == 3);
  CHECK(std::get<RawScan>(walk_bag(path, {{"/rear/scan"}, "/fused"}).records[0]).stamp_s == 2);
  CHECK(walk_bag(path, {{}, "/fused", "odom", "base_lnk"})
            .defects.contains("the option base_frame is not used: /fused is the odometry"));
  CHECK_THROWS_WITH(
      walk_bag(path, {{"/front"}, ""}),
      path + ": no topic /front of type sensor_msgs/LaserScan that can be read, there is /rear/scan, /scan");
}

TEST_CASE("what is no recording is not recognized, and refused by name") {
  const TemporaryFolder folder;
  const Ros2Bag source({});
  std::vector<std::string> paths{folder.path(), folder.path_of("missing.db3")};
  paths.push_back(folder.write("text.log", "ODOM 1 2 3"));
  paths.push_back(folder.write("empty.bin", ""));
  paths.push_back(folder.write("noise.bin", std::string("SQLite format 3\0", 16) + std::string(4000, '\x7f')));
  {
    sqlite3* database = nullptr;
    paths.push_back(folder.path_of("other.sqlite"));
    sqlite3_open(paths.back().c_str(), &database);
    sqlite3_exec(database, "CREATE TABLE cats(name TEXT)", nullptr, nullptr, nullptr);
    sqlite3_close(database);
  }
  for (const std::string& path : paths) {
    INFO(path);
    CHECK_FALSE(source.recognizes(path));
    CHECK_THROWS_AS(source.open(path), LogError);
    CHECK_THROWS_WITH(source.open(path), Catch::StartsWith(path));
  }
}

TEST_CASE("a recording without scans is refused") {
  const TemporaryFolder folder;
  const std::string path = folder.path_of("a.db3");
  {
    BagWriter bag(path);
    bag.message(bag.odometry(), 1, odometry_bytes(1, kHere));
  }
  CHECK_THROWS_WITH(walk_bag(path), path + ": no topic of type sensor_msgs/LaserScan that can be read");
}
