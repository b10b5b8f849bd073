#include "drawn_building.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

using namespace opal;

namespace {

constexpr double kHalfTurn = std::numbers::pi;

/// A room of 6 x 4 m inside, whose walls meet end to face.
DrawnBuilding room(const Pose2& T_world_building = Pose2(), const std::string& unit = "m", double gap_m = 0) {
  DrawnBuilding building(T_world_building, unit);
  building.add_wall("south", {3, -0.1, 0}, 6.4, 0.2);
  building.add_wall("north", {3, 4.1, 0}, 6.4, 0.2);
  building.add_wall("west", {-0.1, 2, kHalfTurn / 2}, 4 - 2 * gap_m, 0.2);
  building.add_wall("east", {6.1, 2, kHalfTurn / 2}, 4 - 2 * gap_m, 0.2);
  return building;
}

const Segment& segment(const MapFeature* feature) { return std::get<Segment>(feature->geometry); }

/// Whether one of the features is this segment, in this direction.
bool has(const std::vector<const MapFeature*>& features, const Point& begin, const Point& end) {
  return std::any_of(features.begin(), features.end(), [&](const MapFeature* feature) {
    return (segment(feature).begin - begin).norm() < 1e-6 && (segment(feature).end - end).norm() < 1e-6;
  });
}

std::set<std::string> points_of(const std::vector<const MapFeature*>& features) {
  std::set<std::string> points;
  for (const MapFeature* feature : features) points.insert(feature->points.begin(), feature->points.end());
  return points;
}

}  // namespace

TEST_CASE("a room's walls are seen from inside and outside, and share their corners") {
  const MapImport imported = import(room());
  const SemanticMap& map = *imported.map;
  const auto faces = all_of(map, GeometryKind::segment);
  CHECK(faces.size() ==
        8 + 4);  // the short sides of south and north lie in line with west and east, and are others' faces
  CHECK(has(faces, {0, 0}, {6, 0}));
  CHECK(has(faces, {6, 4}, {0, 4}));
  CHECK(has(faces, {6, 0}, {6, 4}));
  CHECK(has(faces, {6.2, -0.2}, {-0.2, -0.2}));
  const auto corners = all_of(map, GeometryKind::oriented_point);
  CHECK(corners.size() == 8);
  const auto concave = std::count_if(corners.begin(), corners.end(), [](const MapFeature* corner) {
    return std::get<OrientedPoint>(corner->geometry).opening_rad < kHalfTurn;
  });
  CHECK(concave == 4);
  CHECK(points_of(faces).size() == 12);
  for (const MapFeature* corner : corners) CHECK(points_of(faces).count(corner->points.front()) == 1);
}

TEST_CASE("objects have GlobalIds as ids, and what the model says of them") {
  DrawnBuilding building = room();
  building.add_storey("Ground", 0);
  const MapImport imported = import(building);
  const auto& objects = imported.map->objects();
  REQUIRE(objects.size() == 4);
  CHECK(objects.front().id == DrawnBuilding::id("east"));
  CHECK(objects.front().type == "opal:Wall");
  CHECK(objects.front().notes.name == "east");
  CHECK(objects.front().notes.source_class == "IfcWall");
  CHECK(imported.map->origin().storey == "Ground");
  CHECK(imported.map->origin().cut_height_m == 1.0);
  CHECK(imported.height_m == 1.0);
}

TEST_CASE("walls that end less than a centimetre before others touch them") {
  const double gap_m = GENERATE(0.0, 0.001, 0.005, 0.009, -0.004);
  CAPTURE(gap_m);
  const MapImport imported = import(room(Pose2(), "m", gap_m));
  const auto faces = all_of(*imported.map, GeometryKind::segment);
  CHECK(faces.size() == 12);
  CHECK(points_of(faces).size() == 12);
  CHECK(has(faces, {0, 0}, {6, 0}));
  for (const MapFeature* face : faces) CHECK(segment(face).length_m() > 0.1);
}

