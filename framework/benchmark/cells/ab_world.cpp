#include "benchmark/cells/ab_world.hpp"

#include "session/session.hpp"

#include "common/digest/sha256.hpp"

#include "benchmark/experiments/kit/thesis_robot.hpp"

#include <opal/common/error.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace opal::benchmark {
namespace {

namespace ab = opal::ab;
namespace sim = opal::simulation;

std::vector<opal::Query> queries_of(const ab::RecordedPlace& place) {
  const std::string file = place.prefix + ".queries.json";
  const std::vector<opal::Query> all = opal::read_queries(file);
  if (place.queries.empty()) return all;
  std::vector<opal::Query> chosen;
  for (const std::string& id : place.queries) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const opal::Query& query) { return query.id == id; });
    if (found == all.end())
      throw opal::ConfigError(file + ": holds no query \"" + id + "\", which the experiment asks for");
    chosen.push_back(*found);
  }
  return chosen;
}

std::string digest_of(const opal::SemanticMap& map) { return opal::sha256_of(map.to_json_ld().dump()); }

/// The bytes of numbers.
class Digest {
 public:
  Digest& add(double number) {
    hash_.add({reinterpret_cast<const char*>(&number), sizeof number});
    return *this;
  }
  Digest& add(const opal::Pose2& pose) { return add(pose.x()).add(pose.y()).add(pose.heading_rad()); }
  Digest& add(std::string_view text) {
    hash_.add(text);
    return *this;
  }
  Digest& add(const opal::LaserModel& laser) {
    return add(laser.angle_min_rad)
        .add(laser.angle_increment_rad)
        .add(double(laser.beams))
        .add(laser.range_min_m)
        .add(laser.range_max_m)
        .add(laser.no_return_m)
        .add(laser.range_sigma_m)
        .add(laser.T_base_laser);
  }
  std::string finish() { return hash_.finish(); }

 private:
  opal::Sha256 hash_;
};

std::string digest_of(const sim::Recording& recording) {
  Digest digest;
  for (const sim::RecordedScan& scan : recording.scans) {
    digest.add(scan.scan.stamp_s).add(scan.scan.T_odom_base.value_or(opal::Pose2()));
    for (const float range : scan.scan.ranges_m) digest.add(double(range));
  }
  return digest.finish();
}

opal::MapDamage damage_of(const ab::Scenario& scenario, std::uint64_t seed) {
  opal::MapDamage damage = opal::read_map_damage(scenario.damage);
  damage.seed = seed;
  return damage;
}

sim::ChallengeDrive driven(const ab::SimulatedDrives& drives, std::shared_ptr<const opal::SemanticMap> building,
                           std::uint64_t seed) {
  if (!drives.challenge) {
    sim::Simulation simulation(std::move(building), drives.world, seed);
    return {record(simulation, drives.drives, opal::Random(seed).branch()), std::nullopt};
  }
  for (const sim::Challenge& challenge : sim::thesis3_challenges())
    if (challenge.id == *drives.challenge)
      return drive(challenge, std::move(building), opal::experiments::thesis_robot(), drives.duration_s, seed);
  throw opal::ConfigError("challenge " + *drives.challenge + " is unknown");
}

opal::GroundTruth truth_of(const sim::Recording& recording) {
  std::vector<opal::StampedPose> poses;
  for (const sim::RecordedScan& scan : recording.scans)
    poses.push_back({scan.scan.stamp_s, scan.T_map_base * recording.laser.T_base_laser});
  return opal::GroundTruth(std::move(poses));
}

/// The image that a grid's description names, if it lies beside it; else "".
std::string image_beside(const std::string& yaml) {
  std::ifstream lines(yaml);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("image:")) continue;
    const std::size_t first = line.find_first_not_of(" \t'\"", std::string("image:").size());
    const std::size_t last = line.find_last_not_of(" \t\r'\"");
    const auto image =
        std::filesystem::path(yaml).parent_path() / (first > last ? "" : line.substr(first, last + 1 - first));
    return std::filesystem::is_regular_file(image) ? image.string() : "";
  }
  return "";
}

