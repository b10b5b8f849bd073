// opal map push, pull, list and diff, and store:BUILDING where a map is asked for.
#include "made_maps.hpp"
#include "program.hpp"
#include "test_server.hpp"

#include "map/check/map_diff.hpp"

#include <catch2/catch.hpp>

#include <fstream>

using namespace opal;
using namespace opal::store_tests;
using Catch::Contains;

namespace {

const std::string kRoom = OPAL_SOURCE_DIR "/maps/example_room.jsonld";

std::string path_of(const std::string& name) { return (server().folder() / name).string(); }

}  // namespace

TEST_CASE("a map goes to the store, is listed, and comes back") {
  const Finished pushed =
      opal_run({"map", "push", kRoom, "--building", "room", "--message", "as built", "--expect", "0"});
  CAPTURE(pushed.said);
  CHECK(pushed.exit_code == 0);
  CHECK_THAT(pushed.said, Contains("pushed: version 1 of 'room'") &&
                              Contains("by keeper: as built; 8 features, to database postgres on "));
  const Finished listed = opal_run({"map", "list", "--building", "room"});
  CHECK_THAT(listed.said, Contains("room      1        2") && Contains("keeper") && Contains("as built"));
  CHECK(opal_run({"map", "list", "--building", "roof"}).exit_code == 1);
  const Finished pulled = opal_run({"map", "pull", "--building", "room", "-o", path_of("room.jsonld")});
  CAPTURE(pulled.said);
  CHECK(pulled.exit_code == 0);
  CHECK(map_diff(*SemanticMap::read(kRoom), *SemanticMap::read(path_of("room.jsonld"))).empty());
  CHECK(opal_run({"map", "pull", "--building", "room", "--version", "2", "-o", path_of("room.jsonld")}).exit_code == 3);
}

TEST_CASE("diff compares documents and versions, and tells by its exit code") {
  nlohmann::json room = nlohmann::json::parse(std::ifstream(kRoom));
  store()->push(*SemanticMap::read(kRoom), {"changing"});
  for (nlohmann::json& node : room["@graph"])
    if (node.value("@id", "") == "south_wall") node["represented_by"]["represented_by"]["begin"]["x"] = -0.25;
  std::ofstream(path_of("changed.jsonld")) << room;
  CHECK(opal_run({"map", "push", path_of("changed.jsonld"), "--building", "changing"}).exit_code == 0);
  const Finished same = opal_run({"map", "diff", kRoom, "store:changing@1"});
  CHECK(same.exit_code == 0);
  CHECK_THAT(same.said, Contains("no difference"));
  const Finished moved = opal_run({"map", "diff", "store:changing@1", "store:changing"});
  CAPTURE(moved.said);
  CHECK(moved.exit_code == 1);
  CHECK_THAT(moved.said,
             Contains("features: 3 moved (by at most 0.250 m)") && Contains("feature south_face moved by 0.250 m"));
  CHECK_THAT(opal_run({"map", "diff", "store:changing@1", "store:changing", "--summary"}).said,
             !Contains("south_face"));
}

TEST_CASE("a stored map stands wherever a map is asked for") {
  store()->push(*malaga(), {"everywhere"});
  CHECK(opal_run({"map", "check", "store:everywhere"}).exit_code == 0);
  CHECK(opal_run({"map", "damage", "store:everywhere", "--damage", "drop=0.3", "-o", path_of("worse.jsonld")})
            .exit_code == 0);
  CHECK(opal_run({"map", "push", "store:everywhere@1", "--building", "copied"}).exit_code == 0);
  CHECK(opal_run({"map", "diff", "store:everywhere", "store:copied"}).exit_code == 0);
  CHECK(opal_run({"map", "check", "store:"}).exit_code == 3);
  nlohmann::json deployment = nlohmann::json::parse(std::ifstream(OPAL_SOURCE_DIR "/configs/malaga.jsonld"));
  deployment["map"] = "store:everywhere@1";
  std::ofstream(path_of("hall.jsonld")) << deployment;
  const Finished localized = opal_run(
      {"localize", path_of("hall.jsonld"), OPAL_SOURCE_DIR "/maps/malaga/malaga.log.gz", "-o", path_of("run")});
  CAPTURE(localized.said);
  CHECK(localized.exit_code == 0);
  CHECK_THAT(localized.said, Contains("map: version 1 of 'everywhere'") && Contains("localized"));
}
