#pragma once

#include "server.hpp"

namespace opal::postgis_store {

extern const char* const kSchema1;  ///< of schema_1.sql, built in

/// The version of the tables that this program reads and writes.
inline constexpr int kSchemaVersion = 1;

/// @throws StoreError if the database has no map store, or one of another version, saying what to do.
void require_schema(Session& session, const std::string& where);
/// Makes the tables, or brings them up to date, in this transaction. @throws StoreError if they are newer than the
/// program.
void bring_up_to_date(Session& session, const std::string& where);

}  // namespace opal::postgis_store