TEST_CASE("a wall that ends at the middle of another leaves no phantom there") {
  DrawnBuilding building;
  building.add_wall("long", {0, 0, 0}, 10, 0.2);
  building.add_wall("stem", {1, 1.6, kHalfTurn / 2}, 3, 0.1);
  const MapImport imported = import(building);
  const auto faces = features_of(*imported.map, "long", GeometryKind::segment);
  CHECK(faces.size() == 5);
  CHECK(has(faces, {0.95, 0.1}, {-5, 0.1}) == false);
  CHECK(has(faces, {-5, 0.1}, {0.95, 0.1}));
  CHECK(has(faces, {1.05, 0.1}, {5, 0.1}));
  CHECK(has(faces, {5, -0.1}, {-5, -0.1}));
  CHECK(features_of(*imported.map, "stem", GeometryKind::segment).size() == 3);
}

TEST_CASE("a door's opening is cut from its wall, its frame is seen, its leaf is there and not looked for") {
  DrawnBuilding building;
  const int wall = building.add_wall("wall", {0, 0, 0}, 6, 0.2);
  building.add_door(wall, "door", {1, 0, 0}, 1, 0.2);
  const MapImport imported = import(building);
  const SemanticMap& map = *imported.map;
  const auto faces = features_of(map, "wall", GeometryKind::segment);
  CHECK(has(faces, {-3, 0.1}, {0.5, 0.1}));
  CHECK(has(faces, {1.5, 0.1}, {3, 0.1}));
  CHECK(has(features_of(map, "door", GeometryKind::segment), {0.55, 0.1}, {0.55, -0.1}));
  const auto leaf = features_of(map, "door", GeometryKind::segment, false);
  REQUIRE(leaf.size() == 4);
  for (const MapFeature* side : leaf) CHECK(side->sensor.empty());
  CHECK(map.origin().widest_door_m == Approx(1));
  CHECK(element(imported, "door").status == ImportStatus::imported);
  CHECK_FALSE(features_of(map, "door", GeometryKind::oriented_point).empty());
}

TEST_CASE("round columns are circles exactly, and duplicates are one object with all ids") {
  DrawnBuilding building;
  building.add_column("b-column", {1, 2}, 0.15);
  building.add_column("a-column", {1, 2}, 0.15);
  building.add_column("other", {4, 2}, 0.15);
  const MapImport imported = import(building);
  const SemanticMap& map = *imported.map;
  REQUIRE(map.objects().size() == 2);
  const auto rims = all_of(map, GeometryKind::circle);
  REQUIRE(rims.size() == 2);
  CHECK(all_of(map, GeometryKind::segment).empty());
  CHECK(std::get<Circle>(rims[0]->geometry).radius_m == Approx(0.15).margin(1e-9));
  CHECK((std::get<Circle>(rims[0]->geometry).center - Point(1, 2)).norm() < 1e-9);
  CHECK(map.objects()[0].id == DrawnBuilding::id("a-column"));
  CHECK(map.objects()[0].notes.merged_ids == std::vector<std::string>{DrawnBuilding::id("b-column")});
  CHECK(element(imported, "b-column").status == ImportStatus::merged);
  CHECK(element(imported, "b-column").circles.size() == 1);
}

TEST_CASE("a round column within a wall is no circle, and is told about") {
  DrawnBuilding building;
  building.add_wall("wall", {0, 0, 0}, 6, 0.4);
  building.add_column("column", {0, 0.1}, 0.25);
  const MapImport imported = import(building);
  CHECK(all_of(*imported.map, GeometryKind::circle).empty());
  CHECK_THAT(element(imported, "column").reason, Catch::Contains("less than half"));
}

