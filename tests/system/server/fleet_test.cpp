// What robots learn of one building, through the store: opal learn --push, and opal learn store:BUILDING.
#include "made_maps.hpp"
#include "plugins/postgis_store/schema.hpp"
#include "plugins/postgis_store/server.hpp"
#include "program.hpp"
#include "setting.hpp"
#include "test_server.hpp"
#include "tests/kit/file_content.hpp"
#include "tests/kit/temporary_folder.hpp"

#include <opal/common/strict_json.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <fstream>

using namespace opal;
using namespace opal::store_tests;
using Catch::Contains;

namespace {

constexpr int kRobots = 10;

/// A small office whose map is wrong, and a drive of each robot through it as it is.
class Robots {
 public:
  Robots() {
    expect_done(opal_run({"map", "generate", "office", "--size", "400", "--seed", "3", "-o", built()}));
    expect_done(opal_run({"map", "damage", built(), "--damage", "wall=0.3,drop=0.1", "--seed", "5", "-o", map()}));
    for (int k = 0; k < kRobots; ++k)
      expect_done(opal_run({"simulate", built(), "-o", folder_.path_of(std::to_string(k)), "--seed", std::to_string(k),
                            "--drives", "1", "--distance", "25"}));
  }

  std::string built() const { return folder_.path_of("built.jsonld"); }
  std::string map() const { return folder_.path_of("map.jsonld"); }
  std::string log(int robot) const { return folder_.path_of(std::to_string(robot) + ".log.gz"); }
  std::string path_of(const std::string& name) const { return folder_.path_of(name); }

  /// opal learn of `map` from the logs of robots.
  std::vector<std::string> learning(const std::string& map, const std::vector<int>& robots,
                                    const std::vector<std::string>& how) const {
    std::vector<std::string> command{"learn", map};
    for (const int robot : robots) command.push_back(log(robot));
    command.insert(command.end(), {"--info", folder_.path_of("0.info.json")});
    command.insert(command.end(), how.begin(), how.end());
    return command;
  }

 private:
  static void expect_done(const Finished& finished) {
    if (finished.exit_code != 0) throw std::runtime_error(finished.said);
  }
  TemporaryFolder folder_;
};

const Robots& robots() {
  static const Robots made;
  return made;
}

void push_map(const std::string& building) {
  const Finished pushed = opal_run({"map", "push", robots().map(), "--building", building});
  CAPTURE(pushed.said);
  REQUIRE(pushed.exit_code == 0);
}

}  // namespace

TEST_CASE("ten robots that push at once teach the same as one robot in ten drives, to the byte") {
  push_map("taught");
  std::vector<int> all(kRobots);
  for (int k = 0; k < kRobots; ++k) all[k] = k;
  const Finished alone = opal_run(robots().learning(robots().map(), all, {"-o", robots().path_of("alone.jsonld")}));
  CAPTURE(alone.said);
  REQUIRE(alone.exit_code == 0);
  CHECK_THAT(alone.said, Contains("moved wall-"));

  const TemporaryFolder outbox;
  const Setting own("OPAL_OUTBOX", outbox.path());
  std::vector<std::unique_ptr<Program>> programs;
  for (auto robot = all.rbegin(); robot != all.rend(); ++robot)
    programs.push_back(std::make_unique<Program>(robots().learning("store:taught", {*robot}, {"--push"})));
  for (const auto& program : programs) {
    const Finished finished = program->wait();
    CAPTURE(finished.said);
    CHECK(finished.exit_code == 0);
    CHECK_THAT(finished.said, Contains("pushed: "));
  }
  const Finished fleet = opal_run({"learn", "store:taught", "-o", robots().path_of("fleet.jsonld")});
  CAPTURE(fleet.said);
  CHECK_THAT(fleet.said, Contains("10 drives about store:taught@1, from database postgres on"));
  CHECK(content_of(robots().path_of("fleet.jsonld")) == content_of(robots().path_of("alone.jsonld")));
  CHECK(opal_run({"map", "review", "store:taught", "--html", robots().path_of("review.html")}).exit_code == 0);
}

