#include "every_building.hpp"

#include <opal/plugin/plugin_registry.hpp>
#include "patterns/pattern_layer.hpp"

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

using namespace opal;
using namespace opal::simulation;

namespace {

std::string text_of_file(const std::string& path) {
  std::ifstream file(path);
  REQUIRE(file);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

int count_corners(const SemanticMap& map, bool concave) {
  int count = 0;
  for (const MapFeature& feature : map.features())
    if (const auto* corner = std::get_if<OrientedPoint>(&feature.geometry))
      count += (corner->opening_rad < std::numbers::pi) == concave;
  return count;
}

int count_circles(const SemanticMap& map) {
  return check_map(map).features_by_geometry[static_cast<std::size_t>(GeometryKind::circle)];
}

Point extent_of(const SemanticMap& map) {
  const MapCheck check = check_map(map);
  return check.bounds[1] - check.bounds[0];
}

PatternLayer binary_layer(const std::shared_ptr<const SemanticMap>& map, double size_m) {
  PluginRegistry registry;
  registry.load(OPAL_PLUGIN_DIR "/column_pair.so");
  const std::vector<Named<PatternTemplate>> templates{
      {"opal:ColumnPair", registry.make<PatternTemplate>("opal:ColumnPair")}};
  return find_pattern_layer(MapView(map, "PlanarLidar2D"), templates, {size_m});
}

}  // namespace

TEST_CASE("the buildings in maps/ are those that the generator makes") {
  for (const std::string name : {"atlas", "gemini"})
    CHECK(text_of_file(OPAL_SOURCE_DIR "/maps/" + name + ".jsonld") == document_of(*generate_building({name}).map));
}

TEST_CASE("atlas is 20 x 41 m with 154 concave corners and no round column") {
  const auto map = generate_building({"atlas"}).map;
  CHECK(extent_of(*map).isApprox(Point(20, 41)));
  CHECK(count_corners(*map, true) == 154);
  CHECK(count_circles(*map) == 0);
}

TEST_CASE("gemini is 70 x 17 m with 17 pairs of columns along x and 9 along y") {
  const auto map = generate_building({"gemini"}).map;
  CHECK(extent_of(*map).isApprox(Point(70, 17)));
  for (const MapFeature& feature : map->features())
    if (const auto* circle = std::get_if<Circle>(&feature.geometry)) CHECK(circle->radius_m == 0.33);
  const PatternLayer layer = binary_layer(map, 8);
  int along_x = 0, along_y = 0;
  for (const MapPattern& pattern : layer.patterns) {
    const Point way =
        anchor_of(map->feature(pattern.features[0]).geometry) - anchor_of(map->feature(pattern.features[1]).geometry);
    along_x += std::abs(std::abs(way.x()) - 7.4) < 1e-9 && std::abs(way.y()) < 1e-9;
    along_y += std::abs(std::abs(way.y()) - 6.2) < 1e-9 && std::abs(way.x()) < 1e-9;
  }
  CHECK(along_x == 17);
  CHECK(along_y == 9);
  CHECK(layer.patterns.size() == 26);
}
