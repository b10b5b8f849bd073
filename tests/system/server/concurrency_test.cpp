// Pushes that are interrupted, that come at once, and that expect something else than they find.
#include "made_maps.hpp"
#include "plugins/postgis_store/server.hpp"
#include "program.hpp"
#include "test_server.hpp"

#include "map/check/map_diff.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <fstream>
#include <set>
#include <thread>

using namespace opal;
using namespace opal::store_tests;
using Catch::Contains;

namespace {

std::string written(const Map& map, const std::string& name) {
  const std::string path = (server().folder() / name).string();
  std::ofstream(path) << map->to_json_ld();
  return path;
}

std::vector<int> numbers_of(const std::string& building) {
  std::vector<int> numbers;
  for (const StoredVersion& version : store()->list(building)) numbers.push_back(version.version);
  return numbers;
}

bool is_there(const std::string& building, int version, const Map& map) {
  return map_diff(*map, *SemanticMap::parse(store()->pull(building, version).document, map->name())).empty();
}

/// What somebody else does in the database at the same time.
std::string answer_to(const std::string& sql, const std::vector<std::string>& parameters = {}) {
  std::string answer;
  postgis_store::Server({}).transact([&](postgis_store::Session& session) {
    const auto rows = session.ask(sql, parameters);
    if (!rows.empty()) answer = rows[0][0];
  });
  return answer;
}

constexpr const char* kStuckPush =
    "SELECT pid FROM pg_stat_activity WHERE wait_event_type = 'Lock' AND query LIKE 'INSERT INTO opal.features%' "
    "AND datname = current_database()";

/// Starts a push, and stops it in the middle, when the graph is there and the features are not: `interrupt` gets the
/// push and the server's process that serves it.
template <class Interrupt>
Finished push_interrupted_by(const std::vector<std::string>& push, Interrupt interrupt) {
  std::optional<Program> pusher;
  postgis_store::Server blocker({});
  blocker.transact([&](postgis_store::Session& session) {
    session.ask("LOCK TABLE opal.features IN ACCESS EXCLUSIVE MODE");
    pusher.emplace(push);
    std::string backend;
    for (int k = 0; k < 1200 && backend.empty(); ++k) {
      std::this_thread::sleep_for(std::chrono::milliseconds(25));
      backend = answer_to(kStuckPush);
    }
    REQUIRE(backend != "");
    interrupt(*pusher, backend);
  });
  return pusher->wait();
}

void wait_until_gone(const std::string& backend) {
  for (int k = 0; k < 1200; ++k) {
    if (answer_to("SELECT pid FROM pg_stat_activity WHERE pid = $1::integer", {backend}).empty()) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(25));
  }
  FAIL("the push's server process does not end");
}

/// Rows that belong to no version.
std::string orphans() {
  return answer_to(
      "SELECT (SELECT count(*) FROM opal.nodes WHERE map NOT IN (SELECT id FROM opal.map_versions)) + "
      "(SELECT count(*) FROM opal.features WHERE map NOT IN (SELECT id FROM opal.map_versions)) + "
      "(SELECT count(*) FROM opal.map_versions v JOIN opal.buildings b ON b.id = v.building WHERE v.version > "
      "b.newest)");
}

}  // namespace

TEST_CASE("a push whose process is killed in the middle leaves the version before it") {
  const Map old_map = malaga(), new_map = large_map(500, 1);
  const std::string building = "killed";
  store()->push(*old_map, {building});
  std::string backend;
  const Finished killed = push_interrupted_by({"map", "push", written(new_map, "new.jsonld"), "--building", building},
                                              [&](Program& pusher, const std::string& pid) {
                                                backend = pid;
                                                pusher.kill_at_once();
                                              });
  CHECK(killed.exit_code == -1);
  wait_until_gone(backend);
  CHECK(numbers_of(building) == std::vector<int>{1});
  CHECK(is_there(building, 0, old_map));
  CHECK(orphans() == "0");
  CHECK(store()->push(*new_map, {building}).version == 2);
  CHECK(is_there(building, 2, new_map));
}

