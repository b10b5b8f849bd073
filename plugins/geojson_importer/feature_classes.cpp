#include "feature_classes.hpp"

#include <opal/common/letter_case.hpp>

#include <algorithm>
#include <initializer_list>
#include <iterator>

namespace opal::geojson_importer {
namespace {

// Which say what a thing is, the one that says most first.
constexpr const char* kClassKeys[] = {"class",       "indoor",     "element",      "type",        "category",
                                      "kind",        "barrier",    "feature_type", "layer",       "ifc_class",
                                      "object_type", "objectType", "element_type", "elementType", "featureType"};

constexpr std::pair<const char*, const char*> kWords[] = {
    {"wall", "Wall"},        {"walls", "Wall"},        {"column", "Column"},     {"columns", "Column"},
    {"pillar", "Column"},    {"door", "Door"},         {"doors", "Door"},        {"opening", "Door"},
    {"window", "Window"},    {"windows", "Window"},    {"glass", "Window"},      {"IfcWall*", "Wall"},
    {"IfcColumn", "Column"}, {"IfcDoor", "Door"},      {"IfcWindow", "Window"},  {"room", "Room"},
    {"rooms", "Room"},       {"corridor", "Corridor"}, {"corridors", "Corridor"}};

std::string text_of(const nlohmann::json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

/// A property that is a text; else empty.
std::string text_at(const Feature& feature, const char* property) {
  const auto found = find_property(feature, property);
  return found != feature.properties.end() && found->is_string() ? found->get<std::string>() : "";
}

/// "feature_type=unit category=walkway" of a feature of IMDF with a category; else empty.
std::string imdf_name_of(const Feature& feature) {
  const std::string type = text_at(feature, "feature_type");
  const auto category = find_property(feature, "category"), outdoor = find_property(feature, "outdoor");
  if (type.empty() || category == feature.properties.end() || !category->is_string()) return "";
  const bool is_outdoor = outdoor != feature.properties.end() && *outdoor == true;
  return "feature_type=" + type + " category=" + category->get<std::string>() + (is_outdoor ? " outdoor" : "");
}

// Units of IMDF that corridors and halls are: no wall stands between two of them. All other units are rooms.
constexpr const char* kOpenUnits[] = {
    "walkway*",    "movingwalkway", "ramp",     "parking",   "opentobelow*", "lobby",    "waitingroom", "platform",
    "foodservice", "concession",    "terrace*", "courtyard", "road",         "sidewalk", "landscape",   "vegetation",
    "sand",        "brick",         "concrete", "asphalt",   "grass",        "water",    "unspecified"};

// Beside the keys above, these say what a thing is in OpenStreetMap.
constexpr const char* kTagKeys[] = {"door",    "entrance", "window", "buildingpart", "building:part", "building",
                                    "highway", "stairs",   "room",   "amenity",      "natural",       "landuse"};
// These say who drew it, and when.
constexpr const char* kMetadata[] = {"timestamp=", "version=", "changeset=", "user=", "uid=", "id=", "@"};

bool is_metadata(const std::string& name) {
  return std::any_of(std::begin(kMetadata), std::end(kMetadata),
                     [&](const char* key) { return name.starts_with(key); });
}

/// What an object is in the data model of OpenStreetMap, and nothing about what it stands for.
bool is_osm_type(const std::string& name) {
  return name == "type=node" || name == "type=way" || name == "type=relation";
}

bool has_any_of(const std::string& text, std::initializer_list<const char*> words) {
  return std::ranges::any_of(words, [&](const char* word) { return text.find(word) != std::string::npos; });
}

/// How much a property that no rule knows may say about what a thing is: its name may be one of a kind, or its value
/// may be a word for a part of a building. Colours, levels and heights say nothing.
int weight_of(const std::string& key, const nlohmann::json& value) {
  if (!value.is_string() || is_metadata(key + "=")) return 0;
  const std::string name = lower_case_letters(key), text = lower_case_letters(value.get<std::string>());
  if (has_any_of(text, {"wall", "column", "door", "room", "window", "corridor"})) return 4;
  if (has_any_of(name, {"type", "class", "kind", "category", "group"})) return 3;
  const bool is_style = text.starts_with("#") || text.starts_with("rgb");
  return is_style || has_any_of(name, {"fill", "stroke", "color", "colour", "level", "floor", "storey"}) ? 1 : 2;
}

/// Texts say more than numbers, which are often another one for each feature.
std::string shown_class(const Feature& feature, const std::vector<std::string>& names) {
  const auto said = [&](const char* key) {
    const auto found = find_property(feature, key);
    return found == feature.properties.end() ? "" : found.key() + "=" + text_of(*found);
  };
  for (const char* key : kClassKeys)
    if (const std::string text = said(key); !text.empty() && !is_osm_type(text)) return text;
  for (const char* key : kTagKeys)
    if (const std::string text = said(key); !text.empty()) return text;
  std::string best;
  int best_weight = 0;
  for (const auto& [key, value] : feature.properties.items())
    if (const int weight = weight_of(key, value); weight > best_weight) {
      best_weight = weight;
      best = key + "=" + value.get<std::string>();
    }
  if (best_weight > 0) return best;
  for (const std::string& name : names)
    if (!is_metadata(name)) return name;
  return names.empty() ? "without properties" : "without tags";
}

}  // namespace

FeatureClasses classes_of(const Feature& feature, const std::string& class_property) {
  FeatureClasses classes;
  if (!class_property.empty()) {
    if (const auto found = find_property(feature, class_property); found != feature.properties.end())
      classes.names.push_back(text_of(*found));
    classes.shown = classes.names.empty() ? "without " + class_property : classes.names.front();
    return classes;
  }
  for (const auto& [key, value] : feature.properties.items())
    if (value.is_primitive() && !value.is_null()) classes.names.push_back(key + "=" + text_of(value));
  if (const std::string name = imdf_name_of(feature); !name.empty()) classes.names.push_back(name);
  classes.shown = shown_class(feature, classes.names);
  return classes;
}

std::map<std::string, std::string> default_classes() {
  std::map<std::string, std::string> rules{{"door=*", "Door"},
                                           {"door=no", "Opening"},
                                           {"window=*", "Window"},
                                           {"window=no", "leave_out"},
                                           {"entrance=*", "Door"},
                                           {"entrance=no", "leave_out"},
                                           {"indoor=room", "Room"},
                                           {"indoor=corridor", "Corridor"},
                                           {"indoor=area", "Area"},
                                           {"buildingpart=room", "Room"},
                                           {"buildingpart=hall", "Room"},
                                           {"buildingpart=corridor", "Corridor"},
                                           {"feature_type=unit", "Room"}};
  for (const char* category : kOpenUnits) rules[std::string("feature_type=unit category=") + category] = "Corridor";
  for (const char* key : kClassKeys)
    for (const auto& [word, type] : kWords) rules[std::string(key) + "=" + word] = type;
  return rules;
}

}  // namespace opal::geojson_importer
