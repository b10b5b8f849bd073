#include "geojson_importer.hpp"

#include "connections.hpp"
#include "imdf_archive.hpp"
#include "level.hpp"

#include <opal/common/error.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace opal::geojson_importer {
namespace {

std::string name_of(const std::string& path) {
  const std::string name = std::filesystem::path(path).stem().string();
  return name.empty() ? "plan" : name;
}

}  // namespace

GeoJsonImporter::GeoJsonImporter(const nlohmann::json& options)
    : plan_(options, default_classes()),
      storey_(options.at("storey")),
      class_property_(options.at("class_property")),
      elements_{options.at("radius_property"), options.at("circle_tolerance_m"), options.at("max_column_radius_m"),
                options.at("door_width_m")} {
  placement_.origin_m = {options.at("origin_x_m").get<double>(), options.at("origin_y_m").get<double>()};
  if (!options.at("geographic").is_null()) placement_.is_geographic = options.at("geographic").get<bool>();
  const nlohmann::json &longitude = options.at("origin_lon_deg"), &latitude = options.at("origin_lat_deg");
  if (longitude.is_null() != latitude.is_null())
    throw ConfigError(
        "opal:GeoJsonImporter: options origin_lon_deg, origin_lat_deg: one of them is null, expected both or none");
  if (!longitude.is_null())
    placement_.origin_deg = Point(longitude.get<double>(), latitude.get<double>());
  else
    placement_.origin_file = options.at("origin_file");
}

bool GeoJsonImporter::recognizes(const std::string& path) const {
  std::error_code error;
  const std::string extension = std::filesystem::path(path).extension().string();
  if (is_imdf_archive(path)) return true;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  if (extension == ".geojson") return true;
  if (extension != ".json") return false;
  std::string begin(4096, '\0');
  std::ifstream(path, std::ios::binary).read(begin.data(), static_cast<std::streamsize>(begin.size()));
  return begin.find("\"FeatureCollection\"") != std::string::npos;
}

void GeoJsonImporter::mark_used(FeatureCollection& collection) const {
  for (Feature& feature : collection.features) {
    const auto type = plan_.rules.class_of(classes_of(feature, class_property_).names);
    feature.is_used = type && *type != ClassRules::kLeaveOut && *type != kArea && *type != kOpening;
  }
}

PlacementOptions GeoJsonImporter::placement() const {
  PlacementOptions placement = placement_;
  if (placement.origin_file.empty()) return placement;
  FeatureCollection other = read_plan(placement.origin_file);
  mark_used(other);
  placement.origin_deg = middle_deg(placement, other);
  return placement;
}

std::string GeoJsonImporter::chosen_level(const std::string& path, const FeatureCollection& collection,
                                          std::vector<std::string>& sentences) const {
  const std::vector<std::string> levels = all_levels(collection);
  std::string listed;
  for (const std::string& level : levels) listed += (listed.empty() ? "'" : ", '") + level + "'";
  if (storey_.empty()) {
    if (levels.size() < 2) return "";
    const std::string level = level_at_ground(collection);
    if (!level.empty())
      sentences.push_back("level '" + level + "' of " + listed +
                          ", the nearest to the ground that gives anything (--storey chooses another)");
    return level;
  }
  const auto name = collection.level_of_name.find(storey_);
  const std::string level = name == collection.level_of_name.end() ? storey_ : name->second;
  const bool is_known =
      std::any_of(collection.features.begin(), collection.features.end(),
                  [&](const Feature& feature) { return !levels_of(feature).empty() && is_on_level(feature, level); });
  if (!is_known)
    throw MapError(path + ": has no level '" + storey_ + "', expected " +
                   (listed.empty() ? "no storey: it has no levels" : "one of " + listed));
  return level;
}

std::vector<Storey> GeoJsonImporter::storeys(const std::string& path) const {
  FeatureCollection collection = read_plan(path);
  mark_used(collection);
  std::vector<Storey> storeys;
  for (const std::string& level : all_levels(collection)) {
    const auto label = collection.label_of_level.find(level);
    Storey storey{level, label == collection.label_of_level.end() ? level : label->second};
    for (const Feature& feature : collection.features)
      if (feature.is_used && is_on_level(feature, level)) ++storey.gives[classes_of(feature, class_property_).shown];
    storeys.push_back(std::move(storey));
  }
  return storeys;
}

PlanElements GeoJsonImporter::elements_of(const std::string& path, const FeatureCollection& collection,
                                          const std::string& level) const {
  PlanElements elements(path, plan_, elements_);
  for (const Feature& feature : collection.features) {
    const FeatureClasses classes = classes_of(feature, class_property_);
    if (level.empty() || is_on_level(feature, level))
      elements.add(feature, classes);
    else
      elements.leave_out(feature, classes.shown, "it is on another level", ImportStatus::not_cut);
  }
  elements.finish();
  return elements;
}

MapImport GeoJsonImporter::import(const std::string& path) const {
  FeatureCollection collection = read_plan(path);
  mark_used(collection);
  std::vector<std::string> sentences = collection.notes;
  const std::string level = chosen_level(path, collection, sentences);
  for (const std::string& sentence : place(path, placement(), collection)) sentences.push_back(sentence);
  PlanElements plan = elements_of(path, collection, level);
  if (plan.elements.empty())
    throw MapError(
        path +
        ": no feature gives anything for a map, expected the options classes and class_property to name some of: " +
        plan.tally.overview());

  MapOrigin origin;
  origin.storey = collection.label_of_level.contains(level) ? collection.label_of_level.at(level) : level;
  origin.connections = connections_of(collection, level);
  const PlanAssembly assembly =
      assemble_plan(path, collection.name.empty() ? name_of(path) : collection.name, plan.elements, plan_.plan, origin);
  MapImport imported{assembly.map, std::move(sentences), std::move(plan.things), {}};
  report_outcomes(plan.elements, assembly, imported.elements);
  sort_by_id(imported.elements);
  imported.report.push_back(extent_sentence(*assembly.map));
  for (const std::string& sentence : plan.tally.sentences()) imported.report.push_back(sentence);
  for (const std::string& pattern : plan_.rules.unused(plan.names))
    imported.report.push_back("doubtful: no feature is '" + pattern + "', as a rule of the option classes has it");
  for (const std::string& sentence : plan.sentences()) imported.report.push_back(sentence);
  for (const std::string& sentence : assembly.tally.sentences(plan_.plan)) imported.report.push_back(sentence);
  return imported;
}

}  // namespace opal::geojson_importer
