// Maps that were not handed over by who built the house: those that others draw, and those that drives have mended.
#include "benchmark/experiments/integrity/drive_world.hpp"
#include "learning/learned_overlay.hpp"
#include "map/overlay/map_overlay.hpp"
#include "map_tools/test_maps/cone_mapping.hpp"
#include "session/session.hpp"

#include <opal/sensing/replay.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace opal::experiments {
namespace {

constexpr double kLearningDrive_s = 150;
constexpr int kLearningDrives = 3;

/// A drive before the one that is judged: what stands about was elsewhere then.
DrawnDrive earlier_drive(const DrawnDrive& drive, std::uint64_t number) {
  DrawnDrive earlier = drive;
  earlier.is_kidnapped = false;
  earlier.fault = simulation::Fault::none;
  earlier.has_two_lasers = false;
  earlier.duration_s = kLearningDrive_s;
  earlier.seed = drive.seed + 1'000'003 * number;
  return earlier;
}

/// Places all over the floor, each near the one before: who maps a building goes into every room.
std::vector<Point> tour(const simulation::Floor& floor) {
  constexpr double kApart_m = 1.5;
  std::map<std::pair<long, long>, Point> open;  // one place of each square
  for (const auto& cell : floor.cells()) {
    const Point at = floor.center_of(cell);
    open.emplace(std::pair(std::lround(at.x() / kApart_m), std::lround(at.y() / kApart_m)), at);
  }
  std::vector<Point> places;
  while (!open.empty()) {
    const Point last = places.empty() ? open.begin()->second : places.back();
    const auto next = std::min_element(open.begin(), open.end(), [&](const auto& a, const auto& b) {
      return (a.second - last).squaredNorm() < (b.second - last).squaredNorm();
    });
    places.push_back(next->second);
    open.erase(next);
  }
  return places;
}

/// Scans along a tour, each taken towards the next place.
std::vector<PlacedScan> placed_scans(simulation::Simulation& simulation) {
  const LaserModel& laser = simulation.options().laser;
  const std::vector<Point> places = tour(simulation.floor());
  std::vector<PlacedScan> scans;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Point ahead = places[std::min(k + 1, places.size() - 1)] - places[k];
    simulation.place({places[k], std::atan2(ahead.y(), ahead.x())});
    scans.push_back({make_scan(simulation.scan(), laser), simulation.T_map_laser()});
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
  return observed_drive(parts, replay, fmt::format("drive {}", number));
}

}  // namespace

std::shared_ptr<const SemanticMap> redrawn_map(const std::shared_ptr<const SemanticMap>& building,
                                               const DrawnDrive& drive, const CampaignRobots& robots,
                                               const std::filesystem::path& scratch) {
  simulation::SimulationOptions by_night;
  by_night.laser = robots.one_laser.lasers.front();
  by_night.people = 0;
  by_night.clutter.level = 0;
  by_night.doors_open_share = 1;
  simulation::Simulation simulation(building, by_night, drive.seed);
  ConeMapping mapping;
  mapping.seed = drive.seed;
  const GridFile grid(scratch, drive);
  write_raster(cone_mapped(placed_scans(simulation), mapping), grid.yaml());
  return session::load_map(trusted_by(robots.one_laser, *robots.registry), grid.yaml());
}

std::shared_ptr<const SemanticMap> learned_map(const std::shared_ptr<const SemanticMap>& building,
                                               const std::shared_ptr<const SemanticMap>& wrong, const DrawnDrive& drive,
                                               const CampaignRobots& robots) {
  const LocalizerParts parts = build_parts(robots.one_laser, *robots.registry, wrong);
  std::vector<DriveEvidence> evidence;
  for (int k = 1; k <= kLearningDrives; ++k) {
    const DrawnDrive earlier = earlier_drive(drive, static_cast<std::uint64_t>(k));
    evidence.push_back(evidence_of(recorded(earlier, {building, wrong}, robots.one_laser), parts, k));
  }
  const nlohmann::ordered_json overlay =
      overlay_of(*wrong, learned_from(*wrong, evidence), robots.one_laser.lasers.front().id, kLeastProbability);
  return overlaid_map(*wrong, {parse_overlay(overlay.dump(), "learned")}).map;
}

}  // namespace opal::experiments
