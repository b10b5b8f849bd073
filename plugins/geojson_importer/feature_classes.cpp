#include "feature_classes.hpp"

namespace opal::geojson_importer {
namespace {

// Which say what a thing is, the one that says most first.
constexpr const char* kClassKeys[] = {"class", "indoor",  "element",      "type",  "category",
                                      "kind",  "barrier", "feature_type", "layer", "ifc_class"};

constexpr std::pair<const char*, const char*> kWords[] = {
    {"wall", "Wall"},    {"walls", "Wall"},    {"column", "Column"},    {"columns", "Column"}, {"pillar", "Column"},
    {"door", "Door"},    {"doors", "Door"},    {"opening", "Door"},     {"window", "Window"},  {"windows", "Window"},
    {"glass", "Window"}, {"IfcWall*", "Wall"}, {"IfcColumn", "Column"}, {"IfcDoor", "Door"},   {"IfcWindow", "Window"}};

std::string text_of(const nlohmann::json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

}  // namespace

FeatureClasses classes_of(const Feature& feature, const std::string& class_property) {
  FeatureClasses classes;
  if (!class_property.empty()) {
    if (feature.properties.contains(class_property))
      classes.names.push_back(text_of(feature.properties.at(class_property)));
    classes.shown = classes.names.empty() ? "without " + class_property : classes.names.front();
    return classes;
  }
  for (const auto& [key, value] : feature.properties.items())
    if (value.is_primitive() && !value.is_null()) classes.names.push_back(key + "=" + text_of(value));
  for (const char* key : kClassKeys)
    if (classes.shown.empty() && feature.properties.contains(key))
      classes.shown = std::string(key) + "=" + text_of(feature.properties.at(key));
  if (classes.shown.empty()) classes.shown = classes.names.empty() ? "without properties" : classes.names.front();
  return classes;
}

std::map<std::string, std::string> default_classes() {
  std::map<std::string, std::string> rules{
      {"door=*", "Door"}, {"door=no", "leave_out"}, {"window=*", "Window"}, {"window=no", "leave_out"}};
  for (const char* key : kClassKeys)
    for (const auto& [word, type] : kWords) rules[std::string(key) + "=" + word] = type;
  return rules;
}

}  // namespace opal::geojson_importer
