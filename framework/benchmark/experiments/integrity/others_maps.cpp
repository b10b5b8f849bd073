// Maps that were not handed over by who built the house: those that others draw, and those that drives have mended.
#include "benchmark/experiments/integrity/drive_world.hpp"
#include "learning/learned_overlay.hpp"
#include "map/overlay/map_overlay.hpp"
#include "map_tools/cone_mapping.hpp"
#include "session/session.hpp"

#include <opal/sensing/replay.hpp>

#include <fmt/format.h>

namespace opal::experiments {
namespace {

constexpr double kMappingDrive_s = 300, kLearningDrive_s = 150, kEveryScan_s = 0.5;
constexpr int kLearningDrives = 3;

/// A drive before the one that is judged, by day: people, what stands about.
DrawnDrive earlier_drive(const DrawnDrive& drive, std::uint64_t number, double duration_s) {
  DrawnDrive earlier = drive;
  earlier.is_kidnapped = false;
  earlier.fault = simulation::Fault::none;
  earlier.has_two_lasers = false;
  earlier.duration_s = duration_s;
  earlier.seed = drive.seed + 1'000'003 * number;
  return earlier;
}

std::vector<PlacedScan> placed_scans(const simulation::Recording& recording) {
  std::vector<PlacedScan> scans;
  double next_s = 0;
  for (const simulation::RecordedScan& recorded : recording.scans) {
    if (recorded.scan.stamp_s < next_s) continue;
    next_s = recorded.scan.stamp_s + kEveryScan_s;
    scans.push_back({make_scan(recorded.scan, recording.laser), recorded.T_map_base * recording.laser.T_base_laser});
  }
  return scans;
}

/// A grid as a file, as others hand it over.
class GridFile {
 public:
  GridFile(const std::filesystem::path& scratch, const DrawnDrive& drive)
      : stem_((scratch / fmt::format("redrawn-{}", drive.number)).string()) {}
  ~GridFile() {
    std::error_code ignored;
    for (const char* extension : {".map.yaml", ".map.pgm"}) std::filesystem::remove(stem_ + extension, ignored);
  }
  GridFile(const GridFile&) = delete;
  GridFile& operator=(const GridFile&) = delete;
  std::string yaml() const { return stem_ + ".map.yaml"; }

 private:
  std::string stem_;
};

DriveEvidence evidence_of(const simulation::Recording& recording, const LocalizerParts& parts, int number) {
  const std::vector<LogRecord> records = records_of(recording);
  Replay replay(records, {recording.laser});
  DriveObserver observer(parts);
  while (const auto sample = replay.next()) observer.update(*sample);
  return observer.finish(fmt::format("drive {}", number));
}

}  // namespace

std::shared_ptr<const SemanticMap> redrawn_map(const std::shared_ptr<const SemanticMap>& building,
                                               const DrawnDrive& drive, const CampaignRobots& robots,
                                               const std::filesystem::path& scratch) {
  DrawnDrive by_night = earlier_drive(drive, 1, kMappingDrive_s);
  by_night.people = 0;
  by_night.clutter = by_night.along_walls = 0;
  by_night.doors_open_share = 1;
  const simulation::Recording recording = recorded(by_night, {building, building}, robots.one_laser);
  ConeMapping mapping;
  mapping.seed = drive.seed;
  const GridFile grid(scratch, drive);
  write_raster(cone_mapped(placed_scans(recording), mapping), grid.yaml());
  return load_map(*robots.registry, grid.yaml());
}

std::shared_ptr<const SemanticMap> learned_map(const std::shared_ptr<const SemanticMap>& building,
                                               const std::shared_ptr<const SemanticMap>& wrong, const DrawnDrive& drive,
                                               const CampaignRobots& robots) {
  const LocalizerParts parts = build_parts(robots.one_laser, *robots.registry, wrong);
  std::vector<DriveEvidence> evidence;
  for (int k = 1; k <= kLearningDrives; ++k) {
    const DrawnDrive earlier = earlier_drive(drive, static_cast<std::uint64_t>(k), kLearningDrive_s);
    evidence.push_back(evidence_of(recorded(earlier, {building, wrong}, robots.one_laser), parts, k));
  }
  constexpr double kLeastProbability = 0.9;  // as opal learn writes it
  const nlohmann::ordered_json overlay =
      overlay_of(*wrong, learned_from(*wrong, evidence), robots.one_laser.lasers.front().id, kLeastProbability);
  return overlaid_map(*wrong, {parse_overlay(overlay.dump(), "learned")}).map;
}

}  // namespace opal::experiments
