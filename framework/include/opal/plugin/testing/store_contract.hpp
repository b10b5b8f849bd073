#pragma once

#include <opal/map/map_store.hpp>
#include <opal/plugin/registrar.hpp>

#include <string>
#include <vector>

namespace opal::testing {

/// What every map store promises that can be tried without a server, and without touching one: it says where it is
/// without connecting and without secrets, and refuses what no store can do with a StoreError.
/// @return violations, one sentence each; empty for a good citizen.
OPAL_EXPORT std::vector<std::string> map_store_violations(const MapStore& store, const TypeInfo& type);

/// The rest of the contract (map_store.hpp), with a store that works: maps come back as they were, versions count up
/// per building, an expectation that fails leaves nothing, unknown buildings and versions are errors, spatial questions
/// have the answers of a MapView.
/// @param store     has a server that answers.
/// @param type      as the plugin registers it.
/// @param building  must be new to the store; versions of it stay behind.
OPAL_EXPORT std::vector<std::string> live_map_store_violations(const MapStore& store, const TypeInfo& type,
                                                               const std::string& building);

}  // namespace opal::testing
