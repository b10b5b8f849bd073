#include "geojson_importer.hpp"

#include "connections.hpp"
#include "file_kind.hpp"
#include "imdf_archive.hpp"
#include "level.hpp"
#include "types_by_words.hpp"

#include <opal/common/error.hpp>
#include <opal/import_kit/length_unit.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace opal::geojson_importer {
namespace {

std::string name_of(const std::string& path) {
  const std::string name = std::filesystem::path(path).stem().string();
  return name.empty() ? "plan" : name;
}

/// Reads the options `unit` and `geographic`, which say the same thing.
void read_unit(const nlohmann::json& options, PlacementOptions& placement) {
  if (!options.at("geographic").is_null()) placement.is_geographic = options.at("geographic").get<bool>();
  placement.unit = options.at("unit");
  placement.y_down = options.at("y_down");
  if (placement.unit.empty()) return;
  if (!length_unit_called(placement.unit))
    throw ConfigError("opal:GeoJsonImporter: option unit: \"" + placement.unit + "\", expected one of " +
                      length_unit_names());
  if (placement.is_geographic == true)
    throw ConfigError("opal:GeoJsonImporter: options unit, geographic: a length and degrees, expected one of them");
  placement.is_geographic = false;
}

/// About damaged features, of which no map is made.
std::vector<std::string> sentences_about_damage(const FeatureCollection& collection) {
  const auto is_damaged = [](const Feature& feature) { return !feature.damage.empty(); };
  const auto first = std::find_if(collection.features.begin(), collection.features.end(), is_damaged);
  if (first == collection.features.end()) return {};
  return {fmt::format("damaged, and nothing is made of them: {} features, the first: {}",
                      std::count_if(first, collection.features.end(), is_damaged), first->damage)};
}

}  // namespace

GeoJsonImporter::GeoJsonImporter(const nlohmann::json& options)
    : plan_(options, default_classes()),
      storey_(options.at("storey")),
      class_property_(options.at("class_property")),
      level_property_(options.at("level_property")),
      elements_{options.at("radius_property"), options.at("circle_tolerance_m"), options.at("max_column_radius_m"),
                options.at("door_width_m")} {
  placement_.origin_m = {options.at("origin_x_m").get<double>(), options.at("origin_y_m").get<double>()};
  read_unit(options, placement_);
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
  return is_imdf_archive(path) || looks_like_plan(path);
}

FeatureCollection GeoJsonImporter::plan_at(const std::string& path, const std::string& level_property) const {
  FeatureCollection collection = read_plan(path);
  find_levels(path, level_property, collection);
  for (Feature& feature : collection.features)
    feature.type = plan_.rules.class_of(classes_of(feature, class_property_).names).value_or("");
  if (class_property_.empty()) find_types_by_words(name_of(path), collection);
  for (Feature& feature : collection.features) {
    const std::string& type = feature.type;
    feature.is_used = !type.empty() && type != ClassRules::kLeaveOut && type != kArea && type != kOpening;
  }
  return collection;
}

PlacementOptions GeoJsonImporter::placement() const {
  PlacementOptions placement = placement_;
  if (placement.origin_file.empty()) return placement;
  FeatureCollection other = plan_at(placement.origin_file, "");
  placement.origin_deg = middle_deg(placement, other);
  return placement;
}

namespace {

/// "'0' (Parkway)"
std::string level_in_words(const FeatureCollection& collection, const std::string& level) {
  const auto label = collection.label_of_level.find(level);
  const bool is_plain = label == collection.label_of_level.end() || label->second == level;
  return "'" + level + "'" + (is_plain ? "" : " (" + label->second + ")");
}

}  // namespace

std::string GeoJsonImporter::chosen_level(const std::string& path, const FeatureCollection& collection,
                                          std::vector<std::string>& sentences) const {
  const std::vector<std::string> levels = all_levels(collection);
  std::string listed;
  for (const std::string& level : levels) listed += (listed.empty() ? "" : ", ") + level_in_words(collection, level);
  if (storey_.empty()) {
    if (levels.size() < 2) return "";
    const std::string level = level_at_ground(collection);
    const std::string where =
        collection.level_property.empty() ? "" : " (as the property '" + collection.level_property + "' says)";
    const std::string which = is_numbered(level) ? "the nearest to the ground" : "the first by its name";
    if (!level.empty())
      sentences.push_back("level " + level_in_words(collection, level) + " of " + listed + where + ", " + which +
                          " that gives anything (--storey chooses another)");
    return level;
  }
  const auto name = collection.level_of_name.find(storey_);
  const std::string level = name == collection.level_of_name.end() ? storey_ : name->second;
  const bool is_known =
      std::any_of(collection.features.begin(), collection.features.end(),
                  [&](const Feature& feature) { return !feature.levels.empty() && is_on_level(feature, level); });
  if (!is_known)
    throw MapError(path + ": has no level '" + storey_ + "', expected " +
                   (listed.empty() ? "no storey: it has no levels (level_property names the property that says them)"
                                   : "one of " + listed));
  return level;
}

