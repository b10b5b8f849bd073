// What drives say of maps: the table opal.drive_evidence.
#include "postgis_store.hpp"
#include "schema.hpp"
#include "versions.hpp"

#include <fmt/format.h>

#include <set>

namespace opal::postgis_store {
namespace {

constexpr const char* kInsertEvidence =
    "INSERT INTO opal.drive_evidence (map, digest, document) "
    "VALUES ($1::bigint, encode(sha256(convert_to($2, 'UTF8')), 'hex'), $2::jsonb) "
    "ON CONFLICT DO NOTHING RETURNING digest";

const std::string kSelectEvidence = "SELECT " + utc_of("added_at") +
                                    ", added_by, document FROM opal.drive_evidence WHERE map = $1::bigint "
                                    "ORDER BY digest COLLATE \"C\"";

}  // namespace

int PostgisStore::add_evidence(const std::string& building, int version,
                               const std::vector<std::string>& documents) const {
  expect_name("building", building);
  if (version < 1) throw StoreError(fmt::format("evidence of version {}, expected a number from 1 on", version));
  for (const std::string& document : documents) expect_storable(document, "evidence " + document.substr(0, 120));
  const std::set<std::string> sorted(documents.begin(), documents.end());  // two robots never wait for each other
  int added = 0;
  server_.transact([&](Session& session) {
    require_schema(session, where(), kEvidenceSince);
    const FoundVersion found = find_version(session, where(), building, version);
    for (const std::string& document : sorted)
      added += static_cast<int>(session.ask(kInsertEvidence, {found.map, document}).size());
  });
  return added;
}

std::vector<StoredEvidence> PostgisStore::evidence(const std::string& building, int version) const {
  expect_name("building", building);
  expect_version(version);
  std::vector<StoredEvidence> evidence;
  server_.read([&](Session& session) {
    require_schema(session, where(), kEvidenceSince);
    const FoundVersion found = find_version(session, where(), building, version);
    for (const Row& row : session.ask(kSelectEvidence, {found.map}))
      evidence.push_back({row.at(0), row.at(1), row.at(2)});
  });
  return evidence;
}

}  // namespace opal::postgis_store
