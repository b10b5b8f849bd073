#include "placement.hpp"

#include "coordinate_doubts.hpp"
#include "local_projection.hpp"

#include <opal/common/error.hpp>
#include <opal/common/number_text.hpp>
#include <opal/import_kit/far_origin.hpp>
#include <opal/import_kit/length_unit.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace opal::geojson_importer {
namespace {

// No building is smaller than 5 cm, and none is larger than 0.05 degrees (5 km).
constexpr double kGeographicExtent = 0.05;
constexpr double kSmallestPlan_m = 1;
constexpr double kHighestLatitude_deg = 85;
constexpr double kRadian_deg = degrees(1);
constexpr double kWebRadius_m = 6378137;
// Names of coordinate systems end so: longitude and latitude (WGS 84, and what is within 2 m of it), and the plane of
// web maps, whose metres are none.
constexpr std::array kSystemsInDegrees{"CRS84", ":4326", "/4326", "CRS83", ":4269", "/4269", ":4258", "/4258",
                                       ":4490", "/4490", ":4979", "/4979", ":7844", "/7844", ":4283", "/4283"};
constexpr std::array kWebMercator{":3857", "/3857", ":900913", ":102100"};

struct Codes {
  int first, last;
};
// EPSG codes of planes in metres that buildings are often surveyed in: UTM, MGA, and national grids of Europe.
constexpr std::array kMetres{Codes{32601, 32660}, Codes{32701, 32760}, Codes{25828, 25838}, Codes{26901, 26923},
                             Codes{28348, 28358}, Codes{7846, 7859},   Codes{31466, 31469}, Codes{31254, 31259},
                             Codes{2154, 2154},   Codes{27700, 27700}, Codes{28992, 28992}, Codes{2056, 2056},
                             Codes{21781, 21781}, Codes{31370, 31370}, Codes{3812, 3812},   Codes{3035, 3035},
                             Codes{5514, 5514},   Codes{3006, 3006},   Codes{2180, 2180},   Codes{3067, 3067}};

struct Bounds {
  Point low = Point::Constant(std::numeric_limits<double>::max());
  Point high = -low;

  bool is_empty() const { return low.x() > high.x(); }
  double size() const { return (high - low).maxCoeff(); }
  Point middle() const { return (low + high) / 2; }
  bool is_on_earth() const { return low.x() >= -180 && high.x() <= 180 && low.y() >= -90 && high.y() <= 90; }
  /// Latitude before longitude, east of 90 degrees east or west of 90 degrees west: as metres, it would be no building.
  bool looks_swapped() const {
    const Bounds swapped{Point(low.y(), low.x()), Point(high.y(), high.x())};
    return !is_empty() && !is_on_earth() && swapped.is_on_earth() && size() < kGeographicExtent;
  }
  bool looks_like_degrees() const { return !is_empty() && is_on_earth() && size() < kGeographicExtent; }
};

Bounds bounds_of(FeatureCollection& collection, bool of_used_only) {
  Bounds bounds;
  for (Feature& feature : collection.features)
    if (feature.damage.empty() && (feature.is_used || !of_used_only))
      visit_positions(feature.shapes, [&](const Point& p) {
        bounds.low = bounds.low.cwiseMin(p);
        bounds.high = bounds.high.cwiseMax(p);
      });
  return bounds;
}

/// Of everything; where that is no building, of what becomes map: a site, or a mark in another town, may be there, too.
Bounds building_of(FeatureCollection& collection) {
  const Bounds all = bounds_of(collection, false);
  if (all.looks_like_degrees()) return all;
  const Bounds used = bounds_of(collection, true);
  return used.is_empty() ? all : used;
}

template <std::size_t N>
bool ends_with_any(const std::string& name, const std::array<const char*, N>& ends) {
  return std::ranges::any_of(ends, [&](const char* end) { return name.ends_with(end); });
}

Point degrees_of_web_mercator(const Point& p) {
  return Point(p.x() / kWebRadius_m, 2 * std::atan(std::exp(p.y() / kWebRadius_m)) - std::numbers::pi / 2) *
         kRadian_deg;
}

std::string project(const std::string& path, const PlacementOptions& options, FeatureCollection& collection) {
  const Bounds bounds = building_of(collection);
  if (bounds.is_empty()) return "no coordinates";
  if (!bounds.is_on_earth())
    throw MapError(path + ": holds coordinates that are no longitude and latitude, expected degrees, as the " +
                   (options.is_geographic ? "option geographic" : "file's crs") + " says");
  if (bounds.size() > kGeographicExtent)
    throw MapError(
        fmt::format("{}: reaches over {} degrees, expected a building (0.05 degrees at most)", path, bounds.size()));
  if (!options.origin_file.empty() && !options.origin_deg)
    throw MapError(options.origin_file +
                   ": holds no longitude and latitude, expected a plan in degrees, for it is the " + "origin of " +
                   path);
  const Point origin = options.origin_deg.value_or(bounds.middle());
  if (std::abs(origin.y()) > kHighestLatitude_deg)
    throw MapError(path + ": lies nearer than 5 degrees to a pole, expected another place");
  const LocalProjection projection(origin);
  double error_m = 0;
  for (Feature& feature : collection.features)
    visit_positions(feature.shapes, [&](Point& p) {
      const bool is_there = (p.array() >= bounds.low.array()).all() && (p.array() <= bounds.high.array()).all();
      p = projection.to_map(p);
      if (is_there) error_m = std::max(error_m, projection.error_m(p));
    });
  return fmt::format("longitude and latitude (WGS 84) around {:.8f}, {:.8f}: x east, y north; off by {:.3f} m at most",
                     origin.x(), origin.y(), error_m);
}

/// Whether a coordinate system is one that is known to be in metres.
bool is_metric(const std::string& crs) {
  const std::size_t separator = crs.find_last_of(":/");
  if (separator == std::string::npos) return false;
  const auto code = parse_number<int>(crs.substr(separator + 1));
  return code &&
         std::ranges::any_of(kMetres, [&](const Codes& codes) { return codes.first <= *code && *code <= codes.last; });
}

/// Coordinates of web maps become degrees first. @return whether a plan is in degrees.
bool is_in_degrees(const PlacementOptions& options, FeatureCollection& collection,
                   std::vector<std::string>& sentences) {
  if (options.is_geographic == false) return false;
  if (ends_with_any(collection.crs, kWebMercator)) {
    for (Feature& feature : collection.features)
      visit_positions(feature.shapes, [](Point& p) { p = degrees_of_web_mercator(p); });
    sentences.push_back("coordinates of web maps (" + collection.crs + "), to longitude and latitude");
    return true;
  }
  if (options.is_geographic || ends_with_any(collection.crs, kSystemsInDegrees)) return true;
  if (!building_of(collection).looks_like_degrees()) return false;
  if (!collection.crs.empty())
    sentences.push_back("doubtful: the crs " + collection.crs +
                        " is not known to be one of degrees, which the coordinates look like: taken for WGS 84");
  return true;
}

/// @throws MapError for positions that are too far from each other for degrees, and too near for metres.
void expect_building(const std::string& path, const Bounds& bounds) {
  if (bounds.is_empty() || !bounds.is_on_earth() || bounds.size() >= kSmallestPlan_m) return;
  throw MapError(fmt::format(
      "{}: positions reach over {:.2g}: in degrees more than a building ({} degrees), in metres less than one ({} m); "
      "expected one building, or the option unit (unit=m) or geographic to say what they are",
      path, bounds.size(), kGeographicExtent, kSmallestPlan_m));
}

/// About coordinates that are lengths.
std::string sentence_about_lengths(const PlacementOptions& options, const std::string& crs) {
  if (!options.unit.empty())
    return "coordinates in " + length_unit_called(options.unit)->name + ", as the option unit says";
  const std::string metres = "coordinates in metres";
  if (crs.empty()) return metres;
  return is_metric(crs) || options.is_geographic
             ? metres + " (" + crs + ")"
             : "doubtful: " + metres + ": the crs " + crs + " is not known here (--set unit=ft for one in feet)";
}

}  // namespace

