#include "map_tools/map_stack.hpp"

#include "tests/kit/temporary_folder.hpp"

#include <opal/common/error.hpp>
#include <opal/plugin/testing/scorer_contract.hpp>

#include <catch2/catch.hpp>

#include <sstream>

using namespace opal;
using Catch::Contains;

namespace {

/// The example map with what an importer would have found.
std::shared_ptr<const SemanticMap> floor_with(std::vector<MapConnection> connections) {
  const auto map = testing::example_map();
  MapOrigin origin = map->origin();
  origin.connections = std::move(connections);
  return SemanticMap::make(map->name(), map->objects(), map->features(), map->patterns(), std::move(origin));
}

MapConnection found(const std::string& id, const std::string& type, const Point& at) {
  return {id, type, "", 1, {{"", Pose2(at, 0)}}};
}

StackedMap house() {
  const std::vector<StoreyPart> parts{
      {"low", "Ground floor", 0.0, floor_with({found("l", "opal:Lift", {2, 2}), found("s", "opal:Stair", {4, 2})})},
      {"mid", "First floor", 3.5, floor_with({found("l", "opal:Lift", {2.3, 2.2})})},
      {"top", "Second floor", 7.0,
       floor_with({found("l", "opal:Lift", {2, 1.9}), found("t", "opal:Stair", {4, 2.5})})}};
  return stacked_map("house", parts, StackOptions{.building = "The house"});
}

}  // namespace

TEST_CASE("a stack holds every storey on a sheet of its own, and each keeps its frame") {
  const auto once = testing::example_map();
  const auto map = house().map;
  REQUIRE(map->origin().storeys.size() == 3);
  CHECK(map->features().size() == 3 * once->features().size());
  CHECK(map->origin().placements.empty());
  for (const MapStorey& storey : map->origin().storeys) {
    CHECK(storey.building == "building");
    const auto part = storey_of_map(*map, storey.id);
    REQUIRE(part->features().size() == once->features().size());
    for (std::size_t k = 0; k < part->features().size(); ++k) {
      CHECK(part->features()[k].id == storey.id + "/" + once->features()[k].id);
      const Point drawn = anchor_of(once->features()[k].geometry);
      CHECK((anchor_of(part->features()[k].geometry) - storey.origin - drawn).norm() < 1e-9);
      CHECK(storey_at(*map, anchor_of(part->features()[k].geometry))->id == storey.id);
    }
  }
  CHECK(find_storey(*map, "mid")->level_m == 3.5);
  CHECK(find_storey(*map, "mid")->name == "First floor");
}

TEST_CASE("lifts above each other are one lift, stairs are none, and lifts that nothing continues are told") {
  const StackedMap stacked = house();
  const auto& connections = stacked.map->origin().connections;
  REQUIRE(connections.size() == 2);
  CHECK(connections[0].type == "opal:Lift");
  CHECK(connections[0].landings.size() == 3);
  CHECK(connections[1].type == "opal:Stair");
  CHECK(connections[1].landings.size() == 2);
  const std::vector<StoreyPart> apart{{"low", "", {}, floor_with({found("l", "opal:Lift", {2, 2})})},
                                      {"top", "", {}, floor_with({found("l", "opal:Lift", {5, 2})})}};
  const StackedMap two = stacked_map("two", apart);
  CHECK(two.map->origin().connections.empty());
  REQUIRE_FALSE(two.report.empty());
  CHECK_THAT(two.report.front(), Contains("has none above or below it"));
}

TEST_CASE("a site of buildings keeps their storeys, lifts and places") {
  const auto one = house().map;
  const std::vector<StoreyPart> parts{{"north", "", {}, one}, {"south", "", {}, one}};
  const auto site = stacked_map("site", parts).map;
  REQUIRE(site->origin().storeys.size() == 6);
  CHECK(site->origin().buildings.size() == 2);
  CHECK(site->origin().connections.size() == 4);
  const MapStorey& storey = *find_storey(*site, "south/mid");
  const PlaceInBuilding place = place_in_building(*site, storey.to_map({1, 2, 0.5}));
  CHECK(place.storey == "south/mid");
  CHECK(place.building == "south/building");
  CHECK(distance_m(place.T_storey_base, Pose2(1, 2, 0.5)) < 1e-9);
}

TEST_CASE("a stack that makes no sense is refused") {
  const std::vector<StoreyPart> none,
      twice{{"a", "", {}, testing::example_map()}, {"a", "", {}, testing::example_map()}};
  CHECK_THROWS_AS(stacked_map("x", none), ConfigError);
  CHECK_THROWS_AS(stacked_map("x", twice), ConfigError);
  CHECK_THROWS_WITH(stacked_map("x", std::span(twice).first(1), StackOptions{.building = "", .gap_m = 20}),
                    Contains("expected at least 100 m"));
  CHECK_THROWS_WITH(storey_of_map(*house().map, "cellar"),
                    Contains("no storey 'cellar', expected one of 'low', 'mid'"));
}

TEST_CASE("a storey goes by its id, or by a name that only one has") {
  const auto map = house().map;
  CHECK(storey_of_map(*map, "First floor")->origin().storeys.front().id == "mid");
  const std::vector<StoreyPart> alike{{"a", "Floor", {}, testing::example_map()},
                                      {"b", "Floor", {}, testing::example_map()}};
  CHECK_THROWS_WITH(storey_of_map(*stacked_map("x", alike).map, "Floor"), Contains("expected one of 'a', 'b'"));
}

TEST_CASE("lifts of a file are told as those that were found, and one that is far from its storey is refused") {
  const TemporaryFolder folder;
  const auto lift_at = [&](double x) {
    std::ostringstream text;
    text << R"({"@context": "urn:opal:v1", "@graph": [{"@id": "freight", "@type": "StoreyConnection",
      "connection_type": "Lift", "landings": [{"@type": "Landing", "on_storey": "low", "x": 2, "y": 1},
      {"@type": "Landing", "on_storey": "top", "x": )"
         << x << R"(, "y": 1}]}]})";
    return with_connections(house(), folder.write("lifts.jsonld", text.str()));
  };
  const StackedMap connected = lift_at(2);
  CHECK(connected.map->origin().connections.size() == 3);
  CHECK(connected.report.back() == "freight: at x 2.0, y 1.0, 2 storeys");
  CHECK_THROWS_WITH(lift_at(-500),
                    Contains("lifts.jsonld: connection 'freight': a landing at x -500.0, y 1.0 of 'top'") &&
                        Contains("expected it within 25 m of what lies there"));
}
