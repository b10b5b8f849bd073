#include "coordinate_doubts.hpp"

#include <opal/common/quantile.hpp>
#include <opal/import_kit/length_unit.hpp>

#include <fmt/format.h>

#include <Eigen/Geometry>

#include <cmath>

namespace opal::geojson_importer {
namespace {

// Images of plans are larger, and buildings that are drawn in whole metres are smaller.
constexpr double kSmallestImage_px = 200;
constexpr std::size_t kFewPositions = 8;
// Doors are 0.6 to 2 m wide, those with two leaves included. The smallest factor between units mixed up is 2.54.
constexpr double kNarrowDoor_m = 0.6, kWideDoor_m = 2;
constexpr double kTooNarrow_m = 0.4, kTooWide_m = 2.6;
constexpr std::size_t kFewDoors = 3;

/// The longest side of what a feature draws; 0: it is a point.
double extent_of(const Feature& feature) {
  Eigen::AlignedBox2d box;
  visit_positions(feature.shapes, [&](const Point& p) { box.extend(p); });
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

}  // namespace

std::string doubt_about_pixels(const PlacementOptions& options, const FeatureCollection& collection) {
  const bool is_known = options.y_down || !options.unit.empty() || options.is_geographic.has_value();
  if (is_known || !collection.crs.empty()) return "";
  Eigen::AlignedBox2d box;
  std::size_t positions = 0;
  bool is_whole = true;
  for (const Feature& feature : collection.features)
    if (feature.is_used && feature.damage.empty())
      visit_positions(feature.shapes, [&](const Point& p) {
        ++positions;
        box.extend(p);
        is_whole = is_whole && p.x() == std::floor(p.x()) && p.y() == std::floor(p.y());
      });
  if (!is_whole || positions < kFewPositions || box.min().minCoeff() < 0 || box.sizes().maxCoeff() < kSmallestImage_px)
    return "";
  return fmt::format(
      "doubtful: all coordinates are whole numbers from 0 on, up to {:.0f} and {:.0f}, as those of an image are: then "
      "y runs downwards, and the plan is mirrored; expected metres, y upwards (--set y_down=true, and unit= with the "
      "length of a pixel in metres)",
      box.max().x(), box.max().y());
}

std::string doubt_about_doors(const PlacementOptions& options, const FeatureCollection& collection) {
  if (!options.unit.empty()) return "";
  std::vector<double> widths_m;
  for (const Feature& feature : collection.features)
    if (feature.is_used && feature.damage.empty() && feature.type == "opal:Door")
      if (const double width_m = extent_of(feature); width_m > 0) widths_m.push_back(width_m);
  if (widths_m.size() < kFewDoors) return "";
  const double width_m = upper_median_of(widths_m);
  if (width_m >= kTooNarrow_m && width_m <= kTooWide_m) return "";
  return fmt::format(
      "doubtful: doors are {:.2f} m wide (median of {}), expected {} to {} m, are coordinates in metres?{}", width_m,
      widths_m.size(), kNarrowDoor_m, kWideDoor_m, length_units_that_fit(width_m, kNarrowDoor_m, kWideDoor_m));
}

}  // namespace opal::geojson_importer
