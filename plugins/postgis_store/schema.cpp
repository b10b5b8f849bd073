#include "schema.hpp"

#include <opal/map/map_store.hpp>

#include <fmt/format.h>

namespace opal::postgis_store {
namespace {

/// Number k leads from version k to k + 1.
const char* const kMigrations[] = {kSchema1, kSchema2};
static_assert(sizeof kMigrations / sizeof *kMigrations == kSchemaVersion);

/// Of pushes that come first at the same time, one makes the tables. Any number will do that others do not use.
constexpr const char* kSchemaLock = "SELECT pg_advisory_xact_lock(7307128014)";

/// 0: there are no tables.
int version_in(Session& session) {
  if (session.ask("SELECT to_regclass('opal.schema_version') IS NOT NULL")[0][0] != "t") return 0;
  return std::stoi(session.ask("SELECT coalesce(max(version), 0) FROM opal.schema_version")[0][0]);
}

[[noreturn]] void refuse_newer(const std::string& where, int version) {
  throw StoreError(fmt::format("{}: the map store has schema version {}, this program knows up to {}; use a newer Opal",
                               where, version, kSchemaVersion));
}

}  // namespace

void require_schema(Session& session, const std::string& where, int least) {
  const int version = version_in(session);
  if (version > kSchemaVersion) refuse_newer(where, version);
  if (version == 0) throw StoreError(where + ": holds no map store yet; the first opal map push makes it");
  if (version < least)
    throw StoreError(
        fmt::format("{}: the map store has schema version {}, this needs {}; the next opal map push, by the role that "
                    "made it, brings it there",
                    where, version, least));
}

void bring_up_to_date(Session& session, const std::string& where) {
  int version = version_in(session);
  if (version == kSchemaVersion) return;
  session.ask(kSchemaLock);
  version = version_in(session);
  if (version > kSchemaVersion) refuse_newer(where, version);
  for (; version < kSchemaVersion; ++version) {
    session.run(kMigrations[version]);
    session.ask("INSERT INTO opal.schema_version (version) VALUES ($1)", {std::to_string(version + 1)});
  }
}

}  // namespace opal::postgis_store
