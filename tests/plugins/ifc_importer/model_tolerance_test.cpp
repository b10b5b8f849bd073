// Names, coordinates and things without a body, also in models that are right for the most part only.
#include "drawn_building.hpp"

#include "tests/kit/import_report.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace opal;
using Catch::Contains;

TEST_CASE("names in UTF-8, and in ISO 8859-1, are read as they are written") {
  DrawnBuilding unicode, latin;
  unicode.add_wall("Wänd 壁 \xF0\x9F\x98\x80", {0, 0, 0}, 4, 0.2);
  latin.add_wall("W\xE4nd", {0, 0, 0}, 4, 0.2);
  CHECK(import(unicode).map->objects().front().notes.name == "Wänd 壁 \xF0\x9F\x98\x80");
  CHECK(import(latin).map->objects().front().notes.name == "Wänd");
}

TEST_CASE("a model in a national grid gets an origin near it") {
  const auto draw = [](const Pose2& place) {
    DrawnBuilding building(place);
    building.add_storey("EG", 0);
    building.add_wall("wall", {2, 0.1, 0}, 4, 0.2);
    return import(building);
  };
  const MapImport far = draw({412345, 5654321, 0}), near = draw({345, 321, 0});
  CHECK(says(far, "the map's origin is at 412000, 5654000 m of the plan"));
  REQUIRE(far.map->features().size() == near.map->features().size());
  for (std::size_t k = 0; k < near.map->features().size(); ++k)
    CHECK((anchor_of(far.map->features()[k].geometry) - anchor_of(near.map->features()[k].geometry)).norm() < 1e-5);
}

TEST_CASE("a model of which nothing can be read says why") {
  DrawnBuilding building;
  building.add_storey("EG", 0);
  const int origin = building.add("IFCCARTESIANPOINT", "(0.,0.,0.)");
  const int axes = building.add("IFCAXIS2PLACEMENT3D", ref(origin) + ",$,$");
  building.add_item("IFCWALL", "ball", building.add("IFCSPHERE", ref(axes) + ",1."));
  const auto importer = ifc_importer(nlohmann::json::object());
  CHECK_THROWS_WITH(
      importer->import(IfcFile(building.text()).path()),
      Contains("cannot be read: 1 things, the first is IfcWall " + DrawnBuilding::id("ball")) && Contains("IfcSphere"));
}

TEST_CASE("names are decoded as STEP encodes them") {
  DrawnBuilding building;
  building.add_wall("W\\X2\\00E4\\X0\\nd \\X\\E9 \\S\\d \\X4\\0001F600\\X0\\ it''s", {0, 0, 0}, 4, 0.2);
  const MapImport imported = import(building);
  REQUIRE(imported.map->objects().size() == 1);
  CHECK(imported.map->objects()[0].notes.name == "Wänd é ä \xF0\x9F\x98\x80 it's");
}

TEST_CASE("a map conversion is in the unit of its map") {
  const std::string map_unit = GENERATE("metre", "none", "millimetre");
  CAPTURE(map_unit);
  DrawnBuilding building(Pose2(), "mm");
  building.add_wall("wall", {0, 0, 0}, 4, 0.2);
  const std::string prefix = map_unit == "metre" ? "$" : ".MILLI.";
  const int unit = building.add("IFCSIUNIT", "*,.LENGTHUNIT.," + prefix + ",.METRE.");
  const int crs = building.add("IFCPROJECTEDCRS", "'EPSG:28992',$,$,$,$,$," + (map_unit == "none" ? "$" : ref(unit)));
  const std::string place = map_unit == "metre" ? "155000.,463000.,3.5" : "155000000.,463000000.,3500.";
  building.add("IFCMAPCONVERSION", ref(building.context()) + "," + ref(crs) + "," + place + ",0.8,0.6,$");
  const auto georeference = import(building).map->origin().georeference;
  REQUIRE(georeference);
  CHECK(georeference->crs == "EPSG:28992");
  CHECK(georeference->eastings_m == Approx(155000));
  CHECK(georeference->northings_m == Approx(463000));
  CHECK(georeference->height_m == Approx(3.5));
  CHECK(georeference->heading_rad == Approx(std::atan2(0.6, 0.8)));
}

TEST_CASE("a building in national coordinates comes in, and may be moved near to its origin") {
  const Pose2 T_grid_building(412000.25, 5654000.5, 0.3);  // UTM
  DrawnBuilding building(T_grid_building, "mm");
  building.add_wall("wall", {0, 0, 0}, 4, 0.2);
  building.add_wall("stem", {0, 1.1, std::numbers::pi / 2}, 2, 0.2);
  CHECK_THROWS_WITH(import(building, {{"origin_x_m", 1}}), Contains("origin_x_m") && Contains("wall"));
  const MapImport imported = import(building, {{"origin_x_m", 412000}, {"origin_y_m", 5654000}});
  REQUIRE(element(imported, "wall").status == ImportStatus::imported);
  const MapImport near = [] {
    DrawnBuilding same(Pose2(0.25, 0.5, 0.3), "mm");
    same.add_wall("wall", {0, 0, 0}, 4, 0.2);
    same.add_wall("stem", {0, 1.1, std::numbers::pi / 2}, 2, 0.2);
    return import(same);
  }();
  REQUIRE(imported.map->features().size() == near.map->features().size());
  for (std::size_t k = 0; k < near.map->features().size(); ++k)
    CHECK((anchor_of(imported.map->features()[k].geometry) - anchor_of(near.map->features()[k].geometry)).norm() <
          1e-5);
}

TEST_CASE("a solid thing without a body is told by name, and so is why nothing came in") {
  DrawnBuilding building;
  building.add_wall("wall", {0, 0, 0}, 4, 0.2);
  building.add_whole("IFCWALL", "bodiless", {});
  const MapImport imported = import(building);
  CHECK(element(imported, "bodiless").status == ImportStatus::unreadable);
  CHECK(element(imported, "bodiless").reason == "it has no body, and no parts that have one");
  CHECK(says(imported,
             "cannot be read: IfcWall, it has no body, and no parts that have one: " + DrawnBuilding::id("bodiless")));
  DrawnBuilding unreadable;
  const int origin = unreadable.add("IFCCARTESIANPOINT", "(0.,0.,0.)");
  const int axes = unreadable.add("IFCAXIS2PLACEMENT3D", ref(origin) + ",$,$");
  unreadable.add_item("IFCWALL", "ball", unreadable.add("IFCSPHERE", ref(axes) + ",1."));
  CHECK_THROWS_WITH(import(unreadable), Contains("nothing of the building is there") && Contains("IfcSphere") &&
                                            Contains(DrawnBuilding::id("ball")));
}
