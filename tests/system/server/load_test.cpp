// A fleet at work: build/release/bin/map_store_tests "[.load]". docs/map_store.md has the figures.
#include "made_maps.hpp"
#include "plugins/postgis_store/server.hpp"
#include "test_server.hpp"
#include "tests/kit/temporary_folder.hpp"
#include "tests/learning/made_drives.hpp"

#include "fleet/fleet_evidence.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <mutex>
#include <random>
#include <set>
#include <thread>

using namespace opal;
using namespace opal::store_tests;

namespace {

using Clock = std::chrono::steady_clock;
constexpr int kBuildings = 1000, kRobotsAtWork = 100, kFeatures = 300;
constexpr std::chrono::seconds kWorking{120}, kOutageAfter{50}, kOutage{10};
constexpr std::chrono::milliseconds kDriveWithoutServer{500};

std::string building(int number) { return "building " + std::to_string(number); }

template <class Work>
void on_all_cores(int count, int threads, Work work) {
  std::vector<std::jthread> workers;
  for (int first = 0; first < threads; ++first)
    workers.emplace_back([=] {
      for (int k = first; k < count; k += threads) work(k);
    });
}

/// How long calls took, and how many found no server.
class Calls {
 public:
  template <class Call>
  bool timed(Call call) {
    const auto start = Clock::now();
    try {
      call();
    } catch (const StoreUnreachable&) {
      const std::lock_guard lock(mutex_);
      ++unreachable_;
      return false;
    }
    const std::lock_guard lock(mutex_);
    ms_.push_back(1000 * std::chrono::duration<double>(Clock::now() - start).count());
    return true;
  }

  void print(const char* name, double span_s) {
    std::sort(ms_.begin(), ms_.end());
    const auto at = [&](double share) { return ms_.at(static_cast<std::size_t>(share * (ms_.size() - 1.0))); };
    std::printf("| %s | %zu | %.0f | %.0f | %.0f | %.0f | %d |\n", name, ms_.size(), ms_.size() / span_s, at(0.5),
                at(0.99), ms_.back(), unreachable_);
  }