TEST_CASE("a push whose session the server ends in the middle says so and leaves the version before it") {
  const Map old_map = malaga(), new_map = large_map(500, 1);
  const std::string building = "terminated";
  store()->push(*old_map, {building});
  const Finished ended = push_interrupted_by(
      {"map", "push", written(new_map, "new.jsonld"), "--building", building},
      [&](Program&, const std::string& pid) { answer_to("SELECT pg_terminate_backend($1::integer)", {pid}); });
  CAPTURE(ended.said);
  CHECK(ended.exit_code == 3);
  CHECK_THAT(ended.said, Contains("the connection broke"));
  CHECK(numbers_of(building) == std::vector<int>{1});
  CHECK(is_there(building, 0, old_map));
  CHECK(orphans() == "0");
}

TEST_CASE("robots that push at once lose nothing") {
  constexpr int kRobots = 6;
  std::vector<Map> maps;
  std::vector<std::unique_ptr<Program>> robots;
  for (int k = 0; k < kRobots; ++k) maps.push_back(large_map(300 + k, static_cast<unsigned>(k)));
  for (int k = 0; k < kRobots; ++k)
    robots.push_back(std::make_unique<Program>(
        std::vector<std::string>{"map", "push", written(maps[k], "robot" + std::to_string(k) + ".jsonld"), "--building",
                                 "together", "--message", std::to_string(k)}));
  for (const auto& robot : robots) {
    const Finished finished = robot->wait();
    CAPTURE(finished.said);
    CHECK(finished.exit_code == 0);
  }
  CHECK(numbers_of("together") == std::vector<int>{1, 2, 3, 4, 5, 6});
  std::set<std::string> messages;
  for (const StoredVersion& version : store()->list("together")) {
    messages.insert(version.message);
    CHECK(is_there("together", version.version, maps.at(std::stoul(version.message))));
  }
  CHECK(messages.size() == kRobots);
}

TEST_CASE("of robots that push the first maps of a new database at once, none fails") {
  const std::string before = std::getenv("PGDATABASE");
  server().use_new_database("brand_new");
  const std::string map = written(large_map(50, 1), "first.jsonld");
  std::vector<std::unique_ptr<Program>> robots;
  for (int k = 0; k < 4; ++k)
    robots.push_back(
        std::make_unique<Program>(std::vector<std::string>{"map", "push", map, "--building", k % 2 ? "a" : "b"}));
  for (const auto& robot : robots) {
    const Finished finished = robot->wait();
    CAPTURE(finished.said);
    CHECK(finished.exit_code == 0);
  }
  CHECK(numbers_of("") == std::vector<int>{1, 2, 1, 2});
  setenv("PGDATABASE", before.c_str(), 1);
}

TEST_CASE("of robots that push on the same version and say so, one wins and the others hear of it") {
  const Map map = large_map(200, 3);
  const std::string file = written(map, "expected.jsonld");
  store()->push(*map, {"expected"});
  std::vector<std::unique_ptr<Program>> robots;
  for (int k = 0; k < 4; ++k)
    robots.push_back(std::make_unique<Program>(
        std::vector<std::string>{"map", "push", file, "--building", "expected", "--expect", "1"}));
  int won = 0;
  for (const auto& robot : robots) {
    const Finished finished = robot->wait();
    won += finished.exit_code == 0;
    if (finished.exit_code != 0) {
      CHECK(finished.exit_code == 1);
      CHECK_THAT(finished.said,
                 Contains("building 'expected' is at version 2, expected version 1; nothing was pushed"));
    }
  }
  CHECK(won == 1);
  CHECK(numbers_of("expected") == std::vector<int>{1, 2});
  CHECK_THROWS_AS(store()->push(*map, {"never seen", "", 3}), StoreConflict);
  CHECK(store()->list("never seen").empty());
  CHECK(store()->push(*map, {"never seen", "", 0}).version == 1);
}

TEST_CASE("a push that waits too long for another one gives up") {
  const Map map = large_map(20, 3);
  store()->push(*map, {"busy"});
  const auto impatient = shipped_plugins().make<MapStore>("opal:PostgisStore", {{"lock_timeout_s", 1}});
  postgis_store::Server blocker({});
  blocker.transact([&](postgis_store::Session& session) {
    session.ask("SELECT 1 FROM opal.buildings WHERE name = 'busy' FOR UPDATE");
    CHECK_THROWS_WITH(impatient->push(*map, {"busy"}), Contains("lock timeout"));
    CHECK(store()->pull("busy", 0).version.version == 1);  // who reads does not wait
  });
  CHECK(store()->push(*map, {"busy"}).version == 2);
}
