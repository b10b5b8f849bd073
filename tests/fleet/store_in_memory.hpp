#pragma once

#include "common/digest/sha256.hpp"

#include <opal/map/map_store.hpp>

#include <map>
#include <string>
#include <vector>

namespace opal::made {

/// Keeps evidence as the contract of MapStore says, and fails when a test wants it to. It has no maps.
class StoreInMemory final : public MapStore {
 public:
  std::string where() const override { return "the store of a test"; }
  StoredVersion push(const SemanticMap&, const MapPush&) const override { throw StoreError("no maps here"); }
  StoredMap pull(const std::string&, int) const override { throw StoreError("no maps here"); }
  std::vector<StoredVersion> list(const std::string&) const override { return {}; }
  std::vector<NearFeature> features_near(const NearQuery&) const override { return {}; }

  int add_evidence(const std::string& building, int version, const std::vector<std::string>& documents) const override {
    if (is_away) throw StoreUnreachable("away");
    if (building == unknown) throw StoreError("has no map of building " + building);
    int added = 0;
    for (const std::string& document : documents)
      added += kept[{building, version}].emplace(sha256_of(document), document).second ? 1 : 0;
    if (breaks_after_commit) throw StoreUnreachable("the connection broke in the very moment of the commit");
    return added;
  }

  std::vector<StoredEvidence> evidence(const std::string& building, int version) const override {
    if (is_away) throw StoreUnreachable("away");
    std::vector<StoredEvidence> all;
    for (const auto& [digest, document] : kept[{building, version}])
      all.push_back({"2026-11-21T14:02:11Z", "robot-7", document});
    return all;
  }

  bool is_away = false, breaks_after_commit = false;
  std::string unknown = "";  ///< a building that the store does not have
  mutable std::map<std::pair<std::string, int>, std::map<std::string, std::string>> kept;
};

}  // namespace opal::made
