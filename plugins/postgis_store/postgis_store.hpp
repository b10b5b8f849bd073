#pragma once

#include "server.hpp"

#include <opal/map/map_store.hpp>

namespace opal::postgis_store {

/// Maps in PostgreSQL with PostGIS; the tables are those of schema_1.sql and schema_2.sql.
class PostgisStore final : public MapStore {
 public:
  explicit PostgisStore(const ServerOptions& options) : server_(options) {}

  std::string where() const override { return server_.where(); }
  StoredVersion push(const SemanticMap& map, const MapPush& request) const override;
  StoredMap pull(const std::string& building, int version) const override;
  std::vector<StoredVersion> list(const std::string& building) const override;
  std::vector<NearFeature> features_near(const NearQuery& query) const override;
  int add_evidence(const std::string& building, int version, const std::vector<std::string>& documents) const override;
  std::vector<StoredEvidence> evidence(const std::string& building, int version) const override;

 private:
  Server server_;
};

}  // namespace opal::postgis_store
