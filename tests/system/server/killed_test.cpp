// kill -9 at random moments: what a program has told as pushed is in the store, once and whole. OPAL_KILLS says how
// often each program is killed.
#include "made_maps.hpp"
#include "program.hpp"
#include "setting.hpp"
#include "test_server.hpp"

#include "fleet/evidence_outbox.hpp"
#include "map/check/map_diff.hpp"
#include "tests/kit/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <random>
#include <thread>

using namespace opal;
using namespace opal::store_tests;
using Catch::Contains;

namespace {

int kills() {
  const char* said = std::getenv("OPAL_KILLS");
  return said ? std::stoi(said) : 3;
}

/// Runs it to its end, to know how long that takes, and then again and again until some moment before.
class Killing {
 public:
  explicit Killing(std::vector<std::string> command) : command_(std::move(command)) {
    const auto begin = std::chrono::steady_clock::now();
    const Finished whole = opal_run(command_);
    CAPTURE(whole.said);
    REQUIRE(whole.exit_code == 0);
    longest_s_ = 1.2 * std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }

  Finished once() {
    Program program(command_);
    std::this_thread::sleep_for(
        std::chrono::duration<double>(std::uniform_real_distribution<double>(0, longest_s_)(random_)));
    program.kill_at_once();
    return program.wait();
  }

 private:
  std::vector<std::string> command_;
  double longest_s_ = 0;
  std::mt19937 random_{1};
};

bool has_said_pushed(const Finished& finished) { return finished.said.find("pushed: ") != std::string::npos; }

}  // namespace

TEST_CASE("a push that is killed at any moment is a whole version or none, and what was told is there") {
  const TemporaryFolder folder;
  const Map map = large_map(2000, 4);
  const std::string file = folder.write("map.jsonld", map->to_json_ld().dump());
  Killing push({"map", "push", file, "--building", "killed at random"});
  std::size_t told = 1;
  for (int k = 0; k < kills(); ++k) {
    told += has_said_pushed(push.once());
    REQUIRE(store()->list("killed at random").size() >= told);
  }
  std::this_thread::sleep_for(std::chrono::seconds(1));  // the server learns that a client has gone
  for (const StoredVersion& version : store()->list("killed at random")) {
    CAPTURE(version.version);
    CHECK(map_diff(*map, *SemanticMap::parse(store()->pull("killed at random", version.version).document, "stored"))
              .empty());
  }
}

TEST_CASE("a drive whose push is killed at any moment is in the store once, or waits") {
  const TemporaryFolder folder;
  const Setting outbox("OPAL_OUTBOX", folder.path_of("outbox")), cache("OPAL_MAP_CACHE", folder.path_of("cache"));
  REQUIRE(opal_run({"map", "push", OPAL_SOURCE_DIR "/maps/malaga/malaga-demo.map.yaml", "--building", "driven"})
              .exit_code == 0);
  const std::string log = OPAL_SOURCE_DIR "/maps/malaga/malaga-demo.log.gz", made = folder.path_of("made.json");
  const std::string config = OPAL_SOURCE_DIR "/configs/malaga.jsonld";
  REQUIRE(
      opal_run({"learn", "store:driven", log, "--config", config, "-o", folder.path_of("x.jsonld"), "--evidence", made})
          .exit_code == 0);
  Killing push({"learn", "store:driven", made, "--config", config, "--push"});
  for (int k = 0; k < kills(); ++k) {
    const Finished finished = push.once();
    const std::size_t waiting = EvidenceOutbox::usual().waiting_for(store()->where()).size();
    CAPTURE(finished.said, waiting);
    CHECK(waiting <= 1);
    if (has_said_pushed(finished)) CHECK(waiting == 0);
    CHECK(store()->evidence("driven", 1).size() == 1);
  }
  CHECK_THAT(opal_run({"learn", "store:driven", "--config", config, "--push"}).said, Contains("of which 0 are new"));
  CHECK(EvidenceOutbox::usual().waiting_for(store()->where()).empty());
}
