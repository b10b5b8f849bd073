#include "imdf_archive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>

namespace opal::geojson_importer {
namespace {

namespace fs = std::filesystem;

constexpr const char* kUnits = "unit.geojson";
constexpr const char* kLevels = "level.geojson";
// What may become map, or is worth a line in the report.
constexpr std::array kRead{kUnits, "opening.geojson", "fixture.geojson", "kiosk.geojson"};
constexpr std::array kTypes{"unit",    "level",   "opening", "footprint",   "venue",   "building",
                            "address", "amenity", "anchor",  "occupant",    "section", "geofence",
                            "fixture", "kiosk",   "detail",  "relationship"};

std::string text_of(const nlohmann::json& properties, const char* key) {
  return properties.contains(key) && properties.at(key).is_string() ? properties.at(key).get<std::string>() : "";
}

/// "Concourse" of {"en": "Concourse"}, in whatever language comes first.
std::string label_of(const nlohmann::json& properties, const char* key) {
  if (!properties.contains(key) || !properties.at(key).is_object()) return "";
  for (const auto& [language, label] : properties.at(key).items())
    if (label.is_string()) return label.get<std::string>();
  return "";
}

bool is_of_archive(const FeatureCollection& collection) {
  return std::any_of(collection.features.begin(), collection.features.end(), [](const Feature& feature) {
    const std::string type = text_of(feature.properties, "feature_type");
    return std::find(kTypes.begin(), kTypes.end(), type) != kTypes.end();
  });
}

struct ArchiveLevel {
  std::string ordinal;
  bool is_outdoor = false;
};

/// Levels by their ids; names go into the collection.
std::map<std::string, ArchiveLevel> levels_in(const fs::path& folder, FeatureCollection& archive) {
  std::map<std::string, ArchiveLevel> levels;
  std::error_code error;
  if (!fs::is_regular_file(folder / kLevels, error)) return levels;
  for (const Feature& level : read_geojson((folder / kLevels).string()).features) {
    if (!level.properties.contains("ordinal") || !level.properties.at("ordinal").is_number()) continue;
    const std::string ordinal = level.properties.at("ordinal").dump();
    const bool is_outdoor = level.properties.contains("outdoor") && level.properties.at("outdoor") == true;
    levels[level.id] = {ordinal, is_outdoor};
    archive.level_of_name.emplace(level.id, ordinal);
    for (const char* key : {"name", "short_name"})
      if (const std::string label = label_of(level.properties, key); !label.empty()) {
        archive.level_of_name.emplace(label, ordinal);
        archive.label_of_level.emplace(ordinal, label);
      }
  }
  return levels;
}

FeatureCollection read_archive(const fs::path& folder) {
  FeatureCollection archive;
  archive.name = fs::absolute(folder / kUnits).parent_path().filename().string();
  const std::map<std::string, ArchiveLevel> levels = levels_in(folder, archive);
  std::vector<const char*> files;
  std::set<std::string> ids;
  for (const char* file : kRead) {
    std::error_code error;
    if (!fs::is_regular_file(folder / file, error)) continue;
    files.push_back(file);
    for (Feature& feature : read_geojson((folder / file).string()).features) {
      if (const auto known = levels.find(text_of(feature.properties, "level_id")); known != levels.end()) {
        feature.properties["level"] = known->second.ordinal;
        feature.properties["outdoor"] = known->second.is_outdoor;
      }
      while (!ids.insert(feature.id).second) feature.id += "-again";
      archive.features.push_back(std::move(feature));
    }
  }
  if (!levels.empty()) files.push_back(kLevels);
  archive.notes.push_back(fmt::format("an archive of IMDF, of which were read: {}", fmt::join(files, ", ")));
  return archive;
}

}  // namespace

bool is_imdf_archive(const std::string& path) {
  std::error_code error;
  return fs::is_directory(path, error) && fs::is_regular_file(fs::path(path) / kUnits, error);
}

FeatureCollection read_plan(const std::string& path) {
  if (is_imdf_archive(path)) return read_archive(path);
  FeatureCollection collection = read_geojson(path);
  const fs::path folder = fs::path(path).parent_path();
  std::error_code error;
  if (!is_of_archive(collection) || !fs::is_regular_file(folder / kUnits, error)) return collection;
  return read_archive(folder);
}

}  // namespace opal::geojson_importer
