#include "benchmark/runs/progress_bar.hpp"
#include "cli/drive/drive_report.hpp"
#include "cli/drive/floor_picture.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/options/number_option.hpp"
#include "cli/options/verbs.hpp"
#include "cli/options/world_options.hpp"
#include "cli/terminal/run_end.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "session/session.hpp"
#include "session/shipped_files.hpp"

#include "closed_loop/drawn_goal.hpp"
#include "closed_loop/no_way.hpp"
#include "ipc/remote/remote_localization.hpp"
#include "map_tools/map_stack.hpp"
#include "navigation/node_registry.hpp"
#include "report/quantity_text.hpp"
#include "simulation/drives/drive_recording.hpp"

#include <opal/common/error.hpp>
#include <opal/deployment/deployment.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>

namespace opal::cli {
namespace {

namespace sim = simulation;
namespace navigation = navigation;

struct DriveVerbOptions : WorldOptions {
  std::string config, map, out = "out", behaviour, trees, localizer, record, storey;
  std::vector<double> goal, start;
  std::uint64_t seed = 1;
  int runs = 1;
  ClosedLoopOptions loop;
};

/// @throws ConfigError if the robot cannot be there, or cannot get there: why, and the name of a picture that shows
/// where it can be.
void check_place(const DriveVerbOptions& options, const sim::Simulation& simulation, const std::string& what,
                 const Point& place) {
  const std::string why = why_not_at(simulation, place);
  if (why.empty()) return;
  const std::string picture = draw_floor(simulation, place, options.out);
  throw ConfigError(what + place_text(place) + ": " + why + "; expected a place on the green floor of " + picture);
}

/// Goals beside something are for the nearest place where the robot has room.
Point given_goal(const DriveVerbOptions& options, const sim::Simulation& simulation) {
  const Point goal(options.goal[0], options.goal[1]);
  const auto near = simulation.floor().nearest(goal);
  if (!near)
    check_place(options, simulation, "--goal: no way from " + place_text(simulation.T_map_base().position()) + " to ",
                goal);
  return near.value_or(goal);
}

/// Draws what was not given, the same way for every behaviour.
/// @param floor  by which the robot plans.
DriveTask task_of(const DriveVerbOptions& options, sim::Simulation& simulation, const FloorGrid& floor,
                  std::uint64_t seed) {
  Random random(seed ^ 0x9e3779b97f4a7c15u);
  if (!options.start.empty()) {
    const Pose2 start(options.start[0], options.start[1], options.start[2]);
    check_place(options, simulation, "--start: no robot can drive from ", start.position());
    simulation.place(start);
  }
  DriveTask task{seed, simulation.T_map_base(), Point::Zero(), simulation.unmapped()};
  if (!options.goal.empty()) {
    task.goal = given_goal(options, simulation);
    return task;
  }
  if (const auto goal = drawn_goal(simulation, floor, random)) {
    task.goal = *goal;
    return task;
  }
  throw ConfigError(simulation.building().name() + ": no goal to draw: by the map, no way leads from the start " +
                    "to any other place, expected --start and --goal, or another --robot-radius");
}

/// Another program that localizes, in the building that is driven in.
std::unique_ptr<navigation::Localization> connected(const std::string& address, const LaserModel& laser,
                                                    const SemanticMap& map) {
  auto localization = std::make_unique<remote::RemoteLocalization>(address, laser);
  const SemanticMap& theirs = localization->map().map();
  if (theirs.to_json_ld() != map.to_json_ld())
    throw ConfigError("--localizer: " + address + " localizes in another map, '" + theirs.name() +
                      "', expected the one that is driven in, '" + map.name() + "'");
  return localization;
}

std::unique_ptr<navigation::Localization> localization_of(const DriveVerbOptions& options, const Deployment& deployment,
                                                          const PluginRegistry& registry,
                                                          const std::shared_ptr<const SemanticMap>& map) {
  if (!options.localizer.empty()) return connected(options.localizer, deployment.lasers.front(), *map);
  return std::make_unique<navigation::OwnLocalizerQueries>(
      std::make_unique<Localizer>(build_parts(deployment, registry, map)), deployment.lasers.front());
}

/// Where a robot drives, and by what.
struct DriveSetup {
  PluginRegistry plugins;
  Deployment deployment;
  std::shared_ptr<const SemanticMap> map;
  std::unique_ptr<navigation::Localization> localization;
  std::string trees;
};

/// What a drive takes place in: the building, or one of the storeys that its map holds.
std::shared_ptr<const SemanticMap> driven_map(const DriveVerbOptions& options,
                                              const std::shared_ptr<const SemanticMap>& map, std::uint64_t seed) {
  const auto& storeys = map->origin().storeys;
  if (!options.storey.empty()) return storey_of_map(*map, options.storey);
  return storeys.empty() ? map : storey_of_map(*map, storeys[seed % storeys.size()].id);
}

DriveSetup set_up(DriveVerbOptions& options) {
  options.loop.motion.omnidirectional = options.world.drive == sim::Drive::omnidirectional;
  options.loop.motion.radius_m = options.world.robot_radius_m;
  Deployment deployment = read_deployment(session::config_file(options.config));
  DriveSetup setup{session::load_plugins(deployment), std::move(deployment), {}, {}, {}};
  options.take_laser(setup.deployment);
  setup.deployment.lasers.front() = options.world.laser;
  setup.deployment.map = options.map;
  setup.map = session::load_map(setup.plugins, setup.deployment);
  driven_map(options, setup.map, options.seed);  // an unknown storey is told before the map is indexed
  options.furnish(setup.plugins, *setup.map);
  setup.localization = localization_of(options, setup.deployment, setup.plugins, setup.map);
  setup.trees = session::config_file(options.trees.empty() ? "behaviours" : options.trees);
  navigation::read_tree(navigation::standard_nodes(), setup.trees, options.behaviour);  // before anything is written
  if (options.behaviour.empty()) options.behaviour = navigation::first_tree(setup.trees);
  return setup;
}

/// The task of a seed; none: no drive is possible with it, and others may be.
/// @throws ConfigError if it is the only one.
std::optional<DriveTask> possible_task(const DriveVerbOptions& options, sim::Simulation& simulation,
                                       const FloorGrid& floor, std::uint64_t seed) {
  try {
    return task_of(options, simulation, floor, seed);
  } catch (const ConfigError& error) {
    if (options.runs == 1) throw;
    std::cerr << "seed " << seed << ": no drive: " << error.what() << '\n';
    return std::nullopt;
  }
}

/// The options of the drive k, with a bar that shows how long it lasts.
ClosedLoopOptions shown_on(benchmark::ProgressBar& bar, const DriveVerbOptions& options, int k) {
  ClosedLoopOptions loop = options.loop;
  loop.witness = [&bar, &options, k, start_s = std::optional<double>()](const RawScan& scan,
                                                                        const Pose2& T_map_base) mutable {
    if (options.loop.witness) options.loop.witness(scan, T_map_base);
    if (!start_s) start_s = scan.stamp_s;
    const double share = std::min(1.0, (scan.stamp_s - *start_s) / options.loop.most_s);
    bar.show((k + share) / options.runs, fmt::format("drive {} of {}: {:.0f} s of at most {:.0f} s", k + 1,
                                                     options.runs, scan.stamp_s - *start_s, options.loop.most_s));
  };
  return loop;
}

/// Drives one after the other until a stop is asked for; a drive that it cuts is left out.
void drive_all(const DriveVerbOptions& options, DriveSetup& setup, DriveReport& report,
               sim::DriveRecording& recording) {
  const FloorGrid floor =
      navigation::mapped_floor(setup.localization->map(), 0.8 * options.world.robot_radius_m, options.world.outdoors);
  const navigation::NodeRegistry nodes = navigation::standard_nodes();
  benchmark::ProgressBar bar;
  for (int k = 0; k < options.runs; ++k) {
    const std::uint64_t seed = options.seed + static_cast<std::uint64_t>(k);
    sim::Simulation simulation(driven_map(options, setup.map, seed), options.world, seed);
    const std::optional<DriveTask> task = possible_task(options, simulation, floor, seed);
    if (!task) continue;
    const auto tree = navigation::read_tree(nodes, setup.trees, options.behaviour);
    const DriveRecord record =
        drive_to_goal(simulation, *setup.localization, floor, *tree, task->goal, shown_on(bar, options, k));
    bar.clear();
    if (options.loop.stop.stop_requested()) return;
    report.add(*task, record);
    if (!options.record.empty()) recording.end_drive(seed, record.driven_m);
    if (record.unanswered_scans > 0)
      std::cerr << "localization did not answer for " << record.unanswered_scans << " scans; the robot stood still\n";
  }
}

int drive(DriveVerbOptions options) {
  DriveSetup setup = set_up(options);
  const StopSignals signals;
  options.loop.stop = signals.token();
  OutputFolder folder(options.out, "opal drive", {"summary.json", "drive_*.svg", "drive_*.png"});
  DriveReport report(setup.map, options.behaviour, folder.path());
  sim::DriveRecording recording(setup.deployment.lasers.front());
  if (!options.record.empty())
    options.loop.witness = [&](const RawScan& scan, const Pose2& T_map_base) { recording.witness(scan, T_map_base); };
  drive_all(options, setup, report, recording);
  report.write();
  if (!options.record.empty() && report.drives() > 0)
    sim::write_recorded_place(recording.ended(), *setup.map, options.record);
  const bool is_short = report.drives() < static_cast<std::size_t>(options.runs);  // stopped, or without some seeds
  return end_run(folder, is_short ? signals.signal() : 0, report.all_reached() && !is_short ? kDone : kNo);
}

}  // namespace

void add_drive_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<DriveVerbOptions>();
  CLI::App* verb = app.add_subcommand("drive", "let a simulated robot find out where it is and drive to a goal");
  verb->add_option("CONFIG", options->config,
                   "deployment document, or the name of one that ships; the laser that it describes is simulated")
      ->required();
  verb->add_option("MAP", options->map, "map document, or a source to import")->required();
  verb->add_option("--goal", options->goal, "X,Y in the map frame [m]; drawn if not given")
      ->delimiter(',')
      ->expected(2);
  verb->add_option("--start", options->start, "X,Y,THETA [m, rad], which the robot is not told; drawn if not given")
      ->delimiter(',')
      ->expected(3);
  verb->add_option("--storey", options->storey, "of a map that holds several: where the robot drives, not told to it")
      ->default_str("one by the seed");
  verb->add_option("--behaviour", options->behaviour,
                   "a tree of the document: disambiguate, rotate_and_go, inspect, search")
      ->default_str("the first one");
  verb->add_option("--trees", options->trees, "document of behaviour trees")->default_str("configs/behaviours.jsonld");
  verb->add_option("--localizer", options->localizer,
                   "HOST:PORT of a program that localizes (opal serve), instead of this one");
  verb->add_option("--seed", options->seed, "of everything: the same seed gives the same drive")->capture_default_str();
  verb->add_option("--runs", options->runs, "drives, with this seed and those after it")
      ->capture_default_str()
      ->check(in_range(1, 100000));
  verb->add_option("--most", options->loop.most_s, "of each drive, before it is given up [s]")->capture_default_str();
  verb->add_option("-o,--out", options->out, "folder for summary.json and pictures")->capture_default_str();
  verb->add_option("--record", options->record,
                   "PREFIX of a recording of all drives, with the truth, as opal bench and opal localize take it");
  options->add_to(*verb);
  verb->add_option("--speed", options->loop.motion.speed_mps, "the fastest [m/s]")->capture_default_str();
  verb->callback([options, &exit_code] { exit_code = drive(*options); });
}

}  // namespace opal::cli
