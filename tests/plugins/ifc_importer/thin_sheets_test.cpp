// Sheets that are thinner than the gaps that are closed between parts of one wall.
#include "drawn_building.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using Catch::Contains;

TEST_CASE("sheets thinner than the gaps that are closed keep their two sides") {
  const double thickness_m = GENERATE(0.009, 0.005, 0.003);
  DrawnBuilding building;
  building.add_box("IFCPLATE", "steel sheet", {0, 0, 0.3}, 2, thickness_m);
  building.add_wall("wall", {0, 3, 0}, 4, 0.2);
  const MapImport imported = import(building);
  const auto faces = features_of(*imported.map, "steel sheet", GeometryKind::segment);
  REQUIRE(faces.size() == 2);
  for (const MapFeature* face : faces) CHECK(std::get<Segment>(face->geometry).length_m() == Approx(2).margin(0.01));
}

TEST_CASE("sheets so thin that both sides are one place bring nothing down") {
  const double thickness_m = GENERATE(0.0021, 0.002, 0.0019, 0.001, 0.0001);
  CAPTURE(thickness_m);
  DrawnBuilding building;
  building.add_box("IFCPLATE", "steel sheet", {0, 0, GENERATE(0.0, 0.3)}, 2, thickness_m);
  building.add_wall("wall", {0, 3, 0}, 4, 0.2);
  const MapImport imported = import(building);
  CHECK(features_of(*imported.map, "wall", GeometryKind::segment).size() == 4);
  const bool is_there = !features_of(*imported.map, "steel sheet", GeometryKind::segment).empty();
  if (!is_there) CHECK_THAT(element(imported, "steel sheet").reason, Contains("thinner than"));
}