FeatureClasses GeoJsonImporter::shown_classes(const Feature& feature) const {
  FeatureClasses classes = classes_of(feature, class_property_);
  if (!feature.said_by.empty()) classes.shown = feature.said_by;
  return classes;
}

std::vector<Storey> GeoJsonImporter::storeys(const std::string& path) const {
  FeatureCollection collection = plan_at(path, level_property_);
  std::vector<Storey> storeys;
  for (const std::string& level : all_levels(collection)) {
    const auto label = collection.label_of_level.find(level);
    Storey storey{level, label == collection.label_of_level.end() ? level : label->second};
    for (const Feature& feature : collection.features)
      if (feature.is_used && is_on_level(feature, level)) ++storey.gives[shown_classes(feature).shown];
    storeys.push_back(std::move(storey));
  }
  return storeys;
}

PlanElements GeoJsonImporter::elements_of(const std::string& path, const FeatureCollection& collection,
                                          const std::string& level) const {
  PlanElements elements(path, plan_, elements_);
  for (const Feature& feature : collection.features) {
    const FeatureClasses classes = shown_classes(feature);
    if (level.empty() || is_on_level(feature, level))
      elements.add(feature, classes);
    else
      elements.leave_out(feature, classes, "it is on another level", ImportStatus::not_cut);
  }
  elements.finish();
  return elements;
}

void GeoJsonImporter::expect_features(const std::string& path, const SemanticMap& map) const {
  if (map.features().empty())
    throw MapError(fmt::format("{}: no line is {} m long or longer, expected a building: {}", path,
                               plan_.plan.min_face_m,
                               placement_.unit.empty() ? "the options unit and geographic say what its coordinates are"
                                                       : "the option unit is wrong"));
}

MapImport GeoJsonImporter::import(const std::string& path) const {
  FeatureCollection collection = plan_at(path, level_property_);
  std::vector<std::string> sentences = collection.notes;
  const std::string level = chosen_level(path, collection, sentences);
  for (const std::string& sentence : doubts_about_levels(collection)) sentences.push_back(sentence);
  for (const std::string& sentence : place(path, placement(), collection)) sentences.push_back(sentence);
  PlanElements plan = elements_of(path, collection, level);
  if (plan.elements.empty())
    throw MapError(path + (collection.features.empty() ? ": has no features, expected a plan"
                                                       : ": no feature gives anything for a map, expected the options "
                                                         "classes and class_property to name some of: " +
                                                             plan.tally.overview()));

  MapOrigin origin;
  origin.storey = collection.label_of_level.contains(level) ? collection.label_of_level.at(level) : level;
  origin.connections = connections_of(collection, level);
  const PlanAssembly assembly =
      assemble_plan(path, collection.name.empty() ? name_of(path) : collection.name, plan.elements, plan_.plan, origin);
  expect_features(path, *assembly.map);
  MapImport imported{assembly.map, std::move(sentences), std::move(plan.things), {}};
  report_outcomes(plan.elements, assembly, imported.elements);
  sort_by_id(imported.elements);
  imported.report.push_back(extent_sentence(*assembly.map));
  for (const std::string& sentence : plan.tally.sentences()) imported.report.push_back(sentence);
  for (const std::string& pattern : plan_.rules.unused(plan.names))
    imported.report.push_back("doubtful: no feature is '" + pattern + "', as a rule of the option classes has it");
  for (const std::string& sentence : sentences_about_damage(collection)) imported.report.push_back(sentence);
  for (const std::string& sentence : plan.sentences()) imported.report.push_back(sentence);
  for (const std::string& sentence : assembly.tally.sentences(plan_.plan)) imported.report.push_back(sentence);
  return imported;
}

}  // namespace opal::geojson_importer