/// All that decides what a recorded place is.
std::vector<std::string> files_of(const ab::RecordedPlace& place) {
  std::vector<std::string> files;
  for (const char* ending :
       {".log.gz", ".info.json", ".queries.json", ".gt.csv", ".map.jsonld", ".map.yaml", ".map.pgm"})
    if (const std::string file = place.prefix + ending; std::filesystem::exists(file)) files.push_back(file);
  if (const std::string image = image_beside(place.prefix + ".map.yaml"); !image.empty()) files.push_back(image);
  return files;
}

}  // namespace

std::vector<std::string> WorldSource::queries(const ab::Scenario& scenario) const {
  std::vector<std::string> names;
  if (const auto* place = std::get_if<ab::RecordedPlace>(&scenario.source)) {
    for (const opal::Query& query : queries_of(*place)) names.push_back(query.id);
    return names;
  }
  const auto& drives = std::get<ab::SimulatedDrives>(scenario.source);
  for (int k = 1; k <= (drives.challenge ? 1 : drives.drives.drives); ++k) names.push_back(sim::query_name(k));
  return names;
}

nlohmann::ordered_json WorldSource::inputs(const ab::Scenario& scenario) {
  nlohmann::ordered_json digests;
  if (const auto* place = std::get_if<ab::RecordedPlace>(&scenario.source)) {
    for (const std::string& file : files_of(*place))
      digests[std::filesystem::path(file).filename().string()] = opal::sha256_of_file(file);
    return digests;
  }
  digests["map"] = digest_of(*map_of(scenario));
  return digests;
}

const WorldSource::Map& WorldSource::map_of(const ab::Scenario& scenario) {
  if (of_ == scenario.name) return map_;
  map_ = nullptr;
  if (const auto* place = std::get_if<ab::RecordedPlace>(&scenario.source)) {
    map_ = site_map(registry_, place->prefix, opal::read_map_damage(scenario.damage));
  } else {
    const auto& drives = std::get<ab::SimulatedDrives>(scenario.source);
    map_ = drives.building ? generate_building(*drives.building).map : session::load_map(registry_, drives.map);
  }
  of_ = scenario.name;
  return map_;
}

World WorldSource::make(const ab::Scenario& scenario, std::uint64_t seed) {
  const auto* place = std::get_if<ab::RecordedPlace>(&scenario.source);
  return place ? recorded(scenario, *place, seed)
               : simulated(scenario, std::get<ab::SimulatedDrives>(scenario.source), seed);
}

World WorldSource::recorded(const ab::Scenario& scenario, const ab::RecordedPlace& place, std::uint64_t seed) {
  Map map = map_of(scenario);
  if (!scenario.damage.empty()) map = opal::damaged_map(*map, damage_of(scenario, seed));
  const BenchSite site{place.prefix, scenario.name, map, opal::Pose2(), 0};
  World world{read_bench_place(registry_, site, experiment_.arms[experiment_.baseline].deployment),
              opal::GroundTruth::read(place.prefix + ".gt.csv"), std::nullopt, ""};
  world.place.queries = queries_of(place);
  std::string& log = log_digests_[place.prefix];
  if (log.empty()) log = opal::sha256_of_file(place.prefix + ".log.gz");
  world.digest = Digest().add(digest_of(*map)).add(log).add(world.place.deployment.lasers.front()).finish();
  return world;
}

World WorldSource::simulated(const ab::Scenario& scenario, const ab::SimulatedDrives& drives, std::uint64_t seed) {
  const Map map = map_of(scenario);
  const Map building = scenario.damage.empty() ? map : opal::damaged_map(*map, damage_of(scenario, seed));
  const sim::ChallengeDrive drive = driven(drives, building, seed);
  World world;
  world.place.site = {"", scenario.name, map, opal::Pose2(), 0};
  world.place.deployment = with_lasers(experiment_.arms[experiment_.baseline].deployment, {drive.recording.laser});
  world.place.queries = drive.recording.queries;
  for (const sim::RecordedScan& scan : drive.recording.scans) world.place.records.emplace_back(scan.scan);
  world.truth = truth_of(drive.recording);
  world.region = drive.region;
  Digest digest;
  digest.add(digest_of(*map)).add(digest_of(drive.recording)).add(drive.recording.laser);
  if (drive.region) digest.add(drive.region->center.x()).add(drive.region->center.y()).add(drive.region->radius_m);
  world.digest = digest.finish();
  return world;
}

}  // namespace opal::benchmark