std::optional<Point> middle_deg(const PlacementOptions& options, FeatureCollection& collection) {
  std::vector<std::string> sentences;
  if (!is_in_degrees(options, collection, sentences)) return std::nullopt;
  const Bounds bounds = building_of(collection);
  return bounds.is_empty() ? std::nullopt : std::optional(bounds.middle());
}

std::vector<std::string> place(const std::string& path, const PlacementOptions& options,
                               FeatureCollection& collection) {
  std::vector<std::string> sentences;
  if (options.is_geographic != false && bounds_of(collection, true).looks_swapped()) {
    for (Feature& feature : collection.features)
      visit_positions(feature.shapes, [](Point& p) { p = Point(p.y(), p.x()); });
    sentences.push_back("doubtful: positions have the latitude first, and were turned around");
  }
  if (is_in_degrees(options, collection, sentences)) {
    sentences.push_back(project(path, options, collection));
    return sentences;
  }
  if (options.unit.empty() && !options.is_geographic && collection.crs.empty())
    expect_building(path, building_of(collection));
  if (const std::string doubt = doubt_about_pixels(options, collection); !doubt.empty()) sentences.push_back(doubt);
  if (options.y_down)
    for (Feature& feature : collection.features) visit_positions(feature.shapes, [](Point& p) { p.y() = -p.y(); });
  const double metres_per_unit = options.unit.empty() ? 1 : length_unit_called(options.unit)->metres;
  const Bounds bounds = building_of(collection);
  Point origin_m = options.origin_m;
  if (const Point far_m = origin_of_far_plan(metres_per_unit * bounds.low, metres_per_unit * bounds.high);
      !bounds.is_empty() && origin_m.isZero() && !far_m.isZero()) {
    origin_m = far_m;
    sentences.push_back(sentence_about_far_origin(far_m));
  }
  for (Feature& feature : collection.features)
    visit_positions(feature.shapes, [&](Point& p) { p = metres_per_unit * p - origin_m; });
  sentences.push_back(sentence_about_lengths(options, collection.crs));
  if (const std::string doubt = doubt_about_doors(options, collection); !doubt.empty()) sentences.push_back(doubt);
  return sentences;
}

}  // namespace opal::geojson_importer
