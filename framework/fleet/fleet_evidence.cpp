#include "fleet/fleet_evidence.hpp"

#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>

#include <map>
#include <utility>

namespace opal {
namespace {

DriveEvidence drive_on(const std::string& map_name, const StoredEvidence& stored, const std::string& place) {
  DriveEvidence drive = drive_evidence_from(parse_json(stored.document, place), place);
  if (drive.map == map_name) return drive;
  throw ConfigError(place + ": " + drive.drive + " tells of the map \"" + drive.map + "\", expected \"" + map_name +
                    "\"");
}

using Version = std::pair<std::string, int>;  // building, number

void send(const MapStore& store, const Version& version, const std::vector<EvidenceOutbox::Entry>& entries,
          SentEvidence& sent) {
  std::vector<std::string> documents;
  for (const EvidenceOutbox::Entry& entry : entries) documents.push_back(entry.document);
  sent.added += store.add_evidence(version.first, version.second, documents);
  sent.confirmed += entries.size();
  for (const EvidenceOutbox::Entry& entry : entries) EvidenceOutbox::confirm(entry);
}

}  // namespace

FleetEvidence evidence_in(const MapStore& store, const StoreSource& version, const std::string& map_name) {
  FleetEvidence evidence;
  for (const StoredEvidence& stored : store.evidence(version.building, version.version)) {
    const std::string place = "evidence of " + stored.added_by + " from " + stored.added_at;
    try {
      evidence.drives.push_back(drive_on(map_name, stored, place));
    } catch (const Error& error) {
      evidence.refused.push_back(error.what());
    }
  }
  return evidence;
}

std::string objection_to_push(const Deployment& deployment) {
  if (!read_store_source(deployment.map)) return "--push with the map " + deployment.map + ", expected store:BUILDING";
  if (deployment.overlays.empty()) return "";
  return "--push with overlays: drives would tell of another map than the store has";
}

SentEvidence send_waiting(const MapStore& store, const EvidenceOutbox& outbox) {
  std::map<Version, std::vector<EvidenceOutbox::Entry>> by_version;
  for (EvidenceOutbox::Entry& entry : outbox.waiting_for(store.where()))
    by_version[{entry.version.building, entry.version.version}].push_back(std::move(entry));
  SentEvidence sent;
  for (const auto& [version, entries] : by_version) try {
      send(store, version, entries, sent);
    } catch (const StoreUnreachable&) {
      throw;
    } catch (const StoreError& refusal) {
      sent.refused.push_back(refusal.what());
    }
  return sent;
}

}  // namespace opal
