#pragma once

#include "server.hpp"

#include <opal/map/map_store.hpp>

#include <string>

namespace opal::postgis_store {

/// In single quotes, for messages.
std::string quoted(const std::string& text);

/// @throws StoreError if it is empty or has control characters. @param what  whose name: "building".
void expect_name(const std::string& what, const std::string& name);
/// @throws StoreError if it is below 0.
void expect_version(int version);
/// Texts of PostgreSQL end at a character zero, which JSON writes as \u0000. @throws StoreError naming `what`.
void expect_storable(const std::string& text, const std::string& what);

/// SQL: a point in time as UTC, "2026-11-21T14:02:11Z".
std::string utc_of(const std::string& column);

/// The columns of opal.versions that version_of takes.
std::string version_columns();
StoredVersion version_of(const Row& row);

struct FoundVersion {
  std::string map;  ///< id in the database
  StoredVersion version;
};
/// @param version  0: the newest. @throws StoreError telling which versions there are.
FoundVersion find_version(Session& session, const std::string& where, const std::string& building, int version);

}  // namespace opal::postgis_store
