#pragma once

#include <opal/map/map_store.hpp>
#include "deployment/store_source.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace opal::session {

/// The last map that was pulled from a store, per store and source, so that a robot starts without its server. A file
/// each, written whole or not at all.
class MapCache {
 public:
  /// OPAL_MAP_CACHE, or opal/maps in XDG_CACHE_HOME, or in ~/.cache. No cache if OPAL_MAP_CACHE is empty, or if there
  /// is no home either.
  static MapCache usual();
  /// @param folder  made when needed; empty: nothing is kept.
  explicit MapCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  struct Entry {
    opal::StoredMap map;
    std::string pulled_at;  ///< UTC, by this machine's clock: "2026-11-21T14:02:11Z"
    std::string file;
  };

  /// @param where  which store: MapStore::where().
  /// @throws opal::Error if the file is there and unusable.
  std::optional<Entry> find(const std::string& where, const opal::StoreSource& source) const;
  /// @return the file; empty if nothing is kept. @throws opal::Error if it cannot be written.
  std::string keep(const std::string& where, const opal::StoreSource& source, const opal::StoredMap& map) const;

 private:
  std::filesystem::path file_of(const std::string& where, const opal::StoreSource& source) const;
  std::filesystem::path folder_;
};

}  // namespace opal::session
