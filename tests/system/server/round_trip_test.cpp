// What is pushed comes back as it was.
#include "made_maps.hpp"
#include "program.hpp"
#include "test_server.hpp"

#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>
#include <opal/map/map_importer.hpp>
#include <opal/plugin/testing/store_contract.hpp>
#include "map/check/map_diff.hpp"

#include <catch2/catch.hpp>

#include <filesystem>

using namespace opal;
using namespace opal::store_tests;

namespace fs = std::filesystem;

namespace {

void check_round_trip(const SemanticMap& map, const std::string& building) {
  CAPTURE(building);
  const StoredVersion pushed = store()->push(map, {building, "as it is"});
  CHECK(pushed.features == static_cast<int>(map.features().size()));
  const auto pulled = SemanticMap::parse(store()->pull(building, pushed.version).document, map.name());
  for (const std::string& sentence : map_diff(map, *pulled).sentences()) FAIL_CHECK(sentence);
  CHECK(map.to_json_ld() == pulled->to_json_ld());
}

/// Documents and whatever an importer takes, in a folder.
std::vector<fs::path> sources_in(const fs::path& folder) {
  std::vector<fs::path> sources;
  if (!fs::is_directory(folder)) return sources;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file()) sources.push_back(entry.path());
  std::sort(sources.begin(), sources.end());
  return sources;
}

/// Null if no importer takes it, or none can.
Map imported(const fs::path& source) {
  if (source.extension() == ".jsonld") return SemanticMap::read(source);
  for (const RegisteredType& type : shipped_plugins().types()) {
    if (type.kind != PluginKind::map_importer) continue;
    const auto importer = shipped_plugins().make<MapImporter>(type.info.name);
    if (importer->recognizes(source)) return importer->import(source).map;
  }
  return nullptr;
}

}  // namespace

TEST_CASE("the store on PostGIS keeps the contract of its kind") {
  const TypeInfo type{"opal:PostgisStore", {}, {}};
  store()->push(*SemanticMap::make("", {}, {}), {"first of all"});  // makes the tables
  for (const std::string& violation : testing::live_map_store_violations(*store(), type, "contract"))
    FAIL_CHECK(violation);
}

TEST_CASE("a map with everything in it comes back as it was") {
  const Map map = rich_map();
  REQUIRE(map->unused().size() > 0);
  REQUIRE(map->prefixes().size() == 2);
  REQUIRE(map->features().size() == 6);
  check_round_trip(*map, "rich");
}

TEST_CASE("a map without anything comes back as it was") { check_round_trip(*SemanticMap::make("", {}, {}), "empty"); }

TEST_CASE("a map with a layer of patterns comes back as it was") {
  const Finished made = opal_run({"map", "patterns", OPAL_SOURCE_DIR "/maps/malaga/malaga.map.yaml", "-o",
                                  (server().folder() / "patterns.jsonld").string()});
  CAPTURE(made.said);
  REQUIRE(made.exit_code == 0);
  const auto map = SemanticMap::read(server().folder() / "patterns.jsonld");
  REQUIRE(map->patterns().size() > 10);
  check_round_trip(*map, "patterns");
}

TEST_CASE("every map at hand comes back as it was") {
  int maps = 0;
  for (const char* folder : {"/maps", "/maps/malaga", "/../shared/data/sites", "/../shared/data/ifc"})
    for (const fs::path& source : sources_in(OPAL_SOURCE_DIR + std::string(folder))) {
      Map map;
      try {
        map = imported(source);
      } catch (const Error& error) {
        WARN(source.string() + " is left out: " + error.what());
      }
      if (!map) continue;
      check_round_trip(*map, source.string());
      ++maps;
    }
  CHECK(maps >= 2);
  WARN(std::to_string(maps) + " maps went to the store and back");
}

TEST_CASE("a map of 20,000 features comes back as it was") { check_round_trip(*large_map(20000, 7), "large"); }

TEST_CASE("a text that PostgreSQL cannot store is refused by name") {
  const auto map = SemanticMap::parse(
      R"({"@context": ["urn:opal:v1", {"acme": "urn:acme:"}], "@graph": [{"@id": "w", "@type": "Wall", "acme:note": "a\u0000b"}]})",
      "zero");
  CHECK_THROWS_WITH(store()->push(*map, {"zero"}), Catch::Contains("node {\"@id\":\"w\"") && Catch::Contains("U+0000"));
  CHECK(store()->list("zero").empty());
}

TEST_CASE("names, messages and ids are data, whatever they look like") {
  const Map map = rich_map();
  for (const std::string& name :
       {std::string("'; DROP SCHEMA opal CASCADE; --"), std::string("\"quoted\" \\ $1 %s"), std::string("a@3"),
        std::string("h\xc3\xa4lle \xe4\xb8\xad"), std::string("{}"), std::string("NULL"), std::string(" ")}) {
    CAPTURE(name);
    const StoredVersion pushed = store()->push(*map, {name, name + "'\n\"second line\"", 0});
    CHECK(pushed.building == name);
    CHECK(pushed.message == name + "'\n\"second line\"");
    CHECK(pushed.map_name == map->name());
    CHECK(store()->list(name).size() == 1);
    CHECK(map_diff(*map, *SemanticMap::parse(store()->pull(name, 1).document, map->name())).empty());
    CHECK(store()->features_near({name, 0, "' OR '1'='1", {0, 0}, 1000}).empty());
  }
  CHECK_THROWS_AS(store()->push(*map, {"two\nlines"}), StoreError);
  CHECK_THROWS_AS(store()->push(*map, {"not \xff utf-8"}), StoreError);
}
