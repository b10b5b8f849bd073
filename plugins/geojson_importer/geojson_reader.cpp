#include "geojson_reader.hpp"

#include "file_kind.hpp"
#include "lenient_json.hpp"
#include "osm_reader.hpp"

#include <opal/common/error.hpp>
#include <opal/common/letter_case.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

namespace opal::geojson_importer {
namespace {

using nlohmann::json;

constexpr std::size_t kShownCharacters = 60;

std::string shown(const json& value) {
  const std::string text = value.dump();
  return text.size() > kShownCharacters ? text.substr(0, kShownCharacters) + "..." : text;
}

/// Names are compared very often: most differ in length.
bool is_same_name(const std::string& a, const std::string& b) {
  return a.size() == b.size() && lower_case_letters(a) == lower_case_letters(b);
}

class Reader {
 public:
  explicit Reader(const std::string& path) : path_(path) {}

  FeatureCollection run() {
    json all = document();
    if (all.is_array()) all = {{"type", "FeatureCollection"}, {"features", std::move(all)}};
    if (all.is_object() && !all.contains("type") && all.contains("geometryType"))
      fail("", "JSON of ArcGIS", "GeoJSON (f=geojson in its address)");
    const std::string type = type_of(all, "", "FeatureCollection or Feature");
    FeatureCollection collection;
    collection.crs = crs_of(all);
    if (all.contains("name") && all.at("name").is_string()) collection.name = all.at("name");
    if (type == "Feature") {
      collection.features.push_back(feature_of(all, "", 0));
      collection.notes = std::move(notes_);
      return collection;
    }
    if (type != "FeatureCollection") fail("/type", shown(all.at("type")), "FeatureCollection or Feature");
    (void)list(all, "features", "");
    json& features = all.at("features");
    for (std::size_t k = 0; k < features.size(); ++k)
      collection.features.push_back(feature_of(features[k], "/features/" + std::to_string(k), k));
    if (repeated_ids_ > 0)
      notes_.push_back(fmt::format("features whose id another one has, and that have another now: {}", repeated_ids_));
    if (open_rings_ > 0)
      notes_.push_back(
          fmt::format("doubtful: rings whose last position is not their first, and that were closed: {}", open_rings_));
    collection.notes = std::move(notes_);
    return collection;
  }

 private:
  /// GeoJSON, or what OpenStreetMap hands out as GeoJSON.
  json document() {
    const OsmForm form = osm_form_of(path_);
    if (form == OsmForm::xml) return geojson_of(read_osm_xml(path_), notes_);
    json all = read_lenient_json(path_, notes_);
    may_lack_numbers_ = !notes_.empty();
    return form == OsmForm::json && all.is_object() && all.contains("elements")
               ? geojson_of(read_overpass(all, path_), notes_)
               : all;
  }

  [[noreturn]] void fail(const std::string& where, const std::string& found, const std::string& expected) const {
    throw MapError(path_ + ": " + (where.empty() ? "the document" : where) + ": " + found + ", expected " + expected);
  }

  static std::string crs_of(const json& all) {
    if (!all.contains("crs") || !all.at("crs").is_object()) return "";
    const json& crs = all.at("crs");
    const bool is_named = crs.contains("properties") && crs.at("properties").is_object() &&
                          crs.at("properties").contains("name") && crs.at("properties").at("name").is_string();
    return is_named ? crs.at("properties").at("name").get<std::string>() : "";
  }

  std::string type_of(const json& object, const std::string& where, const std::string& expected) const {
    if (!object.is_object()) fail(where, shown(object), "an object with a type");
    if (!object.contains("type") || !object.at("type").is_string()) fail(where, "no type", expected);
    return object.at("type");
  }

  const json& list(const json& object, const char* key, const std::string& where) const {
    if (!object.contains(key)) fail(where, "no " + std::string(key), "an array");
    if (!object.at(key).is_array()) fail(where + "/" + key, shown(object.at(key)), "an array");
    return object.at(key);
  }

