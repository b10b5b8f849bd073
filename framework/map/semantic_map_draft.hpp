#pragma once

#include <opal/map/semantic_map.hpp>

#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <vector>

namespace opal {

/// A map on its way to a SemanticMap: the parts, and where each comes from, for messages ("/@graph/3/represented_by").
struct MapDraft {
  std::string source;  ///< file or name, first word of every message
  std::string name;
  std::vector<MapObject> objects;
  std::vector<MapFeature> features;
  std::vector<MapPattern> patterns;
  MapOrigin origin = {};
  std::map<std::string, std::string> prefixes = {};
  nlohmann::json unused = nlohmann::json::array();
  std::vector<std::string> object_places = {};
  std::vector<std::string> feature_places = {};
  std::vector<std::string> pattern_places = {};

  bool has(MapObjectNumber number) const { return number.exists() && number < MapObjectNumber(objects.size()); }
  bool has(MapFeatureNumber number) const { return number.exists() && number < MapFeatureNumber(features.size()); }
  const MapObject& object(MapObjectNumber number) const { return objects[number.number()]; }
  const MapFeature& feature(MapFeatureNumber number) const { return features[number.number()]; }

  /// @throws MapError "SOURCE: PLACE: message".
  [[noreturn]] void fail(const std::string& place, const std::string& message) const;
};

/// Full IRIs and bare terms become prefixed names, missing types and point names are filled in, prefixes that have
/// no IRI get one. @throws MapError.
void name_everything(MapDraft& draft);
/// Objects, features and patterns in natural order of id, references renumbered. Expects references in range.
void sort_by_id(MapDraft& draft);
/// Natural order, in which numbers inside names count as numbers: "wall-2" before "wall-10".
OPAL_EXPORT bool id_before(const std::string& a, const std::string& b);

/// Adds nodes to `unused`; what is said of one node stands in one place, and once.
void add_unused(nlohmann::json& unused, const nlohmann::json& more);

/// Every reference points at something. @throws MapError.
void check_references(const MapDraft& draft);
/// Every id is usable and stands for one thing. @throws MapError.
void check_ids(const MapDraft& draft);
/// Points that features share, but for rounding, take the coordinates of the first feature that has them.
/// @throws MapError if they are apart.
void unify_shared_points(MapDraft& draft);
/// Every number is finite and sensible. @throws MapError.
void check_values(const MapDraft& draft);

/// Coordinates beyond this are a mistake: a wrong unit, or a georeferenced position.
inline constexpr double kFarthest_m = 1e6;
/// Two positions closer than this are one point, written with different rounding.
inline constexpr double kRounding_m = 1e-6;

/// The points that make a geometry, in the order of MapFeature::points.
OPAL_EXPORT std::vector<Point*> points_of(Geometry& geometry);
OPAL_EXPORT std::vector<Point> points_of(const Geometry& geometry);
/// What each of them is to the geometry: "begin" and "end", "point", "center".
std::vector<const char*> point_roles(const Geometry& geometry);
/// "12.5": as short as reads back exactly.
OPAL_EXPORT std::string text_of(double number);

}  // namespace opal
