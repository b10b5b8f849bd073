#include "geojson_importer.hpp"

#include "feature_classes.hpp"
#include "level.hpp"

#include <opal/common/error.hpp>
#include <opal/import_kit/class_tally.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

namespace opal::geojson_importer {
namespace {

// No building is smaller than 5 cm, and none is larger than 0.05 degrees (5 km).
constexpr double kGeographicExtent = 0.05;
constexpr double kHighestLatitude_deg = 85;

std::string name_of(const std::string& path) {
  const std::string name = std::filesystem::path(path).stem().string();
  return name.empty() ? "plan" : name;
}

/// Calls visit(point) for every position.
template <class Visit>
void visit_positions(Shapes& shapes, Visit&& visit) {
  for (Point& p : shapes.points) visit(p);
  for (auto& line : shapes.lines)
    for (Point& p : line) visit(p);
  for (auto& polygon : shapes.polygons)
    for (Ring& ring : polygon)
      for (Point& p : ring) visit(p);
}

bool is_on_earth(const Point& low, const Point& high) {
  return low.x() >= -180 && high.x() <= 180 && low.y() >= -90 && high.y() <= 90;
}

/// Makes elements of a plan of features.
class Sorting {
 public:
  Sorting(const PlanImportOptions& plan, const std::string& radius_property, double circle_tolerance_m,
          double max_column_radius_m)
      : plan_(plan),
        radius_property_(radius_property),
        circle_tolerance_m_(circle_tolerance_m),
        max_column_radius_m_(max_column_radius_m) {}

  void add(const Feature& feature, const FeatureClasses& classes) {
    const std::optional<std::string> type = plan_.rules.class_of(classes.names);
    names.insert(names.end(), classes.names.begin(), classes.names.end());
    if (!type) return leave_out(feature, classes.shown, "no class for it", ImportStatus::left_out);
    if (*type == ClassRules::kLeaveOut)
      return leave_out(feature, classes.shown, "a rule says so", ImportStatus::left_out);
    if (const std::string trouble = use(feature, *type); !trouble.empty())
      return leave_out(feature, classes.shown, trouble, ImportStatus::unreadable);
    tally.count_used(classes.shown, *type, feature.geometry);
    things.push_back({feature.id, classes.shown, feature.geometry});
  }

  void leave_out(const Feature& feature, const std::string& source_class, const std::string& why, ImportStatus status) {
    const std::string geometry = feature.geometry.empty() ? "null" : feature.geometry;
    tally.count_left_out(source_class, why, geometry, feature.id);
    things.push_back({feature.id, source_class, geometry, status, why});
  }

  std::vector<PlanElement> elements;
  std::vector<ImportedElement> things;
  std::vector<std::string> names;
  ClassTally tally{"class"};
  int refitted = 0;

 private:
  std::string use(const Feature& feature, const std::string& type) {
    PlanElement element{feature.id, type, plan_.sensor_for(type)};
    if (feature.geometry.empty()) return "it has no geometry";
    if (!feature.shapes.points.empty()) {
      const std::optional<double> radius_m = radius_of(feature);
      if (!radius_m) return "a point without a positive " + radius_property_;
      for (const Point& p : feature.shapes.points) element.circles.push_back({p, *radius_m});
    }
    for (const auto& line : feature.shapes.lines) element.lines.push_back({line, false, PlanSides::both});
    int solid = 0;
    for (const auto& polygon : feature.shapes.polygons) add_polygon(polygon, ++solid, element);
    elements.push_back(std::move(element));
    return "";
  }

  std::optional<double> radius_of(const Feature& feature) const {
    if (!feature.properties.contains(radius_property_) || !feature.properties.at(radius_property_).is_number())
      return std::nullopt;
    const double radius_m = feature.properties.at(radius_property_);
    return radius_m > 0 ? std::optional<double>(radius_m) : std::nullopt;
  }

  void add_polygon(const std::vector<Ring>& polygon, int solid, PlanElement& element) {
    const auto circle = polygon.size() == 1 ? circle_drawn_by(polygon.front(), circle_tolerance_m_) : std::nullopt;
    if (circle && circle->radius_m <= max_column_radius_m_) {
      element.circles.push_back(*circle);
      ++refitted;
      return;
    }
    for (const Ring& ring : polygon) element.lines.push_back({ring, true, PlanSides::solid, solid});
  }