TEST_CASE("a building that is moved rigidly gives the same map, moved") {
  const double heading_rad = GENERATE(take(8, random(-kHalfTurn, kHalfTurn)));
  const Pose2 T_world_building(GENERATE(-250.0, 3.7), 1000, heading_rad);
  CAPTURE(heading_rad);
  const auto drawn = [](const Pose2& T) {
    DrawnBuilding building = room(T);
    const int wall = building.add_wall("middle", {3, 2, kHalfTurn / 2}, 3.993, 0.15);
    building.add_door(wall, "door", {3, 1, kHalfTurn / 2}, 0.9, 0.15);
    building.add_column("column", {1.5, 2.5}, 0.2);
    building.add_box("IFCCOLUMN", "pillar", {4.5, 2.5, 0.3}, 0.4, 0.3);
    building.add_box("IFCCOLUMN", "as thin as counts", {1.5, 1, 0}, 0.1, 0.075);  // limits must not depend on rounding
    building.add_box("IFCWALL", "step", {3.125, 3.5, 0}, 0.1, 0.1);
    return import(building);
  };
  const MapImport still = drawn(Pose2()), moved = drawn(T_world_building);
  REQUIRE(moved.map->features().size() == still.map->features().size());
  for (std::size_t k = 0; k < still.map->features().size(); ++k) {
    const MapFeature &a = still.map->features()[k], &b = moved.map->features()[k];
    CAPTURE(a.id);
    CHECK(a.id == b.id);
    CHECK(a.points == b.points);
    CHECK(a.sensor == b.sensor);
    REQUIRE(kind_of(a.geometry) == kind_of(b.geometry));
    const Geometry expected = transformed(T_world_building, a.geometry);
    CHECK((anchor_of(expected) - anchor_of(b.geometry)).norm() < 1e-5);
    if (const auto* s = std::get_if<Segment>(&expected)) CHECK((s->begin - segment(&b).begin).norm() < 1e-5);
    if (const auto* c = std::get_if<OrientedPoint>(&expected))
      CHECK(std::abs(wrap_angle(c->heading_rad - std::get<OrientedPoint>(b.geometry).heading_rad)) < 1e-4);
  }
  CHECK(moved.map->objects().size() == still.map->objects().size());
}

TEST_CASE("lengths come in the unit that the project assigns") {
  const std::string unit = GENERATE("m", "mm", "ft");
  const MapImport imported = import(room(Pose2(), unit));
  CHECK(has(all_of(*imported.map, GeometryKind::segment), {0, 0}, {6, 0}));
}

TEST_CASE("furniture and proxies stay out unless the classes say otherwise, and the report names them") {
  DrawnBuilding building = room();
  building.add_box("IFCFURNITURE", "desk", {2, 2, 0}, 1, 0.6);
  building.add_box("IFCBUILDINGELEMENTPROXY", "thing", {4, 2, 0}, 1, 0.6);
  const MapImport usual = import(building);
  CHECK(usual.map->objects().size() == 4);
  CHECK(element(usual, "desk").status == ImportStatus::left_out);
  CHECK(element(usual, "desk").outline.size() == 4);
  CHECK(element(usual, "desk").reason == "furniture is moved");
  const MapImport chosen =
      import(building, {{"classes", {{"IfcFurnishingElement", "opal:Desk"}, {"IfcWall", "leave_out"}}}});
  REQUIRE(chosen.map->objects().size() == 1);
  CHECK(chosen.map->objects()[0].type == "opal:Desk");
  CHECK(element(chosen, "south").status == ImportStatus::left_out);
  CHECK_THROWS_WITH(ifc_importer({{"classes", {{"IfcWall", "omit"}}}}),
                    Catch::Contains("IfcWall") && Catch::Contains("leave_out"));
}

TEST_CASE("glass is there and no LiDAR looks for it; mullions are seen") {
  DrawnBuilding building = room();
  building.add_box("IFCPLATE", "glazed panel", {3, 2, 0}, 2, 0.02, "$");
  building.add_box("IFCMEMBER", "mullion", {4.05, 2, 0}, 0.1, 0.1, "$");
  const MapImport imported = import(building);
  CHECK(features_of(*imported.map, "glazed panel", GeometryKind::segment).empty());
  CHECK(features_of(*imported.map, "glazed panel", GeometryKind::segment, false).size() == 4);
  CHECK(features_of(*imported.map, "mullion", GeometryKind::segment).size() == 4);
}

