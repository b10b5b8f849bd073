#include "drawn_building.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using Catch::Contains;

namespace {

MapImport import_as_it_is(const DrawnBuilding& building, const nlohmann::json& options = nlohmann::json::object()) {
  return ifc_importer(options)->import(IfcFile(building.text()).path());
}

}  // namespace

TEST_CASE("a model without storeys is cut above its lowest wall, and the report says so") {
  DrawnBuilding building;
  building.add_wall("upper", {0, 0, 0}, 6, 0.2);
  building.add_footing("footing", {0, 5, 0}, 6, 0.2, 1.6);
  const MapImport imported = import_as_it_is(building);
  CHECK(*imported.height_m == Approx(-1.3));
  CHECK_THAT(imported.report[1], Contains("0.30 m above the lowest wall: the model has no storeys"));
  CHECK_THROWS_WITH(import_as_it_is(building, {{"storey", "Ground"}}),
                    Contains("has no storey 'Ground', expected a height (--z): the model has no storeys"));
}

TEST_CASE("a model of proxies alone is refused with what is there, and with the option that puts it in") {
  DrawnBuilding building;
  building.add_box("IFCBUILDINGELEMENTPROXY", "a", {0, 0, 0}, 6, 0.2, "$");
  building.add_box("IFCBUILDINGELEMENTPROXY", "b", {0, 5, 0}, 6, 0.2, "$");
  const auto says_it = Contains(
      "; there: 2 IfcBuildingElementProxy, left out (--set "
      "classes.IfcBuildingElementProxy=opal:Wall puts them in), expected");
  CHECK_THROWS_WITH(import_as_it_is(building), Contains("has no storeys and no walls") && says_it);
  building.add_storey("Ground", 0);
  CHECK_THROWS_WITH(import_as_it_is(building), Contains("no storey has anything solid 0.30 m above it") && says_it);
  const nlohmann::json walls{{"classes", {{"IfcBuildingElementProxy", "opal:Wall"}}}};
  CHECK(import_as_it_is(building, walls).map->objects().size() == 2);
}

TEST_CASE("a model whose things have no bodies is refused with their classes") {
  DrawnBuilding building;
  building.add_whole("IFCWALL", "wall", {});
  building.add_storey("Ground", 0);
  const IfcFile file(building.text());
  CHECK_THROWS_WITH(ifc_importer()->import(file.path()), Catch::Contains("; without a body: 1 IfcWall"));
}
