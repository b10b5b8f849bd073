#pragma once

#include "server.hpp"

namespace opal::postgis_store {

extern const char* const kSchema1;  ///< of schema_1.sql, built in
extern const char* const kSchema2;  ///< of schema_2.sql, built in

/// The version of the tables that this program makes.
inline constexpr int kSchemaVersion = 2;
/// The first version with maps, and the first with evidence of drives.
inline constexpr int kMapsSince = 1, kEvidenceSince = 2;

/// @param least  the version that what follows needs.
/// @throws StoreError if the database has no map store, an older one, or one newer than the program, saying what to do.
void require_schema(Session& session, const std::string& where, int least = kMapsSince);
/// Makes the tables, or brings them up to date, in this transaction. @throws StoreError if they are newer than the
/// program.
void bring_up_to_date(Session& session, const std::string& where);

}  // namespace opal::postgis_store
