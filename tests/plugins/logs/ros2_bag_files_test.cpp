// The files of a recording: which ones are read together, and what is done about damage.
#include "bag_writer.hpp"
#include "tests/kit/temporary_folder.hpp"

#include <opal/common/error.hpp>
#include <opal/sensing/replay.hpp>
#include "plugins/ros2_bag/ros2_bag.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>

namespace {

using namespace opal;
using namespace opal::log_tests;
using ros2_bag::Ros2Bag;

std::vector<LogRecord> records_of(const std::string& path) { return read_all(*Ros2Bag({}).open(path)); }

LogContents contents_of(const std::string& path) { return Ros2Bag({}).contents(path); }

LaserScanMessage scan_stamped(double stamp_s) {
  LaserScanMessage scan;
  scan.stamp_s = stamp_s;
  return scan;
}

}  // namespace

TEST_CASE("a recording in several files is read by time, as one") {
  const TemporaryFolder folder;
  for (const int part : {0, 1, 2}) {
    BagWriter bag(folder.path_of("part_" + std::to_string(2 - part) + ".db3"));
    bag.odometry();  // the numbers of topics differ between the files
    if (part == 1) bag.topic("/chatter", "std_msgs/msg/String");
    const int scans = bag.scans();
    for (const int second : {1, 2}) bag.message(scans, 10 * part + second, scan_stamped(10 * part + second).bytes());
  }
  CHECK(Ros2Bag({}).recognizes(folder.path()));
  const auto records = records_of(folder.path());
  std::vector<double> stamps_s;
  for (const LogRecord& record : records)
    if (const auto* scan = std::get_if<RawScan>(&record)) stamps_s.push_back(scan->stamp_s);
  CHECK(stamps_s == std::vector<double>{1, 2, 11, 12, 21, 22});
}

TEST_CASE("a part without messages hides no mount on /tf, and does not begin in 1970") {
  const TemporaryFolder folder;
  { BagWriter(folder.path_of("part_0.db3")).scans(); }
  {
    BagWriter bag(folder.path_of("part_1.db3"));
    const int scans = bag.scans(), odometry = bag.odometry(), transforms = bag.transforms();
    bag.message(scans, 1000, scan_stamped(1000).bytes());
    bag.message(odometry, 1000, odometry_bytes(1000, {0, 0, 0, 0, 0, 0, 1}));
    bag.message(transforms, 1001, transforms_bytes({{"base_link", "laser", {0.2, 0, 0, 0, 0, 0, 1}}}));
  }
  const auto records = records_of(folder.path());
  REQUIRE(records.size() == 3);
  CHECK(std::get<MountRecord>(records.front()).T_parent_child.x() == Approx(0.2));
  CHECK(contents_of(folder.path()).first_s == Approx(1000));
}

TEST_CASE("parts that the recording's list names and that are not there are told") {
  const TemporaryFolder folder;
  {
    BagWriter bag(folder.path_of("my drive_0.db3"));
    bag.message(bag.scans(), 1, scan_stamped(1).bytes());
  }
  std::ofstream(folder.path_of("metadata.yaml"))
      << "rosbag2_bagfile_information:\n  relative_file_paths:\n    - my drive_0.db3\n    - \"my drive_1.db3\"\n"
         "  files:\n    - path: my drive_1.db3\n";
  const std::string words =
      "metadata.yaml names my drive_1.db3, and no such file is there: that part of the recording is missing";
  CHECK(contents_of(folder.path()).defects.contains(words));
  CHECK(Ros2Bag({}).open(folder.path())->defects().contains(words));
}

TEST_CASE("of a folder only the files of one recording are joined") {
  const TemporaryFolder folder;
  const auto write = [&](const std::string& name, double stamp_s) {
    BagWriter bag(folder.path_of(name));
    bag.message(bag.scans(), stamp_s, scan_stamped(stamp_s).bytes());
  };
  write("monday.db3", 1);
  CHECK(records_of(folder.path()).size() == 1);
  write("tuesday.db3", 2);
  CHECK(Ros2Bag({}).recognizes(folder.path()));  // so that it says what is wrong
  const std::string refusal =
      folder.path() +
      ": several recordings (monday.db3, tuesday.db3), expected one of them, or a folder with the "
      "parts of one: NAME_0, NAME_1 ..., or those that its metadata.yaml names";
  CHECK_THROWS_WITH(records_of(folder.path()), refusal);
  CHECK_THROWS_WITH(Ros2Bag({}).contents(folder.path()), refusal);
  folder.write("metadata.yaml", "relative_file_paths:\n  - monday.db3\n");
  CHECK_THROWS_WITH(records_of(folder.path()), refusal);
  folder.write("metadata.yaml", "relative_file_paths:\n  - monday.db3\n  - tuesday.db3\n");
  CHECK(records_of(folder.path()).size() == 2);
  CHECK(Ros2Bag({}).contents(folder.path()).format == "ROS 2 bag (sqlite3) of monday.db3, tuesday.db3");
}

