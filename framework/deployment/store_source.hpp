#pragma once

#include <opal/common/export.hpp>

#include <optional>
#include <string>

namespace opal {

/// A map in the map store, as it is written wherever a map is asked for: "store:hall" is the newest version of the map
/// of building "hall", "store:hall@3" its version 3. A name that itself ends in @ and a number is written with
/// "@newest" or a number after it.
struct StoreSource {
  std::string building;
  int version = 0;  ///< 0: the newest
};

/// @return nothing if the text does not begin with "store:". @throws ConfigError for "store:" without a building, and
/// for versions that are no number from 1 on.
OPAL_EXPORT std::optional<StoreSource> read_store_source(const std::string& text);
/// "store:hall", "store:hall@3": read_store_source gives the same again.
OPAL_EXPORT std::string text_of(const StoreSource& source);

}  // namespace opal
