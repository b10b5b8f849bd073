#pragma once

#include "fleet/evidence_outbox.hpp"
#include "learning/drive_evidence.hpp"

#include <opal/deployment/deployment.hpp>
#include <opal/map/map_store.hpp>

#include <string>
#include <vector>

namespace opal {

/// What a store has of the drives on one version of a map.
struct FleetEvidence {
  std::vector<DriveEvidence> drives;
  std::vector<std::string> refused;  ///< what is no evidence of a drive on this map: who added it when, and the reason
};

/// All that robots have added. What one of them added by mistake keeps nobody from the rest.
/// @param map_name  name of the map that drives must tell of.
/// @throws StoreError as the store does.
FleetEvidence evidence_in(const MapStore& store, const StoreSource& version, const std::string& map_name);

/// Why what drives say of a deployment's map cannot go to a map store (`--push`); empty: it can.
std::string objection_to_push(const Deployment& deployment);

/// What came of sending.
struct SentEvidence {
  std::size_t confirmed = 0;         ///< drives that the store has now
  int added = 0;                     ///< of these, drives that it did not have before
  std::vector<std::string> refused;  ///< why the store does not take the drives of some version; they wait on
};

/// Sends all that waits in the outbox for this store, the drives of one version at once; what the store confirms does
/// not wait any more. Two programs may send at the same time.
/// @throws StoreUnreachable as the store does; what it has not confirmed waits on.
SentEvidence send_waiting(const MapStore& store, const EvidenceOutbox& outbox);

}  // namespace opal
