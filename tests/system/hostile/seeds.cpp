#include "seeds.hpp"

#include "tests/kit/file_content.hpp"
#include "tests/plugins/ifc_importer/drawn_building.hpp"
#include "tests/plugins/plan_importers/dxf_text.hpp"

#include <opal/map/semantic_map.hpp>

#include <filesystem>

namespace {

/// Every kind of entity, with blocks inside blocks, in a few lines.
std::string tiny_drawing() {
  DxfText dxf(6);
  dxf.layer("A-WALL", 0, 7).begin_block("POST").circle("0", {0, 0}, 0.2).end_block();
  dxf.begin_block("PAIR").insert("0", "POST", {0, 0}).insert("0", "POST", {2, 0}).end_block();
  dxf.box("A-WALL", 0, 0, 10, 0.2).line("A-WALL", {0, 0.2}, {0, 5}).arc("A-WALL", {5, 5}, 2, 0, 90);
  dxf.polyline("A-WALL", {{0, 8}, {3, 8}, {3, 9}}, false, {0.3, 0}).insert("S-COLS", "PAIR", {2, 3}, 1, -1, 30);
  dxf.insert("S-COLS", "POST", {5, 3}).pair(70, 2).pair(71, 2).pair(44, 1).pair(45, 1.5);
  dxf.entity("SOLID", "S-COLS").point(10, {8, 2}).point(11, {8.3, 2}).point(12, {8, 2.3}).point(13, {8.3, 2.3});
  dxf.entity("HATCH", "A-WALL")
      .point(10, {0, 0})
      .pair(2, std::string("SOLID"))
      .pair(70, 1)
      .pair(71, 0)
      .pair(91, 1)
      .pair(92, 3)
      .pair(72, 0)
      .pair(73, 1)
      .pair(93, 3);
  for (const opal::Point& p : {opal::Point(1, 6), opal::Point(2, 6), opal::Point(1, 7)}) dxf.point(10, p);
  dxf.pair(97, 0).pair(75, 0).pair(76, 1).pair(98, 0);
  dxf.entity("POLYLINE", "A-WALL").pair(66, 1).pair(70, 1);
  for (const opal::Point& p : {opal::Point(6, 6), opal::Point(9, 6), opal::Point(9, 6.2)})
    dxf.entity("VERTEX", "A-WALL").point(10, p);
  dxf.entity("SEQEND", "A-WALL");
  dxf.ellipse("A-WALL", {3, 12}, {2, 0}, 0.5, 0, 3).mline("A-WALL", {0, 15}, {5, 15}, 0.1);
  dxf.spline("A-WALL", 3, {0, 0, 0, 0, 1, 1, 1, 1}, {{10, 0}, {11, 1}, {13, 1}, {14, 0}}, {1, 2, 1, 1});
  dxf.entity("TEXT", "A-ANNO").point(10, {1, 3}).pair(40, 0.25).pair(1, std::string("Room"));
  return dxf.text();
}

std::string drawn_building() {
  opal::DrawnBuilding building;
  const int south = building.add_wall("south", {3, -0.1, 0}, 6.4, 0.2);
  building.add_wall("north", {3, 4.1, 0}, 6.4, 0.2);
  building.add_wall("west", {-0.1, 2, std::numbers::pi / 2}, 4, 0.2);
  building.add_wall("east", {6.1, 2, std::numbers::pi / 2}, 4, 0.2);
  building.add_door(south, "door", {2, -0.1, 0}, 1, 0.2);
  building.add_column("column", {4, 2}, 0.2);
  building.add_storey("Ground", 0);
  return building.text();
}

}  // namespace

std::vector<std::string> dxf_seeds() { return {tiny_drawing(), tiny_drawing(), small_office()}; }

std::vector<std::string> geojson_seeds() {
  return {R"({ "type": "FeatureCollection", "name": "flat", "features": [
  { "type": "Feature", "id": "shell", "properties": { "indoor": "wall", "level": "0" },
    "geometry": { "type": "Polygon", "coordinates": [
      [[0, 0], [12, 0], [12, 8], [0, 8], [0, 0]],
      [[0.3, 0.3], [0.3, 7.7], [11.7, 7.7], [11.7, 0.3], [0.3, 0.3]]] } },
  { "type": "Feature", "id": "screen", "properties": { "class": "wall", "level": 0 },
    "geometry": { "type": "LineString", "coordinates": [[4, 0.3], [4, 3.5], [6.25, 3.5]] } },
  { "type": "Feature", "id": 17, "properties": { "class": "column", "radius_m": 0.2 },
    "geometry": { "type": "Point", "coordinates": [8.5, 4.0, 1.5] } },
  { "type": "Feature", "id": "posts", "properties": { "class": "pillar", "level": "0" },
    "geometry": { "type": "MultiPolygon", "coordinates": [
      [[[9, 2], [9.4, 2], [9.4, 2.4], [9, 2.4], [9, 2]]], [[[9, 6], [9.4, 6], [9.4, 6.4], [9, 6.4], [9, 6]]]] } },
  { "type": "Feature", "id": "parts", "properties": { "class": "door" },
    "geometry": { "type": "GeometryCollection", "geometries": [
      { "type": "LineString", "coordinates": [[1, 0], [2, 0]] },
      { "type": "MultiLineString", "coordinates": [[[1, 0], [1, 1]], [[2, 0], [2, 1]]] }] } },
  { "type": "Feature", "id": "room", "properties": { "indoor": "room", "name": "Küche" }, "geometry": null }
] })"};
}

std::vector<std::string> map_seeds() {
  const std::string room = opal::content_of(OPAL_SOURCE_DIR "/maps/example_room.jsonld");
  return {room, opal::SemanticMap::parse(room, "room")->to_json_ld().dump(1)};
}

std::vector<std::string> ifc_seeds() {
  std::vector<std::string> seeds{drawn_building()};
  for (const char* name : {"simple_room_v6.ifc", "grid-placement_4x3.ifc"}) {
    const std::string path = std::string(OPAL_SOURCE_DIR "/../shared/data/ifc/") + name;
    if (std::filesystem::exists(path)) seeds.push_back(opal::content_of(path));
  }
  return seeds;
}
