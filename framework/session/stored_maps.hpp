#pragma once

#include <opal/map/map_store.hpp>
#include <opal/plugin/plugin_registry.hpp>
#include "deployment/store_source.hpp"

#include <memory>
#include <optional>
#include <string>

namespace opal::session {

/// The type of the map store that a plugin offers; of several, the one that OPAL_MAP_STORE names.
/// @throws opal::PluginError if there is none, or no telling which.
std::string map_store_type(const opal::PluginRegistry& registry);

/// The map store that a plugin offers; of several, the type that OPAL_MAP_STORE names.
/// @throws opal::PluginError if there is none, or no telling which.
std::shared_ptr<const opal::MapStore> map_store(const opal::PluginRegistry& registry);

/// A map, and which version of the map store it is.
struct VersionedMap {
  std::shared_ptr<const opal::SemanticMap> map;
  std::optional<opal::StoreSource> version;  ///< with its number; nothing if the map does not come from the store
};

/// The map of a source "store:...", straight from the store, which is kept in the cache; from the cache, with a word on
/// stderr, if the store cannot be reached. Says on stderr which version it is.
VersionedMap load_stored_map(const opal::PluginRegistry& registry, const opal::StoreSource& source);

/// "version 3 of 'hall', pushed 2026-11-21T14:02:11Z by ann: moved the east wall"
std::string described(const opal::StoredVersion& version);

}  // namespace opal::session