TEST_CASE("drives wait on the robot while the server is away, and count once") {
  push_map("away");
  const TemporaryFolder folder;
  const Setting outbox("OPAL_OUTBOX", folder.path_of("outbox")), cache("OPAL_MAP_CACHE", folder.path_of("cache"));
  REQUIRE(opal_run({"map", "check", "store:away"}).exit_code == 0);
  server().stop();
  const Finished away = opal_run(robots().learning("store:away", {0}, {"--push"}));
  server().start();
  CAPTURE(away.said);
  CHECK(away.exit_code == 1);
  CHECK_THAT(away.said, Contains("not pushed: ") && Contains("the drives wait in " + folder.path_of("outbox")));
  CHECK(store()->evidence("away", 1).empty());
  const Finished back = opal_run({"learn", "store:away", "--push"});
  CAPTURE(back.said);
  CHECK_THAT(back.said, Contains("pushed: 1 drives, of which 1 are new") && Contains("1 drives about store:away@1"));
  CHECK_THAT(opal_run(robots().learning("store:away", {0}, {"--push"})).said, Contains("of which 0 are new"));
  CHECK(store()->evidence("away", 0).size() == 1);
}

TEST_CASE("a drive counts for the version that it was compared with") {
  const auto version_with = [](const std::vector<std::string>& drives) {
    const int version = store()->push(*malaga(), {"versions"}).version;
    store()->add_evidence("versions", version, drives);
    return version;
  };
  const int first = version_with({"{\"a\": 1.5}", "{\"b\": [0.1, 1e-7]}"}), second = version_with({"{\"c\": 3}"});
  CHECK(store()->evidence("versions", first).size() == 2);
  CHECK(store()->evidence("versions", 0).size() == 1);
  CHECK(parse_json(store()->evidence("versions", second)[0].document, "stored") == nlohmann::json{{"c", 3}});
  CHECK_THROWS_WITH(store()->add_evidence("versions", 3, {"{}"}), Contains("has no version 3 of building 'versions'"));
  CHECK_THROWS_WITH(store()->add_evidence("versions", 0, {"{}"}), Contains("version 0, expected a number from 1 on"));
  CHECK_THROWS_AS(store()->add_evidence("versions", 1, {"{}", "no json"}), StoreError);
  CHECK_THROWS_WITH(store()->add_evidence("versions", 1, {"\"\\u0000\""}), Contains("U+0000"));
  CHECK(store()->evidence("versions", first).size() == 2);  // all of it or nothing
}

TEST_CASE("a robot needs one right to write, and cannot touch maps with it") {
  store()->push(*malaga(), {"rights"});
  postgis_store::Server({}).transact([](postgis_store::Session& session) {
    session.run(
        "CREATE ROLE driver LOGIN PASSWORD 'drivers-only'; GRANT USAGE ON SCHEMA opal TO driver; "
        "GRANT SELECT ON ALL TABLES IN SCHEMA opal TO driver; GRANT INSERT ON opal.drive_evidence TO driver");
  });
  const Setting user("PGUSER", "driver"), password("PGPASSWORD", "drivers-only");
  CHECK(store()->add_evidence("rights", 1, {"{}"}) == 1);
  CHECK(store()->add_evidence("rights", 1, {"{}"}) == 0);
  CHECK(store()->evidence("rights", 1).at(0).added_by == "driver");
  CHECK_THROWS_WITH(store()->push(*malaga(), {"rights"}), Contains("permission denied"));
  CHECK_THROWS_WITH(postgis_store::Server({}).transact(
                        [](postgis_store::Session& session) { session.run("DELETE FROM opal.drive_evidence"); }),
                    Contains("permission denied"));
}

TEST_CASE("tables of the first version give maps, and take evidence after the next push") {
  const std::string before = std::getenv("PGDATABASE");
  server().use_new_database("first_tables");
  postgis_store::Server({}).transact([](postgis_store::Session& session) {
    session.run(content_of(OPAL_SOURCE_DIR "/plugins/postgis_store/schema_1.sql"));
    session.run("INSERT INTO opal.schema_version (version) VALUES (1)");
  });
  CHECK(store()->list("").empty());
  CHECK_THROWS_WITH(store()->evidence("hall", 0),
                    Contains("schema version 1, this needs 2; the next opal map push, by the role that made it"));
  store()->push(*malaga(), {"hall"});
  CHECK(store()->add_evidence("hall", 1, {"{}"}) == 1);
  setenv("PGDATABASE", before.c_str(), 1);
}

TEST_CASE("what cannot be pushed is said before hours of logs are played") {
  CHECK_THAT(opal_run(robots().learning(robots().map(), {0}, {"--push"})).said, Contains("expected store:BUILDING"));
  CHECK_THAT(opal_run(robots().learning(robots().map(), {0}, {})).said, Contains("-o is missing"));
  CHECK_THAT(opal_run({"learn", robots().map(), "-o", robots().path_of("x.jsonld")}).said, Contains("LOG is missing"));
  CHECK_THAT(opal_run({"learn", "store:taught", "--push", "--overlay", robots().path_of("alone.jsonld")}).said,
             Contains("--push with overlays"));
}