TEST_CASE("parts of a wall are the wall") {
  DrawnBuilding building;
  const int a = building.add_box("IFCBUILDINGELEMENTPART", "layer a", {0, 0, 0}, 4, 0.1);
  const int b = building.add_box("IFCBUILDINGELEMENTPART", "layer b", {0, 0.1, 0}, 4, 0.1);
  building.add_whole("IFCWALL", "wall", {a, b});
  const MapImport imported = import(building);
  REQUIRE(imported.map->objects().size() == 1);
  CHECK(imported.map->objects()[0].id == DrawnBuilding::id("wall"));
  CHECK(all_of(*imported.map, GeometryKind::segment).size() == 4);
  CHECK(element(imported, "layer a").reason == "part of " + DrawnBuilding::id("wall"));
  CHECK(element(imported, "wall").status == ImportStatus::imported);
}

TEST_CASE("storeys are listed from the lowest, chosen by name, and the lowest with walls is the default") {
  DrawnBuilding building = room();
  building.add_storey("Roof", 3.2);
  building.add_storey("Ground", 0);
  building.add_storey("Foundation", -1.5);
  const IfcFile file(building.text());
  const std::vector<Storey> storeys = ifc_importer()->storeys(file.path());
  REQUIRE(storeys.size() == 3);
  CHECK(storeys[0].name == "Foundation");
  CHECK(storeys[1].elevation_m == Approx(0));
  CHECK(storeys[1].height_m == Approx(0.3));
  CHECK(storeys[1].gives == std::map<std::string, int>{{"IfcWall", 4}});
  CHECK(storeys[0].gives.empty());
  const MapImport usual = ifc_importer()->import(file.path());
  CHECK(*usual.height_m == Approx(0.3));
  CHECK_THAT(usual.report[1], Catch::Contains("lowest storey with walls"));
  CHECK(*ifc_importer({{"storey", "Ground"}, {"sensor_height_m", 0.5}})->import(file.path()).height_m == Approx(0.5));
  CHECK_THROWS_WITH(ifc_importer({{"storey", "Attic"}})->import(file.path()),
                    file.path() + ": has no storey 'Attic', expected one of 'Foundation', 'Ground', 'Roof'");
  CHECK_THROWS_WITH(ifc_importer({{"storey", "Roof"}})->import(file.path()),
                    Catch::Contains("nothing of the building is there"));
}

TEST_CASE("a foundation has walls and no doors: the lowest storey that has both is the default") {
  DrawnBuilding building = room();
  const int wall = building.add_wall("middle", {3, 2, kHalfTurn / 2}, 4, 0.15);
  building.add_door(wall, "door", {3, 1, kHalfTurn / 2}, 0.9, 0.15);
  building.add_footing("footing", {3, -0.1, 0}, 6.4, 0.2, 1.6);
  building.add_storey("Ground", 0);
  building.add_storey("Foundation", -1.5);
  const MapImport usual = ifc_importer()->import(IfcFile(building.text()).path());
  CHECK(*usual.height_m == Approx(0.3));
  CHECK_THAT(usual.report[1], Catch::Contains("'Ground', the lowest storey with walls and doors"));
}

TEST_CASE("what the model says survives writing and reading") {
  DrawnBuilding building = room();
  const int wall = building.add_wall("middle", {3, 2, kHalfTurn / 2}, 4, 0.15);
  building.add_door(wall, "door", {3, 1, kHalfTurn / 2}, 0.9, 0.15);
  building.add_column("column", {1.5, 2.5}, 0.2);
  building.add_column("column again", {1.5, 2.5}, 0.2);
  building.add_storey("Ground", 0);
  const auto map = import(building).map;
  const auto again = SemanticMap::parse(map->to_json_ld().dump(), "again");
  REQUIRE(again->objects().size() == map->objects().size());
  for (std::size_t k = 0; k < map->objects().size(); ++k) {
    const ObjectNotes &a = map->objects()[k].notes, &b = again->objects()[k].notes;
    CHECK(a.name == b.name);
    CHECK(a.source_class == b.source_class);
    CHECK(a.width_m == b.width_m);
    CHECK(a.merged_ids == b.merged_ids);
  }
  CHECK(again->origin().storey == "Ground");
  CHECK(again->origin().cut_height_m == 1.0);
  CHECK(again->origin().widest_door_m == map->origin().widest_door_m);
  CHECK(again->to_json_ld() == map->to_json_ld());
  CHECK(again->unused().empty());
}
