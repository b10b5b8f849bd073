#include <opal/common/error.hpp>
#include <opal/map/semantic_map.hpp>
#include "map/check/map_diff.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using Catch::Contains;
using nlohmann::json;

namespace {

json wall(const std::string& id, double x, double y) {
  const auto point = [](double px, double py) { return json{{"@type", "Point"}, {"x", px}, {"y", py}}; };
  return {{"@id", id},
          {"@type", "Wall"},
          {"represented_by",
           {{"@type", "ObjectFeatureRepresentation"},
            {"perceivable_by", {{"@id", "lidar"}}},
            {"represented_by",
             {{"@id", id + "/face"}, {"@type", "LineSegment"}, {"begin", point(x, y)}, {"end", point(x + 10, y)}}}}}};
}

json storey(const std::string& id, double x, double y) {
  return {{"@id", id}, {"@type", "Storey"}, {"name", "Storey " + id}, {"x", x}, {"y", y}};
}

json landing(const std::string& on, double x, double y) {
  return {{"@type", "Landing"}, {"on_storey", on}, {"x", x}, {"y", y}};
}

json lift(const json& landings) {
  return {{"@id", "lift"}, {"@type", "StoreyConnection"}, {"connection_type", "Lift"}, {"landings", landings}};
}

/// Two storeys, 200 m apart, and a lift.
std::vector<json> two_storeys() {
  return {{{"@id", "house"}, {"@type", "Building"}, {"name", "The house"}, {"has_storey", {"a", "b"}}},
          storey("a", 0, 0),
          storey("b", 200, 50),
          lift({landing("a", 2, 1), landing("b", 3, 1)}),
          wall("a/wall", 0, 0),
          wall("b/wall", 200, 50)};
}

std::shared_ptr<const SemanticMap> parsed(const std::vector<json>& nodes) {
  return SemanticMap::parse(json{{"@context", "urn:opal:v1"}, {"@graph", nodes}}.dump(), "house.jsonld");
}

std::shared_ptr<const SemanticMap> with_another(json node) {
  std::vector<json> nodes = two_storeys();
  nodes.push_back(std::move(node));
  return parsed(nodes);
}

}  // namespace

TEST_CASE("a map tells on which storey of which building a pose lies, and where in the storey's own frame") {
  const auto map = parsed(two_storeys());
  const PlaceInBuilding place = place_in_building(*map, Pose2(204, 51, 0.3));
  CHECK(place.building == "house");
  CHECK(place.storey == "b");
  CHECK(distance_m(place.T_storey_base, Pose2(4, 1, 0.3)) < 1e-12);
  CHECK(words_for(*map, place) == "Storey b of The house");
  CHECK(storey_at(*map, {90, 0})->id == "a");  // outside, and nearer to a
  const MapConnection& lift = map->origin().connections.front();
  CHECK(lift.type == "opal:Lift");
  CHECK(distance_m(landing_on_map(*map, lift.landings[1]), Pose2(203, 51, 0)) < 1e-12);
}

TEST_CASE("a map without storeys names none, and its poses stay as they are") {
  const auto map = parsed({wall("wall", 0, 0)});
  CHECK(storey_at(*map, {1, 1}) == nullptr);
  const PlaceInBuilding place = place_in_building(*map, Pose2(1, 2, 3));
  CHECK(place.storey.empty());
  CHECK(distance_m(place.T_storey_base, Pose2(1, 2, 3)) < 1e-12);
  CHECK(words_for(*map, place).empty());
}

TEST_CASE("storeys and connections are written and read again") {
  const auto map = parsed(two_storeys());
  const auto again = SemanticMap::parse(map->to_json_ld().dump(), "again");
  CHECK(again->to_json_ld() == map->to_json_ld());
  CHECK(map_diff(*map, *again).empty());
  CHECK(map->unused().empty());
}

TEST_CASE("a storey that has moved, and a lift that is gone, are differences of maps") {
  const auto map = parsed(two_storeys());
  std::vector<json> nodes = two_storeys();
  nodes[2]["x"] = 199;
  nodes.erase(nodes.begin() + 3);
  CHECK(map_diff(*map, *parsed(nodes)).changes.size() == 2);
}

TEST_CASE("storeys of other documents, which have no place in the map, are kept and not used") {
  const auto map = parsed({{{"@id", "ground"}, {"@type", "Storey"}},
                           {{"@id", "house"}, {"@type", "Building"}, {"has_storey", {"ground"}}},
                           wall("wall", 0, 0)});
  CHECK(map->origin().storeys.empty());
  CHECK(map->origin().buildings.empty());
  CHECK(map->unused().size() == 2);
}

TEST_CASE("a map whose storeys make no sense is refused, and the message says where") {
  std::vector<json> near = two_storeys();
  near[2]["x"] = 60;
  near[5] = wall("b/wall", 60, 0);
  CHECK_THROWS_WITH(parsed(near), Contains("house.jsonld: storey 'b': its sheet is 50.0 m from that of 'a'"));

  CHECK_THROWS_WITH(with_another({{"@id", "c"}, {"@type", "Storey"}}), Contains("Storey 'c' has no x"));
  CHECK_THROWS_WITH(with_another(storey("c", 500, 0)), Contains("storey 'c': nothing lies on it"));
  CHECK_THROWS_WITH(with_another(wall("far", 1000, 1000)), Contains("feature 'far/face' lies on no storey"));
  CHECK_THROWS_WITH(with_another({{"@id", "other"}, {"@type", "Building"}, {"has_storey", {"a"}}}),
                    Contains("expected one building"));

  std::vector<json> unknown = two_storeys();
  unknown[3] = lift({landing("a", 0, 0), landing("z", 0, 0)});
  CHECK_THROWS_WITH(parsed(unknown), Contains("connection 'lift': a landing on storey 'z', expected one of 'a', 'b'"));
  unknown[3] = lift({landing("a", 0, 0), landing("a", 5, 0)});
  CHECK_THROWS_WITH(parsed(unknown), Contains("two landings on storey 'a'"));
  unknown[3] = lift(json::array());
  CHECK_THROWS_WITH(parsed(unknown), Contains("has no landings"));
  unknown[3] = lift({landing("a", 0, 0), landing("b", 0, 0)});
  unknown[3]["radius_m"] = -1;
  CHECK_THROWS_WITH(parsed(unknown), Contains("radius_m -1.0, expected a positive number"));
  CHECK_THROWS_WITH(parsed({lift({landing("a", 0, 0)}), wall("wall", 0, 0)}),
                    Contains("expected no storey, for the map holds none"));
}

TEST_CASE("what an overlay adds near a storey lies on it, whatever its name") {
  const auto map = with_another(wall("learned", 205, 55));
  CHECK(storey_at(*map, {206, 55})->id == "b");
}
