#pragma once

#include <opal/map/semantic_map.hpp>

#include <span>

namespace opal {

/// A feature that stands far away by mistake would take the memory of a country.
/// @param numbers  of the features that are looked at. @param size_m  of the box around them, along x and y.
/// Throws MapError, which names the feature that is farthest from the others, if the box is larger than 50 km x 50 km.
void expect_small_enough(const SemanticMap& map, std::span<const MapFeatureNumber> numbers, const Point& size_m);

}  // namespace opal
