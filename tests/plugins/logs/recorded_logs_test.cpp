// Recorded logs are not part of this repository: where they are absent, these tests say so and pass.
#include <opal/sensing/replay.hpp>
#include "evaluation/site.hpp"
#include "plugins/carmen_log/carmen_log.hpp"
#include "plugins/mcap_log/mcap_log.hpp"
#include "plugins/ros2_bag/ros2_bag.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

namespace {

using namespace opal;
namespace fs = std::filesystem;

const std::string kShared = OPAL_SOURCE_DIR "/../shared/data";

/// The beginnings of the sites' file names; empty, with a message, if there are none.
std::vector<std::string> sites() {
  std::vector<std::string> prefixes;
  const std::string ending = ".log.gz";
  if (fs::is_directory(kShared + "/sites"))
    for (const auto& entry : fs::directory_iterator(kShared + "/sites"))
      if (const std::string path = entry.path().string(); path.ends_with(ending))
        prefixes.push_back(path.substr(0, path.size() - ending.size()));
  if (prefixes.empty()) WARN("skipped: no recorded logs in " + kShared + "/sites");
  return prefixes;
}

int scans_in(const std::vector<LogRecord>& records) {
  int scans = 0;
  for (const LogRecord& record : records) scans += std::holds_alternative<RawScan>(record) ? 1 : 0;
  return scans;
}

nlohmann::json document(const std::string& path) {
  std::ifstream file(path);
  return nlohmann::json::parse(file);
}

}  // namespace

TEST_CASE("every scan of every site is read and replayed, and every query has the scans it announces") {
  for (const std::string& site : sites()) {
    INFO(site);
    const auto reader = carmen_log::CarmenLog("").open(site + ".log.gz");
    const std::vector<LogRecord> records = read_all(*reader);
    CHECK(reader->defects().empty());
    const nlohmann::json announced = document(site + ".info.json");
    CHECK(scans_in(records) == announced.at("n_scans").get<int>());

    const LaserModel laser = read_site_laser(site + ".info.json");
    Replay whole(records, {laser});
    const std::vector<Sample> samples = read_all(whole);
    CHECK(samples.size() == announced.at("n_scans").get<std::size_t>());
    for (const Sample& sample : samples) REQUIRE(sample.views.front().scan.invalid <= laser.beams);
    CHECK(whole.counts().count("clock reset") == 0);
    CHECK(whole.counts().count("odometry jump") == 0);

    const std::vector<Query> queries = read_queries(site + ".queries.json");
    const nlohmann::json announced_queries = document(site + ".queries.json").at("queries");
    REQUIRE(queries.size() == announced_queries.size());
    for (std::size_t i = 0; i < queries.size(); ++i) {
      ReplayOptions window;
      window.from_s = queries[i].start_s;
      window.to_s = queries[i].end_s;
      Replay replay(records, {laser}, window);
      INFO(queries[i].id);
      CHECK(read_all(replay).size() == announced_queries[i].at("n_scans").get<std::size_t>());
    }
  }
}

TEST_CASE("a genuine ROS 2 recording gives its scans, odometry and mount") {
  const std::string recording = kShared + "/ros2/olin-mac";
  if (!fs::is_directory(recording)) {
    WARN("skipped: no recording in " + recording);
    return;
  }
  const ros2_bag::Ros2Bag source({});
  CHECK(source.recognizes(recording));
  CHECK_FALSE(source.recognizes(recording + "/metadata.yaml"));
  const auto reader = source.open(recording);
  const std::vector<LogRecord> records = read_all(*reader);
  CHECK(reader->defects().empty());
  CHECK(reader->progress() == 1);
  CHECK(scans_in(records) == 357);
  CHECK(records.size() == 1 + 357 + 920);

  const auto& mount = std::get<MountRecord>(records.front());
  CHECK(mount.parent == "base_link");
  CHECK(mount.child == "rplidar_link");
  CHECK(mount.T_parent_child.heading_rad() == Approx(std::numbers::pi / 2).margin(1e-3));

  LaserModel laser;
  laser.geometry_from_log = true;
  Replay replay(records, {laser});
  const std::vector<Sample> samples = read_all(replay);
  CHECK(samples.size() == 357);
  CHECK(replay.counts().empty());
  for (const Sample& sample : samples) {
    CHECK(sample.views.front().scan.invalid == 0);
    CHECK(sample.views.front().scan.points.size() + sample.views.front().scan.free_bearings_rad.size() == 720);
  }
}

TEST_CASE("a genuine MCAP recording gives its scans, odometry and mount") {
  const std::string recording = kShared + "/ros2/gazebo_path.mcap";
  if (!fs::exists(recording)) {
    WARN("skipped: no recording in " + recording);
    return;
  }
  const mcap_log::McapLog source({});
  CHECK(source.recognizes(recording));
  const auto reader = source.open(recording);
  const std::vector<LogRecord> records = read_all(*reader);
  CHECK(reader->defects().empty());
  CHECK(reader->progress() == 1);
  CHECK(scans_in(records) == 132);
  CHECK(records.size() == 1 + 132 + 776);
  CHECK(std::get<MountRecord>(records.front()).T_parent_child.x() == Approx(-0.032));
}