 private:
  std::mutex mutex_;
  std::vector<double> ms_;
  int unreachable_ = 0;
};

struct Fleet {
  Calls pulls, sends, pushes;
  std::mutex mutex;
  std::set<std::pair<std::string, int>> pushed;       ///< versions that the store has confirmed
  std::map<std::string, std::set<std::string>> said;  ///< drives that robots have kept, by building
  std::atomic<int> refused = 0, conflicts = 0;
};

/// What one drive says of 40 objects on each of two visits.
DriveEvidence drive_of(int robot, int number) {
  std::vector<Deviation> objects;
  for (int k = 0; k < 40; ++k)
    objects.push_back(made::seen("wall-" + std::to_string(k), made::kMoved, {0.001 * robot, 0.001 * number}));
  DriveEvidence drive = made::drive(std::to_string(robot) + "/" + std::to_string(number), objects);
  drive.visits.push_back(drive.visits.front());
  return drive;
}

void survey(const MapStore& store, const StoreSource& here, unsigned seed, Fleet& fleet) {
  const auto changed = large_map(kFeatures, seed);
  fleet.pushes.timed([&] {
    try {
      const int version = store.push(*changed, {here.building, "surveyed", here.version}).version;
      const std::lock_guard lock(fleet.mutex);
      fleet.pushed.insert({here.building, version});
    } catch (const StoreConflict&) {
      ++fleet.conflicts;
    }
  });
}

/// Pulls, drives, tells what it has seen; without the server, on the map that it has. The surveyor among ten robots
/// pushes a new version, too.
void work(int robot, const std::filesystem::path& folder, Clock::time_point end, Fleet& fleet) {
  const auto mine = store();
  const EvidenceOutbox outbox(folder / std::to_string(robot));
  std::mt19937 random(static_cast<unsigned>(robot));
  StoreSource here{building(robot), 1};
  for (int number = 0; Clock::now() < end; ++number) {
    const std::string next = building(static_cast<int>(random() % kBuildings));
    const auto pull = [&] { here = {next, mine->pull(next, 0).version.version}; };
    if (!fleet.pulls.timed(pull)) std::this_thread::sleep_for(kDriveWithoutServer);
    const std::string said = to_json(drive_of(robot, number)).dump();
    outbox.keep(mine->where(), here, said);
    {
      const std::lock_guard lock(fleet.mutex);
      fleet.said[here.building].insert(said);
    }
    fleet.sends.timed([&] { fleet.refused += static_cast<int>(send_waiting(*mine, outbox).refused.size()); });
    if (robot % 10 == 0) survey(*mine, here, static_cast<unsigned>(1000 * robot + number), fleet);
  }
}

std::string figure_of(const std::string& sql) {
  std::string answer;
  postgis_store::Server({}).read([&](postgis_store::Session& session) { answer = session.ask(sql).at(0).at(0); });
  return answer;
}

/// Everything that robots have kept, through all versions of a building.
std::size_t drives_in(const MapStore& store, const std::string& place) {
  std::size_t drives = 0;
  for (const StoredVersion& version : store.list(place))
    drives += evidence_in(store, {place, version.version}, "room").drives.size();
  return drives;
}

/// Robots at work on the server, which goes away for a while. @return for how long [s].
double work_together(const std::filesystem::path& folder, Fleet& fleet) {
  const auto begin = Clock::now();
  {
    std::vector<std::jthread> robots;
    for (int robot = 0; robot < kRobotsAtWork; ++robot)
      robots.emplace_back([&, robot] { work(robot, folder, begin + kWorking, fleet); });
    std::this_thread::sleep_until(begin + kOutageAfter);
    server().stop();
    std::this_thread::sleep_for(kOutage);
    server().start();
  }
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

void print(Fleet& fleet, double span_s) {
  std::printf("| call | answered | per second | median ms | 99 %% ms | longest ms | no server |\n");
  fleet.pulls.print("pull a map", span_s);
  fleet.sends.print("push a drive", span_s);
  fleet.pushes.print("push a version", span_s);
  std::printf("%d pushes found a newer version; database %s\n", fleet.conflicts.load(),
              figure_of("SELECT pg_size_pretty(pg_database_size(current_database()))").c_str());
}

void check_drives(const Fleet& fleet) {
  std::size_t kept = 0, found = 0;
  for (const auto& [place, said] : fleet.said) kept += said.size(), found += drives_in(*store(), place);
  std::printf("%zu drives of %zu that robots kept are in the store\n", found, kept);
  CHECK(kept > 0);
  CHECK(found == kept);
  CHECK(fleet.refused == 0);
}

void check_versions(const Fleet& fleet) {
  std::set<std::pair<std::string, int>> versions;
  for (const StoredVersion& version : store()->list("")) versions.insert({version.building, version.version});
  CHECK(std::includes(versions.begin(), versions.end(), fleet.pushed.begin(), fleet.pushed.end()));
  CHECK(figure_of("SELECT count(*) FROM opal.buildings") == std::to_string(kBuildings));
  CHECK(figure_of("SELECT count(*) FROM opal.map_versions v WHERE v.features <> (SELECT count(*) FROM opal.features f "
                  "WHERE f.map = v.id)") == "0");
}

}  // namespace

TEST_CASE("a thousand buildings and a hundred robots, and a server that goes away in the middle", "[.load]") {
  const std::string before = std::getenv("PGDATABASE");
  server().use_new_database("fleet");
  store()->push(*large_map(kFeatures, 0), {building(0)});  // makes the tables
  const auto start = Clock::now();
  on_all_cores(kBuildings - 1, 8,
               [](int k) { store()->push(*large_map(kFeatures, unsigned(k + 1)), {building(k + 1)}); });
  std::printf("%d buildings of %d features pushed in %.0f s\n", kBuildings, kFeatures,
              std::chrono::duration<double>(Clock::now() - start).count());
  const TemporaryFolder folder;
  Fleet fleet;
  print(fleet, work_together(folder.path(), fleet));
  for (int robot = 0; robot < kRobotsAtWork; ++robot)  // what waits still
    send_waiting(*store(), EvidenceOutbox(folder.path_of(std::to_string(robot))));
  check_drives(fleet);
  check_versions(fleet);
  setenv("PGDATABASE", before.c_str(), 1);
}
