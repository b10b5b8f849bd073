// Models that are right for the most part: letters beyond ASCII as they are, national coordinates, no bodies.
#include "drawn_building.hpp"

#include "tests/kit/import_report.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

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
