// Servers that are not there, go away, refuse, or hold something else; and what is said about it.
#include "made_maps.hpp"
#include "plugins/postgis_store/server.hpp"
#include "program.hpp"
#include "setting.hpp"
#include "test_server.hpp"
#include "tests/kit/file_content.hpp"

#include <opal/deployment/deployment.hpp>
#include "map/check/map_diff.hpp"

#include <catch2/catch.hpp>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

using namespace opal;
using namespace opal::store_tests;
using Catch::Contains;

namespace fs = std::filesystem;

namespace {

void run_sql(const std::string& sql) {
  postgis_store::Server({}).transact([&](postgis_store::Session& session) { session.run(sql); });
}

/// Takes connections of the kernel's, and never says a word.
class SilentServer {
 public:
  SilentServer() : socket_(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    REQUIRE(bind(socket_, reinterpret_cast<sockaddr*>(&address), size) == 0);
    REQUIRE(listen(socket_, 8) == 0);
    REQUIRE(getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size) == 0);
    port_ = ntohs(address.sin_port);
  }
  ~SilentServer() { close(socket_); }
  SilentServer(const SilentServer&) = delete;
  SilentServer& operator=(const SilentServer&) = delete;
  std::string port() const { return std::to_string(port_); }

 private:
  int socket_;
  int port_ = 0;
};

/// Whether any file below a folder holds a text.
bool anywhere_in(const fs::path& folder, const std::string& text) {
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && content_of(entry.path().string()).find(text) != std::string::npos) return true;
  return false;
}

const std::string kMalaga = OPAL_SOURCE_DIR "/maps/malaga/malaga";

}  // namespace

TEST_CASE("a password appears nowhere, right or wrong") {
  store()->push(*malaga(), {"secret"});
  const TemporaryFolder folder;
  const Setting cache("OPAL_MAP_CACHE", folder.path_of("cache"));
  const std::vector<std::vector<std::string>> commands{
      {"map", "list"},
      {"map", "push", OPAL_SOURCE_DIR "/maps/example_room.jsonld", "--building", "secret"},
      {"map", "pull", "--building", "secret", "-o", folder.path_of("map.jsonld")},
      {"map", "check", "store:secret"},
      {"localize", OPAL_SOURCE_DIR "/configs/malaga.jsonld", kMalaga + ".log.gz", "--map", "store:secret", "-o",
       folder.path()},
      {"plugins", "--check", OPAL_PLUGIN_DIR "/postgis_store.so"}};
  for (const std::string& password : {std::string(TestServer::kPassword), std::string("S3cret-but-wrong!")}) {
    const Setting word("PGPASSWORD", password);
    for (const auto& command : commands) {
      const Finished finished = opal_run(command);
      CAPTURE(command, finished.said);
      CHECK_THAT(finished.said, !Contains(password));
      if (password != TestServer::kPassword && command[0] == "map" && command[1] != "check")
        CHECK_THAT(finished.said, Contains("password authentication failed for user \"keeper\""));
    }
    CHECK_FALSE(anywhere_in(folder.path(), password));
  }
}

TEST_CASE("a password inside a name of a database is not repeated") {
  const Setting database("PGDATABASE", "postgresql://someone:S3cret@nowhere/maps password=S3cret");
  CHECK_THAT(store()->where(), !Contains("S3cret"));
  CHECK_THROWS_WITH(store()->list(""), !Contains("S3cret"));
}

TEST_CASE("credentials come from a password file and a service file, too") {
  store()->push(*malaga(), {"filed"});
  const TemporaryFolder folder;
  std::ofstream(folder.path_of("pgpass")) << "*:*:*:keeper:" << TestServer::kPassword << '\n';
  fs::permissions(folder.path_of("pgpass"), fs::perms::owner_read | fs::perms::owner_write);
  std::ofstream(folder.path_of("services"))
      << "[maps]\nhost=127.0.0.1\nport=" << std::getenv("PGPORT") << "\nuser=keeper\ndbname=postgres\n";
  const std::string port = std::getenv("PGPORT");
  const Setting no_password("PGPASSWORD", ""), pgpass("PGPASSFILE", folder.path_of("pgpass"));
  CHECK(store()->list("filed").size() == 1);
  const Setting file("PGSERVICEFILE", folder.path_of("services")), service("PGSERVICE", "maps");
  const Setting elsewhere("PGHOST", "/nowhere"), nobody("PGUSER", "nobody");
  CHECK(store()->where() == "database postgres on 127.0.0.1:" + port);
  CHECK(store()->list("filed").size() == 1);
  unsetenv("PGSERVICE");
}