  Feature feature_of(json& object, const std::string& where, std::size_t number) {
    const std::string found = may_lack_numbers_ ? take_no_number(object) : "";
    Feature made = feature(object, where, number);
    if (!found.empty()) made.damage = path_ + ": " + where + found + ", expected a number";
    return made;
  }

  /// What is wrong with it becomes its damage: a class may still say that no map is made of it.
  Feature feature(const json& object, const std::string& where, std::size_t number) {
    Feature feature;
    attempt(feature, [&] {
      if (type_of(object, where, "Feature") != "Feature") fail(where + "/type", shown(object.at("type")), "Feature");
    });
    std::optional<std::string> id;
    if (object.is_object()) {
      attempt(feature, [&] { id = given_id(object, where); });
      attempt(feature, [&] { add_properties(object, where, feature); });
      attempt(feature, [&] { add_geometry_of(object, where, feature); });
    }
    feature.id = unique_id(id.value_or(fmt::format("feature-{}", number + 1)));
    return feature;
  }

  /// The first damage is told.
  template <class Act>
  static void attempt(Feature& feature, Act act) {
    try {
      act();
    } catch (const MapError& error) {
      if (feature.damage.empty()) feature.damage = error.what();
    }
  }

  void add_properties(const json& object, const std::string& where, Feature& feature) const {
    if (object.contains("feature_type")) feature.properties["feature_type"] = object.at("feature_type");  // IMDF
    if (!object.contains("properties") || object.at("properties").is_null()) return;
    const json& properties = object.at("properties");
    if (!properties.is_object()) fail(where + "/properties", shown(properties), "an object or null");
    const json of_archive = std::move(feature.properties);
    feature.properties = properties;
    add_tags(feature.properties);
    add_level_of_relations(feature.properties);
    feature.properties.update(of_archive);
  }

  void add_geometry_of(const json& object, const std::string& where, Feature& feature) {
    if (!object.contains("geometry")) fail(where, "no geometry", "an object or null");
    if (object.at("geometry").is_null()) return;
    feature.geometry = type_of(object.at("geometry"), where + "/geometry", "a geometry");
    add_geometry(object.at("geometry"), where + "/geometry", feature.shapes);
  }

  /// Some exports of OpenStreetMap have the tags in an object of their own.
  static void add_tags(json& properties) {
    if (!properties.contains("tags") || !properties.at("tags").is_object()) return;
    const json tags = properties.at("tags");
    for (const auto& [key, value] : tags.items())
      if (!properties.contains(key)) properties[key] = value;
  }

  /// What osmtogeojson knows of the relations that an object is a member of: where a relation is a level, it says the
  /// level of its members, which do not.
  static void add_level_of_relations(json& properties) {
    for (const char* key : {"@relations", "relations"}) {
      if (properties.contains("level") || !properties.contains(key) || !properties.at(key).is_array()) continue;
      std::string levels;
      for (const json& relation : properties.at(key)) {
        const json& tags = relation.is_object() && relation.contains("reltags") ? relation.at("reltags") : json();
        if (!tags.is_object() || tags.value("type", json()) != "level" || !tags.value("level", json()).is_string())
          continue;
        levels += (levels.empty() ? "" : ";") + tags.at("level").get<std::string>();
      }
      if (!levels.empty()) properties["level"] = levels;
    }
  }

  std::optional<std::string> given_id(const json& object, const std::string& where) const {
    const json* given = object.contains("id") ? &object.at("id") : nullptr;
    if (given == nullptr && object.contains("properties") && object.at("properties").is_object() &&
        object.at("properties").contains("@id"))
      given = &object.at("properties").at("@id");  // as exports of OpenStreetMap have it
    if (given == nullptr || given->is_null()) return std::nullopt;
    if (!given->is_string() && !given->is_number()) fail(where + "/id", shown(*given), "a text or a number");
    const std::string text = given->is_string() ? given->get<std::string>() : given->dump();
    return text.empty() ? std::nullopt : std::optional<std::string>(text);
  }

