#pragma once

#include "tests/kit/shipped_plugins.hpp"

#include <opal/map/map_store.hpp>
#include <opal/map/semantic_map.hpp>

#include <memory>
#include <string>

namespace opal::store_tests {

using Map = std::shared_ptr<const SemanticMap>;

/// A store as a program makes it, on the server that the environment names now.
std::shared_ptr<const MapStore> store();

/// A document with everything that a map can have: another vocabulary about things known and unknown, prefixes,
/// geometry that nothing uses, two sensors, patterns, placements, shared points, odd characters, awkward numbers.
Map rich_map();
/// `features` features of all shapes over a square with 100 features per 30 m x 30 m, for two sensors and for none.
Map large_map(int features, unsigned seed);
/// The recorded hall, imported from its grid.
Map malaga();

}  // namespace opal::store_tests
