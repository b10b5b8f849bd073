#include "cli/options/damage_options.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/options/number_option.hpp"
#include "cli/options/verbs.hpp"
#include "cli/options/world_options.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "session/session.hpp"
#include "session/shipped_files.hpp"

#include "simulation/beam_statistics.hpp"
#include "simulation/drives/recording.hpp"
#include "simulation/drives/storey_drives.hpp"

#include <opal/common/error.hpp>
#include <opal/sensing/replay.hpp>
#include "common/phrases.hpp"
#include "common/stage_clock.hpp"
#include "drawing/drawing.hpp"
#include "evaluation/ground_truth.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <optional>

namespace opal::cli {
namespace {

namespace sim = simulation;

struct SimulateOptions : WorldOptions {
  std::string map, out, along, config;
  sim::DriveOptions drives;
  double fov_deg = 270, mount_x_m = 0.2;
  DamageOptions damage;
};

void set_laser(SimulateOptions& options) {
  if (!options.along.empty()) {
    options.world.laser = read_site_laser(options.along + ".info.json");
    return;
  }
  if (!options.config.empty()) {
    const Deployment deployment = read_deployment(session::config_file(options.config));
    if (!deployment.describes_laser || deployment.lasers.front().geometry_from_log)
      throw ConfigError(deployment.file + ": /sensor: describes no laser, expected one to simulate");
    return options.take_laser(deployment);
  }
  LaserModel& laser = options.world.laser;
  constexpr double kDegree_rad = radians(1);
  const double fov_deg = laser.beams > 1 ? options.fov_deg : 0;  // one beam looks straight ahead
  laser.angle_min_rad = -fov_deg / 2 * kDegree_rad;
  laser.angle_increment_rad = laser.beams > 1 ? fov_deg * kDegree_rad / (laser.beams - 1) : kDegree_rad;
  laser.T_base_laser = Pose2(options.mount_x_m, 0, 0);
  laser.range_sigma_m = std::max(0.005, options.world.laser_errors.range_sigma_m);
}

/// What the map holds, with all doors shut.
sim::RayCaster mapped_solids(const SemanticMap& map) {
  Random closed(1);
  return sim::RayCaster(sim::building_solids(map, 0, closed));
}

sim::BeamStatistics beams_of(const sim::Recording& made, const sim::RayCaster& mapped) {
  sim::BeamStatistics simulated;
  for (const sim::RecordedScan& scan : made.scans)
    sim::count_beams(scan.scan, scan.T_map_base * made.laser.T_base_laser, made.laser, mapped, simulated);
  return simulated;
}

/// Of the recording along whose way the robot drives.
sim::BeamStatistics recorded_beams(const PluginRegistry& registry, const SimulateOptions& options,
                                   const GroundTruth& truth, const sim::RayCaster& mapped) {
  const LaserModel laser = read_site_laser(options.along + ".info.json");
  sim::BeamStatistics recorded;
  for (const LogRecord& record : read_all(*session::open_log(registry, options.along + ".log.gz")))
    if (const auto* scan = std::get_if<RawScan>(&record))
      if (const auto pose = truth.T_map_laser_at(scan->stamp_s))
        sim::count_beams(*scan, *pose, laser, mapped, recorded);
  return recorded;
}

/// The files of a recording are written beside each other: its map must not be the one that is driven in.
void expect_other_place(const SimulateOptions& options) {
  std::error_code absent;
  for (const char* ending : {".map.jsonld", ".map.yaml"})
    if (std::filesystem::equivalent(options.map, options.out + ending, absent))
      throw ConfigError(options.out + ending + ": is the map that is driven in, expected another PREFIX to write");
}

void tell_written(const std::string& prefix) {
  std::cout << "written: " << prefix
            << ".log.gz, .gt.csv, .info.json, .queries.json, .map.jsonld, .map.yaml, .map.pgm\n";
}

/// Drives on every storey of a map that holds several.
int simulate_storeys(const SimulateOptions& options, const SemanticMap& map, const SemanticMap& building) {
  if (!options.along.empty())
    throw ConfigError("--along: takes a map of one storey, found " + options.map + " with several");
  const sim::Recording recording = sim::record_on_storeys(building, options.world, options.drives, options.damage.seed);
  const StopSignals all_or_none;
  sim::write_recorded_place(recording, map, options.out);
  fmt::print("{} on {}, {} scans\n", count_of(recording.queries.size(), "drive"),
             count_of(map.origin().storeys.size(), "storey"), recording.scans.size());
  tell_written(options.out);
  return kDone;
}

int simulate(SimulateOptions options) {
  expect_other_place(options);
  set_laser(options);
  const PluginRegistry registry = session::load_plugins();
  const auto map = session::load_map(registry, options.map);
  options.furnish(registry, *map);
  const auto building = options.damage.any() ? damaged_map(*map, options.damage.damage()) : map;
  if (!map->origin().storeys.empty()) return simulate_storeys(options, *map, *building);
  const double start_s = process_cpu_s();
  sim::Simulation simulation(building, options.world, options.damage.seed);
  const double ready_s = process_cpu_s();
  std::optional<GroundTruth> truth;
  if (!options.along.empty()) truth = GroundTruth::read(options.along + ".gt.csv");
  const sim::Recording recording = truth
                                       ? sim::record_along(simulation, truth->poses())
                                       : sim::record(simulation, options.drives, Random(options.damage.seed).branch());
  const double recorded_s = process_cpu_s();
  const sim::RayCaster mapped = mapped_solids(*map);
  const sim::BeamStatistics beams = beams_of(recording, mapped);
  if (truth)
    std::cout << sim::side_by_side("recorded", recorded_beams(registry, options, *truth, mapped), "simulated", beams);
  const StopSignals all_or_none;  // Ctrl-C among these files would leave new ones beside old ones
  sim::write_recorded_place(recording, *map, options.out);
  double driven_m = 0;
  for (double distance_m : recording.distances_m) driven_m += distance_m;
  fmt::print("{:.0f} m2 of floor, {} things that a beam can meet, {} people\n", simulation.floor().area_m2(),
             simulation.solids().solids().size(), options.world.people);
  fmt::print("{}, {:.0f} m, {} scans; {} steps in which somebody or something was in the way\n",
             count_of(recording.queries.size(), "drive"), driven_m, recording.scans.size(), recording.stops);
  fmt::print("{:.0f} % of the beams end before the first mapped surface\n", 100.0 * beams.early / beams.beams());
  fmt::print("CPU {:.2f} s to furnish, {:.2f} s to drive\n", ready_s - start_s, recorded_s - ready_s);
  tell_written(options.out);
  return kDone;
}

void add_drives(CLI::App& verb, SimulateOptions& o) {
  add_number(verb, "--drives", o.drives.drives, 1, 100000, "each from a place of its own");
  add_number(verb, "--distance", o.drives.distance_m, 0.1, 1e5, "of each drive [m]");
  add_number(verb, "--speed", o.drives.follower.speed_mps, 0.01, 10.0, "[m/s]");
  add_number(verb, "--turn", o.drives.follower.turn_radps, 0.01, 10.0, "[rad/s]");
  add_number(verb, "--scan-every", o.drives.scan_every_s, 0.01, 60.0, "[s]");
}

void add_sensing(CLI::App& verb, SimulateOptions& o) {
  add_number(verb, "--fov", o.fov_deg, 1.0, 360.0, "of the laser [deg]");
  add_number(verb, "--beams", o.world.laser.beams, 1, 100000, "of the laser");
  add_number(verb, "--range", o.world.laser.range_max_m, 0.1, 1000.0, "of the laser [m]");
  verb.add_option("--sweep", o.world.laser.sweep_s, "time from the first beam to the last [s] (default: all at once)")
      ->check(in_range(0.0, 1.0));
  add_number(verb, "--mount-x", o.mount_x_m, -10.0, 10.0, "laser before the robot's centre [m]");
  add_number(verb, "--range-sigma", o.world.laser_errors.range_sigma_m, 0.0, 1.0, "of a reading [m]");
  add_number(verb, "--missed", o.world.laser_errors.missed_share, 0.0, 1.0, "share of beams that are lost");
  add_number(verb, "--mixed", o.world.laser_errors.mixed_share, 0.0, 1.0,
             "share of beams at an edge that report something in between");
  add_number(verb, "--glass", o.world.laser_errors.glass_share, 0.0, 1.0, "share of beams that glass sends back");
  add_number(verb, "--slips", o.world.odometry_errors.slips_per_m, 0.0, 10.0, "of a wheel, per metre");
  add_number(verb, "--odometry-sigma", o.world.odometry_errors.sigma_m_per_sqrt_m, 0.0, 1.0,
             "along the way [m per square root of m]");
  add_number(verb, "--heading-sigma", o.world.odometry_errors.sigma_rad_per_sqrt_m, 0.0, 1.0,
             "[rad per square root of m]");
}

void add_config(CLI::App& verb, SimulateOptions& o) {
  CLI::Option* config =
      verb.add_option("--config", o.config, "deployment, or the name of one that ships: its laser is simulated");
  for (const char* other : {"--along", "--fov", "--beams", "--range", "--mount-x"})
    config->excludes(verb.get_option(other));
}

}  // namespace

void add_simulate_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<SimulateOptions>();
  CLI::App* verb =
      app.add_subcommand("simulate", "drive through a building that does not exist: a recording with ground truth");
  verb->add_option("MAP", options->map, "map document, or a source to import")->required();
  verb->add_option("-o,--out", options->out, "PREFIX of the files to write, as opal bench takes it")->required();
  verb->add_option("--along", options->along,
                   "PREFIX of a recording (.gt.csv, .info.json, .log.gz): the same laser on the same way, and its "
                   "beams side by side");
  add_drives(*verb, *options);
  options->add_to(*verb);
  options->damage.add_to(*verb);  // of what stands: the map that is written is the undamaged one
  verb->get_option("--seed")->description("of everything: the same seed gives the same files");
  add_sensing(*verb, *options);
  add_config(*verb, *options);
  verb->callback([options, &exit_code] { exit_code = simulate(*options); });
}

}  // namespace opal::cli
