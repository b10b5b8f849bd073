#include "library_bag.hpp"
#include "plugins/ros1_bag/ros1_bag.hpp"
#include "tests/kit/temporary_folder.hpp"

#include <opal/sensing/replay.hpp>

#include <catch2/catch.hpp>

using namespace opal;

TEST_CASE("a bag of ROS 1's own library is read to the last message, whatever the compression") {
  const std::string compression = GENERATE("none", "bz2", "lz4");
  CAPTURE(compression);
  const TemporaryFolder folder;
  const std::string path = folder.path_of("a.bag");
  write_library_bag(path, compression);
  const ros1_bag::Ros1Bag source({});
  CHECK(source.recognizes(path));
  const auto reader = source.open(path);
  const std::vector<LogRecord> records = read_all(*reader);
  CHECK(records.size() == 600);
  CHECK(reader->defects() == std::map<std::string, int>{{"no static transform from base_link to laser", 1}});
  const auto& scan = std::get<RawScan>(records.back());
  CHECK(scan.stamp_s == Approx(1029.9));
  REQUIRE(scan.ranges_m.size() == 200);
  CHECK(scan.ranges_m[1] == 1.0f + static_cast<float>((7 + 299) % 50) / 10);
  const LogContents contents = source.contents(path);
  CHECK(contents.topics.at(0).messages == 300);
  CHECK(contents.odometries.at(0).driven_m == Approx(299 * 0.05));
}