TEST_CASE("parts may have the times of their beginning in their names, but not two recordings") {
  const TemporaryFolder folder;
  const auto write = [&](const std::string& name) {
    BagWriter bag(folder.path_of(name + ".db3"));
    bag.message(bag.scans(), 1, scan_stamped(1).bytes());
  };
  write("lab_2024-05-01-10-00-00_0");
  write("lab_2024-05-01-10-05-00_1");
  CHECK(records_of(folder.path()).size() == 2);
  write("lab_2024-05-02-09-00-00_0");
  CHECK_THROWS_AS(records_of(folder.path()), LogError);
}

TEST_CASE("topics of scans and lasers have to be as many, and the topic of a laser is read") {
  const TemporaryFolder folder;
  const std::string path = folder.path_of("a.db3");
  {
    BagWriter bag(path);
    bag.message(bag.scans("/scan"), 1, scan_stamped(1).bytes());
    bag.message(bag.scans("/back"), 2, scan_stamped(2).bytes());
  }
  LaserModel laser;
  CHECK_THROWS_WITH(Ros2Bag({{"/scan", "/back"}, ""}).open_for(path, {laser}),
                    "2 topics of scans are named (/scan, /back), and 1 laser is described, expected a list /sensor "
                    "with a laser for each topic");
  laser.topic = "/back";
  const auto records = read_all(*Ros2Bag({}).open_for(path, {laser}));
  REQUIRE(records.size() == 1);
  CHECK(std::get<RawScan>(records[0]).stamp_s == 2);
  laser.topic = "back";
  CHECK(read_all(*Ros2Bag({}).open_for(path, {laser})).size() == 1);
  laser.topic = "/front";
  CHECK_THROWS_WITH(Ros2Bag({}).open_for(path, {laser}),
                    path + ": no topic /front of type sensor_msgs/LaserScan that can be read, there is /back, /scan");
}

TEST_CASE("a file with a damaged part is read as far as it goes, one that was cut off is refused") {
  const TemporaryFolder folder;
  const std::string path = folder.path_of("a.db3");
  {
    BagWriter bag(path);
    const int scans = bag.scans();
    LaserScanMessage wide;
    wide.ranges_m.assign(720, 3.0f);
    for (int i = 1; i <= 500; ++i) bag.message(scans, wide.stamp_s = i, wide.bytes());
  }
  const auto bytes = std::filesystem::file_size(path);
  {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(static_cast<std::streamoff>(bytes / 4 * 3));
    file << std::string(bytes / 8, '\xff');
  }
  const auto reader = Ros2Bag({}).open(path);
  const std::size_t scans = read_all(*reader).size();
  CHECK(scans > 100);
  CHECK(scans < 500);
  CHECK_FALSE(reader->defects().empty());

  std::filesystem::resize_file(path, bytes / 2);
  CHECK(Ros2Bag({}).recognizes(path));  // so that it says what is wrong
  const std::string half = std::to_string(bytes / 2), whole = std::to_string(bytes);
  CHECK_THROWS_WITH(Ros2Bag({}).open(path), path + ": a damaged SQLite bag: database disk image is malformed; it has " +
                                                half + " bytes, expected " + whole +
                                                "; what is left is read of a copy after 'truncate -s " + whole +
                                                " COPY'");
  std::filesystem::resize_file(path, bytes);
  CHECK_NOTHROW(Ros2Bag({}).open(path));
}

TEST_CASE("reading a recording leaves nothing beside it, and what waits in its write-ahead log is read") {
  const TemporaryFolder folder;
  const std::string path = folder.path_of("50%#?.db3");
  const auto files = [&] {
    const std::filesystem::directory_iterator all(folder.path());
    return std::distance(begin(all), end(all));
  };
  {
    BagWriter bag(path);
    bag.message(bag.scans(), 1, scan_stamped(1).bytes());
  }
  sqlite3* database = nullptr;
  sqlite3_open(path.c_str(), &database);
  sqlite3_exec(database, "PRAGMA journal_mode=WAL", nullptr, nullptr, nullptr);
  sqlite3_close(database);
  CHECK(records_of(path).size() == 1);
  CHECK(files() == 1);

  sqlite3_open(path.c_str(), &database);  // a recorder that still runs
  sqlite3_exec(database,
               "INSERT INTO messages(topic_id, timestamp, data) SELECT topic_id, timestamp + 1, data FROM messages",
               nullptr, nullptr, nullptr);
  CHECK(records_of(path).size() == 2);
  sqlite3_close(database);
}

TEST_CASE("a list of parts with long lines is read") {
  const TemporaryFolder folder;
  {
    BagWriter bag(folder.path_of("drive_0.db3"));
    bag.message(bag.scans(), 1, scan_stamped(1).bytes());
  }
  std::ofstream(folder.path_of("metadata.yaml"))
      << "  offered_qos_profiles: \"" << std::string(1'000'000, 'x') << "\"\r\n  relative_file_paths:\r\n"
      << "    - 'drive_1.db3'\r\n";
  CHECK(contents_of(folder.path())
            .defects.contains(
                "metadata.yaml names drive_1.db3, and no such file is there: that part of the recording is missing"));
}
