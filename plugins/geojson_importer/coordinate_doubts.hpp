#pragma once

#include "placement.hpp"
#include "plan_elements.hpp"

#include <string>

namespace opal::geojson_importer {

/// About coordinates that look like those of an image, whose y runs downwards, before they are placed: a sentence that
/// begins with "doubtful", or empty. Nothing is said of degrees, of coordinates with a crs, and of those whose unit and
/// direction are options.
std::string doubt_about_pixels(const PlacementOptions& options, const FeatureCollection& collection);

/// About doors of a plan in metres that are wider or narrower than doors are: a sentence that begins with "doubtful",
/// or empty. Nothing is said where an option gives the unit, and of degrees.
/// @param collection  after it was placed.
std::string doubt_about_doors(const PlacementOptions& options, const FeatureCollection& collection);

}  // namespace opal::geojson_importer