  const PlanImportOptions& plan_;
  const std::string& radius_property_;
  double circle_tolerance_m_, max_column_radius_m_;
};

}  // namespace

GeoJsonImporter::GeoJsonImporter(const nlohmann::json& options)
    : plan_(options, default_classes()),
      storey_(options.at("storey")),
      class_property_(options.at("class_property")),
      radius_property_(options.at("radius_property")),
      is_geographic_(options.at("geographic")),
      origin_m_(options.at("origin_x_m").get<double>(), options.at("origin_y_m").get<double>()),
      circle_tolerance_m_(options.at("circle_tolerance_m")),
      max_column_radius_m_(options.at("max_column_radius_m")) {
  const nlohmann::json &longitude = options.at("origin_lon_deg"), &latitude = options.at("origin_lat_deg");
  if (longitude.is_null() != latitude.is_null())
    throw ConfigError(
        "opal:GeoJsonImporter: options origin_lon_deg, origin_lat_deg: one of them is null, expected both or none");
  if (!longitude.is_null()) origin_deg_ = Point(longitude.get<double>(), latitude.get<double>());
}

bool GeoJsonImporter::recognizes(const std::string& path) const {
  std::error_code error;
  const std::string extension = std::filesystem::path(path).extension().string();
  if (!std::filesystem::is_regular_file(path, error)) return false;
  if (extension == ".geojson") return true;
  if (extension != ".json") return false;
  std::string begin(4096, '\0');
  std::ifstream(path, std::ios::binary).read(begin.data(), static_cast<std::streamsize>(begin.size()));
  return begin.find("\"FeatureCollection\"") != std::string::npos;
}

std::vector<std::string> GeoJsonImporter::project(const std::string& path, FeatureCollection& collection,
                                                  const Point& low, const Point& high) const {
  if (!is_on_earth(low, high))
    throw MapError(
        path +
        ": holds coordinates that are no longitude and latitude, expected degrees, as the option geographic says");
  if ((high - low).maxCoeff() > kGeographicExtent)
    throw MapError(fmt::format("{}: reaches over {} degrees, expected a building (0.05 degrees at most)", path,
                               (high - low).maxCoeff()));
  const Point origin = origin_deg_.value_or((low + high) / 2);
  if (std::abs(origin.y()) > kHighestLatitude_deg)
    throw MapError(path + ": lies nearer than 5 degrees to a pole, expected another place");
  const LocalProjection projection(origin);
  double error_m = 0;
  for (Feature& feature : collection.features)
    visit_positions(feature.shapes, [&](Point& p) {
      p = projection.to_map(p);
      error_m = std::max(error_m, projection.error_m(p));
    });
  return {fmt::format("longitude and latitude (WGS 84) around {:.8f}, {:.8f}: x east, y north; off by {:.3f} m at most",
                      origin.x(), origin.y(), error_m)};
}

std::vector<std::string> GeoJsonImporter::place(const std::string& path, FeatureCollection& collection) const {
  Point low(0, 0), high(0, 0);
  bool is_first = true;
  for (Feature& feature : collection.features)
    visit_positions(feature.shapes, [&](const Point& p) {
      low = is_first ? p : Point(low.cwiseMin(p));
      high = is_first ? p : Point(high.cwiseMax(p));
      is_first = false;
    });
  if (is_geographic_) return project(path, collection, low, high);
  if (!is_first && is_on_earth(low, high) && (high - low).maxCoeff() < kGeographicExtent)
    throw MapError(
        path +
        ": all coordinates lie within 0.05 and look like longitude and latitude, expected metres; the option "
        "geographic=true projects degrees to metres around the middle");
  for (Feature& feature : collection.features) visit_positions(feature.shapes, [&](Point& p) { p -= origin_m_; });
  return {"coordinates in metres"};
}

void GeoJsonImporter::check_level(const std::string& path, const FeatureCollection& collection) const {
  const std::vector<std::string> levels = all_levels(collection);
  std::string listed;
  for (const std::string& level : levels) listed += (listed.empty() ? "'" : ", '") + level + "'";
  if (storey_.empty() && levels.size() > 1)
    throw MapError(path + ": has the levels " + listed + ", expected the option storey to name one");
  const bool is_known =
      std::any_of(collection.features.begin(), collection.features.end(),
                  [&](const Feature& feature) { return !levels_of(feature).empty() && is_on_level(feature, storey_); });
  if (!storey_.empty() && !is_known)
    throw MapError(path + ": has no level '" + storey_ + "', expected " +
                   (listed.empty() ? "no storey: it has no levels" : "one of " + listed));
}

std::vector<Storey> GeoJsonImporter::storeys(const std::string& path) const {
  const FeatureCollection collection = read_geojson(path);
  std::vector<Storey> storeys;
  for (const std::string& level : all_levels(collection)) {
    Storey storey{level, level};
    for (const Feature& feature : collection.features)
      if (is_on_level(feature, level)) ++storey.gives[classes_of(feature, class_property_).shown];
    storeys.push_back(std::move(storey));
  }
  return storeys;
}

MapImport GeoJsonImporter::import(const std::string& path) const {
  FeatureCollection collection = read_geojson(path);
  check_level(path, collection);
  const std::vector<std::string> about_place = place(path, collection);
  Sorting sorting(plan_, radius_property_, circle_tolerance_m_, max_column_radius_m_);
  for (const Feature& feature : collection.features) {
    const FeatureClasses classes = classes_of(feature, class_property_);
    if (storey_.empty() || is_on_level(feature, storey_))
      sorting.add(feature, classes);
    else
      sorting.leave_out(feature, classes.shown, "it is on another level", ImportStatus::not_cut);
  }
  if (sorting.elements.empty())
    throw MapError(
        path +
        ": no feature gives anything for a map, expected the options classes and class_property to name some of: " +
        sorting.tally.overview());

  const PlanAssembly assembly =
      assemble_plan(path, collection.name.empty() ? name_of(path) : collection.name, sorting.elements, plan_.plan);
  MapImport imported{assembly.map, about_place, std::move(sorting.things), {}};
  report_outcomes(sorting.elements, assembly, imported.elements);
  sort_by_id(imported.elements);
  imported.report.push_back(extent_sentence(*assembly.map));
  if (collection.has_crs) imported.report.push_back("ignored: crs, which GeoJSON no longer has (RFC 7946)");
  for (const std::string& sentence : sorting.tally.sentences()) imported.report.push_back(sentence);
  for (const std::string& pattern : plan_.rules.unused(sorting.names))
    imported.report.push_back("doubtful: no feature is '" + pattern + "', as a rule of the option classes has it");
  if (sorting.refitted > 0)
    imported.report.push_back(fmt::format("circles that were drawn as polygons: {}", sorting.refitted));
  for (const std::string& sentence : assembly.tally.sentences(plan_.plan)) imported.report.push_back(sentence);
  return imported;
}

}  // namespace opal::geojson_importer