  std::string unique_id(const std::string& first) {
    std::string id = first;
    for (int k = 2; !ids_.insert(id).second; ++k) id = fmt::format("{}-{}", first, k);
    repeated_ids_ += id != first;
    return id;
  }

  void add_geometry(const json& geometry, const std::string& where, Shapes& shapes) {
    const std::string type = type_of(geometry, where, "a geometry");
    if (type == "GeometryCollection") {
      const json& parts = list(geometry, "geometries", where);
      for (std::size_t k = 0; k < parts.size(); ++k)
        add_geometry(parts[k], where + "/geometries/" + std::to_string(k), shapes);
      return;
    }
    const bool is_multiple = type.starts_with("Multi");
    const std::string single = is_multiple ? type.substr(5) : type;
    if (single != "Point" && single != "LineString" && single != "Polygon")
      fail(where + "/type", shown(geometry.at("type")), "a geometry of RFC 7946");
    const json& coordinates = list(geometry, "coordinates", where);
    if (coordinates.empty()) return;  // RFC 7946: as if there were none
    if (!is_multiple) return add_single(single, coordinates, where + "/coordinates", shapes);
    for (std::size_t k = 0; k < coordinates.size(); ++k)
      add_single(single, coordinates[k], where + "/coordinates/" + std::to_string(k), shapes);
  }

  void add_single(const std::string& type, const json& coordinates, const std::string& where, Shapes& shapes) {
    if (type == "Point") {
      shapes.points.push_back(position(coordinates, where));
    } else if (type == "LineString") {
      shapes.lines.push_back(positions(coordinates, where, 2));
    } else {
      if (!coordinates.is_array() || coordinates.empty()) fail(where, shown(coordinates), "an array of rings");
      shapes.polygons.emplace_back();
      for (std::size_t k = 0; k < coordinates.size(); ++k)
        shapes.polygons.back().push_back(ring(coordinates[k], where + "/" + std::to_string(k)));
    }
  }

  Ring ring(const json& coordinates, const std::string& where) {
    const bool is_open = coordinates.is_array() && coordinates.size() > 2 && coordinates.front() != coordinates.back();
    Ring ring = positions(coordinates, where, is_open ? 3 : 4);
    if (is_open)
      ++open_rings_;
    else
      ring.pop_back();
    return ring;
  }

  std::vector<Point> positions(const json& coordinates, const std::string& where, std::size_t at_least) const {
    if (!coordinates.is_array() || coordinates.size() < at_least)
      fail(where, shown(coordinates), fmt::format("at least {} positions", at_least));
    std::vector<Point> points;
    for (std::size_t k = 0; k < coordinates.size(); ++k)
      points.push_back(position(coordinates[k], where + "/" + std::to_string(k)));
    return points;
  }

  Point position(const json& coordinates, const std::string& where) const {
    const bool is_position = coordinates.is_array() && coordinates.size() >= 2 &&
                             std::ranges::all_of(coordinates, [](const json& c) { return c.is_number(); });
    if (!is_position) fail(where, shown(coordinates), "a position of two or three numbers");
    return {coordinates[0].get<double>(), coordinates[1].get<double>()};
  }

  const std::string& path_;
  std::set<std::string> ids_;
  int repeated_ids_ = 0;
  bool may_lack_numbers_ = false;
  int open_rings_ = 0;
  std::vector<std::string> notes_;
};

}  // namespace

nlohmann::json::const_iterator find_property(const Feature& feature, const std::string& name) {
  const nlohmann::json& properties = feature.properties;
  const auto exact = properties.find(name);
  if (exact != properties.end()) return exact;
  for (auto property = properties.begin(); property != properties.end(); ++property)
    if (is_same_name(property.key(), name)) return property;
  return properties.end();
}

std::string text_or_number(const Feature& feature, const std::string& property) {
  const auto found = find_property(feature, property);
  if (found == feature.properties.end()) return "";
  return found->is_string() ? found->get<std::string>() : found->is_number() ? found->dump() : "";
}

FeatureCollection read_geojson(const std::string& path) { return Reader(path).run(); }

}  // namespace opal::geojson_importer
