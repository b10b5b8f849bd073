#include "connections.hpp"

#include "level.hpp"

#include <opal/import_kit/shaft_extent.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <set>

namespace opal::geojson_importer {
namespace {

constexpr std::array kKeys{"type", "highway", "room", "category", "indoor", "class", "kind", "element", "feature_type"};
constexpr std::array kLifts{"elevator", "lift"};
constexpr std::array kStairs{"stairs", "staircase", "stairwell"};
constexpr double kUsualRadius_m = 1.0;

template <std::size_t N>
bool says_any(const Feature& feature, const std::array<const char*, N>& words) {
  return std::any_of(kKeys.begin(), kKeys.end(), [&](const char* key) {
    const std::string text = text_or_number(feature, key);
    return std::find(words.begin(), words.end(), text) != words.end();
  });
}

std::string type_of(const Feature& feature) {
  if (says_any(feature, kLifts)) return "opal:Lift";
  return says_any(feature, kStairs) || text_or_number(feature, "stairs") == "yes" ? "opal:Stair" : "";
}

std::optional<ShaftExtent> extent_of(const Feature& feature, const std::string& type) {
  const Shapes& shapes = feature.shapes;
  if (shapes.polygons.empty()) {
    if (type != "opal:Lift" || shapes.points.size() != 1) return std::nullopt;
    return ShaftExtent{shapes.points.front(), kUsualRadius_m};
  }
  return shapes.polygons.front().empty() ? std::nullopt : shaft_extent(shapes.polygons.front().front());
}

}  // namespace

std::vector<MapConnection> connections_of(const FeatureCollection& collection, const std::string& level) {
  std::vector<MapConnection> connections;
  std::set<std::string> met;
  for (const Feature& feature : collection.features) {
    const std::string type = type_of(feature);
    if (type.empty() || !feature.damage.empty() || !(level.empty() || is_on_level(feature, level))) continue;
    const std::optional<ShaftExtent> extent = extent_of(feature, type);
    if (!extent || !met.insert(feature.id).second) continue;
    const std::string id = feature.id + (type == "opal:Lift" ? "/lift" : "/stairs");
    connections.push_back(
        {id, type, text_or_number(feature, "ref"), extent->radius_m, {{"", Pose2(extent->middle, 0)}}});
  }
  return connections;
}

}  // namespace opal::geojson_importer