TEST_CASE("a server that is not there, or says nothing, is told in good time") {
  const SilentServer silent;
  const Setting host("PGHOST", "127.0.0.1"), port("PGPORT", silent.port());
  const auto hasty = shipped_plugins().make<MapStore>("opal:PostgisStore", {{"connect_timeout_s", 2}});
  CHECK_THROWS_AS(hasty->list(""), StoreUnreachable);
  CHECK_THROWS_WITH(hasty->pull("hall", 0),
                    Contains("database postgres on 127.0.0.1:" + silent.port()) && Contains("timeout expired"));
  const Setting nowhere("PGPORT", "1");
  CHECK_THROWS_WITH(hasty->list(""), Contains("Connection refused"));
}

TEST_CASE("a store goes on by itself when its server comes back") {
  const auto patient = store();
  patient->push(*malaga(), {"restarted"});
  server().stop();
  CHECK_THROWS_AS(patient->list("restarted"), StoreUnreachable);
  server().start();
  CHECK(patient->list("restarted").size() == 1);
}

TEST_CASE("a database without a map store, or with one of another time, is refused with what to do") {
  const std::string before = std::getenv("PGDATABASE");
  server().use_new_database("other_times");
  CHECK_THROWS_WITH(store()->pull("hall", 0), Contains("holds no map store yet; the first opal map push makes it"));
  const Finished listed = opal_run({"map", "list"});
  CHECK(listed.exit_code == 3);
  store()->push(*malaga(), {"hall"});
  run_sql("INSERT INTO opal.schema_version (version) VALUES (99)");
  CHECK_THROWS_WITH(store()->pull("hall", 0),
                    Contains("schema version 99, this program knows up to 2; use a newer Opal"));
  CHECK_THROWS_WITH(store()->push(*malaga(), {"hall"}), Contains("schema version 99"));
  run_sql("DELETE FROM opal.schema_version WHERE version = 99");
  CHECK(store()->list("hall").size() == 1);
  setenv("PGDATABASE", before.c_str(), 1);
}

TEST_CASE("a role that may only read pulls, and hears that it may not push") {
  store()->push(*malaga(), {"shared"});
  run_sql(
      "CREATE ROLE robot LOGIN PASSWORD 'robots-only'; GRANT USAGE ON SCHEMA opal TO robot; "
      "GRANT SELECT ON ALL TABLES IN SCHEMA opal TO robot");
  const Setting user("PGUSER", "robot"), password("PGPASSWORD", "robots-only");
  CHECK(store()->pull("shared", 0).version.pushed_by == "keeper");
  CHECK(store()->features_near({"shared", 0, "PlanarLidar2D", {0, 0}, 1000}).size() > 10);
  CHECK_THROWS_WITH(store()->push(*malaga(), {"shared"}), Contains("permission denied for table buildings"));
}

TEST_CASE("a role that is no superuser makes the tables where the extensions are, and shares them") {
  const std::string before = std::getenv("PGDATABASE");
  server().use_new_database("delegated");
  run_sql(
      "CREATE EXTENSION postgis; CREATE EXTENSION btree_gist; CREATE ROLE owner LOGIN PASSWORD 'owners-only'; "
      "CREATE ROLE ann LOGIN PASSWORD 'anns-only'; GRANT CREATE ON DATABASE delegated TO owner");
  const auto push_as = [](const std::string& role, const std::string& word) {
    const Setting user("PGUSER", role), password("PGPASSWORD", word);
    return store()->push(*large_map(20, 1), {"shared"});
  };
  CHECK_THROWS_WITH(push_as("ann", "anns-only"), Contains("permission denied for database delegated"));
  CHECK(push_as("owner", "owners-only").pushed_by == "owner");
  CHECK_THROWS_WITH(push_as("ann", "anns-only"), Contains("permission denied for schema opal"));
  run_sql(
      "GRANT USAGE ON SCHEMA opal TO ann; GRANT SELECT ON ALL TABLES IN SCHEMA opal TO ann; GRANT INSERT, UPDATE ON "
      "opal.buildings, opal.map_versions, opal.nodes, opal.node_relations, opal.features TO ann");
  const StoredVersion second = push_as("ann", "anns-only");
  CHECK(second.version == 2);
  CHECK(second.pushed_by == "ann");
  setenv("PGDATABASE", before.c_str(), 1);
}

