#include "drawn_building.hpp"

#include "tests/kit/import_report.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace opal;

namespace {

struct Layer {
  std::string material;
  double thickness_m;
};

std::string in_brackets(const std::vector<int>& numbers) {
  std::string list;
  for (const int number : numbers) list += (list.empty() ? "" : ",") + ref(number);
  return "(" + list + ")";
}

/// A building of one wall, and of one that has a name and layers.
MapImport with_wall(const std::string& name, const std::vector<Layer>& layers = {}) {
  DrawnBuilding building;
  building.add_wall("plain", {0, 5, 0}, 6, 0.2);
  const int wall = building.add_wall(name, {0, 0, 0}, 6, 0.2);
  std::vector<int> numbers;
  for (const Layer& layer : layers) {
    const int material = building.add("IFCMATERIAL", "'" + layer.material + "',$,$");
    numbers.push_back(
        building.add("IFCMATERIALLAYER", ref(material) + "," + std::to_string(layer.thickness_m) + ",$,$,$,$,$"));
  }
  if (!layers.empty())
    building.add("IFCRELASSOCIATESMATERIAL",
                 "'association',$,$,$,(" + ref(wall) + ")," +
                     ref(building.add("IFCMATERIALLAYERSET", in_brackets(numbers) + ",'layers',$")));
  return import(building);
}

bool is_seen(const MapImport& imported, const std::string& name) {
  return !features_of(*imported.map, name, GeometryKind::segment).empty();
}

}  // namespace

TEST_CASE("walls whose names only sound like glass are seen") {
  const std::string name =
      GENERATE("Partition with Glass Wool 100", "Glaswolle", "Mauerwerk (Glasfasertapete)", "Douglas Fir",
               "Glazed brick", "Fiberglass panel", "Glasgow stone", "laine de verre", "Steel frame");
  CAPTURE(name);
  CHECK(is_seen(with_wall(name), name));
}

TEST_CASE("walls whose names speak of glass are there, no LiDAR looks for them, and the report counts them") {
  const std::string name = GENERATE("Glass partition", "Glaswand", "Isolierglas 24", "Festverglasung", "Glazed screen",
                                    "mur en verre", "double-vitrage");
  CAPTURE(name);
  const MapImport imported = with_wall(name);
  CHECK_FALSE(is_seen(imported, name));
  CHECK(features_of(*imported.map, name, GeometryKind::segment, false).size() == 4);
  CHECK(says(imported, "not perceivable: 1 IfcWall, glass, by its name or material: " + DrawnBuilding::id(name)));
}

TEST_CASE("a wall of layers is glass if most of it is, without its air") {
  CHECK(is_seen(with_wall("wall", {{"Gypsum board", 0.0125}, {"Glasswool", 0.11}, {"Gypsum board", 0.0125}}), "wall"));
  CHECK(is_seen(with_wall("wall", {{"Brick", 0.115}, {"Ceramic tile, glazed", 0.02}}), "wall"));
  CHECK(is_seen(with_wall("wall", {{"Concrete", 0.2}, {"Glass", 0.008}}), "wall"));
  CHECK_FALSE(is_seen(with_wall("wall", {{"Glass, clear", 0.008}, {"Air", 0.016}, {"Glass, clear", 0.006}}), "wall"));
}