TEST_CASE("a localizer that has its map goes on when the server goes away") {
  const TemporaryFolder folder;
  const Setting cache("OPAL_MAP_CACHE", "");
  store()->push(*malaga(), {"hall"});
  Program localizer({"localize", OPAL_SOURCE_DIR "/configs/malaga.jsonld", kMalaga + ".log.gz", "--map", "store:hall",
                     "--serve=0", "--speed", "60", "-o", folder.path()});
  const bool has_its_map = localizer.says("map: version 1 of 'hall'") && localizer.says("http://");
  server().stop();
  CHECK(has_its_map);
  const bool answered = localizer.says("written to ");
  localizer.interrupt();
  const Finished finished = localizer.wait();
  server().start();
  CAPTURE(finished.said);
  CHECK(answered);
  CHECK_THAT(finished.said, Contains("localized"));
  CHECK(finished.exit_code == 0);
}

TEST_CASE("a robot that starts without its server uses the last map that it pulled, and says how old it is") {
  const TemporaryFolder folder;
  const Setting cache("OPAL_MAP_CACHE", folder.path_of("cache"));
  store()->push(*large_map(100, 1), {"hall with cache", "old"});
  store()->push(*malaga(), {"hall with cache", "measured anew"});
  CHECK_THAT(opal_run({"map", "check", "store:hall with cache"}).said, Contains("map: version 2 of 'hall with cache'"));
  opal_run({"map", "check", "store:hall with cache@1"});
  server().stop();
  const std::vector<std::string> localize{
      "localize", OPAL_SOURCE_DIR "/configs/malaga.jsonld", kMalaga + ".log.gz", "-o", folder.path(), "--map"};
  const auto with_map = [&](const std::string& map) {
    std::vector<std::string> command = localize;
    command.push_back(map);
    return opal_run(command);
  };
  const Finished cached = with_map("store:hall with cache");
  const Finished pinned = opal_run({"map", "check", "store:hall with cache@1"});
  const Finished unknown = with_map("store:hall never pulled");
  {
    const Setting no_cache("OPAL_MAP_CACHE", "");
    CHECK(with_map("store:hall with cache").exit_code == 3);
  }
  server().start();
  CAPTURE(cached.said, pinned.said, unknown.said);
  CHECK(cached.exit_code == 0);
  CHECK_THAT(cached.said, Contains("the map store cannot be reached") && Contains("version 2 of 'hall with cache'") &&
                              Contains("measured anew") && Contains("as pulled just now"));
  CHECK_THAT(pinned.said, Contains("version 1 of 'hall with cache'"));
  CHECK(unknown.exit_code == 3);
  CHECK_THAT(unknown.said, Contains("store:hall never pulled was never kept from it on this machine"));
}

TEST_CASE("a cache that cannot be written, or holds something else, is told") {
  const TemporaryFolder folder;
  store()->push(*malaga(), {"uncached"});
  const std::string file = folder.write("file", "no folder");
  {
    const Setting cache("OPAL_MAP_CACHE", file + "/cache");
    const Finished checked = opal_run({"map", "check", "store:uncached"});
    CAPTURE(checked.said);
    CHECK(checked.exit_code == 0);
    CHECK_THAT(checked.said, Contains("the map is not kept for times without its store"));
  }
  const Setting cache("OPAL_MAP_CACHE", folder.path_of("cache"));
  opal_run({"map", "check", "store:uncached"});
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder.path_of("cache")))
    if (entry.is_regular_file()) std::ofstream(entry.path()) << "{}";
  const Setting nowhere("PGPASSWORD", "wrong");
  const Finished checked = opal_run({"map", "check", "store:uncached"});
  CHECK(checked.exit_code == 3);
  CHECK_THAT(checked.said, Contains("is no map that Opal has kept"));
}

TEST_CASE("a program without the plugin says what is missing") {
  const TemporaryFolder folder;
  const fs::path build = fs::path(OPAL_PLUGIN_DIR).parent_path();
  fs::create_directories(folder.path_of("lib"));
  fs::create_directories(folder.path_of("plugins"));
  fs::copy_file(build / "lib/libopal.so.0", folder.path_of("lib/libopal.so.0"));
  const Setting library("LD_LIBRARY_PATH", folder.path_of("lib"));
  for (const std::string& source : {std::string("store:hall"), std::string("store:hall@2")}) {
    const Finished checked = opal_run({"map", "check", source});
    CAPTURE(checked.said);
    CHECK(checked.exit_code == 3);
    CHECK_THAT(checked.said, Contains("no plugin offers a MapStore") && Contains("libpqxx"));
  }
  CHECK_THAT(opal_run({"map", "list"}).said, Contains("no plugin offers a MapStore"));
}
