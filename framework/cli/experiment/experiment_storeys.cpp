#include "cli/experiment/experiment_storeys.hpp"

#include "benchmark/runs/progress_bar.hpp"
#include "cli/experiment/experiment_output.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/options/number_option.hpp"
#include "cli/options/world_options.hpp"
#include "cli/terminal/run_end.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "session/session.hpp"
#include "session/shipped_files.hpp"

#include "benchmark/experiments/kit/in_parallel.hpp"
#include "benchmark/experiments/storeys/storey_report.hpp"

#include "common/whole_file.hpp"
#include "output/output_folder.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <iostream>
#include <mutex>
#include <thread>

namespace opal::cli {
namespace {

namespace experiments = experiments;

struct StoreysVerbOptions : WorldOptions {
  std::string map, config = "default", out;
  bool has_recordings = false;
  simulation::RideDriveOptions ride;
  int drives = 40, rides = 40, jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  std::uint64_t first_seed = 1;
};

/// Which lift is taken from where to where.
struct Trip {
  const MapConnection* lift = nullptr;
  std::string from, to;
};

std::vector<Trip> trips_of(const SemanticMap& map) {
  std::vector<Trip> trips;
  for (const MapConnection& lift : map.origin().connections)
    for (const Landing& from : lift.landings)
      for (const Landing& to : lift.landings)
        if (lift.type == "opal:Lift" && from.storey != to.storey) trips.push_back({&lift, from.storey, to.storey});
  return trips;
}

class StoreyRuns {
 public:
  StoreyRuns(const StoreysVerbOptions& options, const LocalizerParts& parts)
      : options_(options), parts_(parts), world_{parts, options.world}, trips_(trips_of(parts.map->map())) {
    if (options.has_recordings)
      world_.keep = [&options](const simulation::Recording& recording, std::uint64_t seed) {
        write_recording(recording, fmt::format("{}/recordings/{:05}", options.out, seed));
      };
    if (storeys().empty())
      throw MapError(options.map + ": holds no storeys, expected some (opal map stack, opal map import --all)");
    if (options.rides > 0 && parts.lasers.size() > 1)
      throw ConfigError(options.config + ": has several lasers, expected one for --rides");
    if (options.rides > 0 && trips_.empty())
      throw MapError(options.map + ": holds no lift that serves two storeys, expected one for --rides");
  }

  std::vector<experiments::StoreyRun> run(const std::stop_token& stop) {
    const auto count = static_cast<std::size_t>(options_.drives + options_.rides);
    runs_.resize(count);
    experiments::in_parallel(
        count, options_.jobs, [&](std::size_t k) { run_one(k); }, stop);
    std::vector<experiments::StoreyRun> done;
    for (auto& run : runs_)
      if (run) done.push_back(std::move(*run));
    return done;
  }

 private:
  const std::vector<MapStorey>& storeys() const { return parts_.map->map().origin().storeys; }

  void run_one(std::size_t k) {
    const auto drives = static_cast<std::size_t>(options_.drives);
    const std::uint64_t seed = options_.first_seed + k;
    if (k < drives) {
      runs_[k] = experiments::run_storey_drive(world_, storeys()[k % storeys().size()].id, options_.ride.drive, seed);
    } else {
      const Trip& trip = trips_[(k - drives) % trips_.size()];
      runs_[k] = experiments::run_ride(world_, *trip.lift, trip.from, trip.to, options_.ride, seed);
    }
    const std::lock_guard lock(counting_);
    bar_.show(++finished_ / static_cast<double>(runs_.size()));
  }

  const StoreysVerbOptions& options_;
  const LocalizerParts& parts_;
  experiments::StoreyWorld world_;
  std::vector<Trip> trips_;
  std::vector<std::optional<experiments::StoreyRun>> runs_;
  benchmark::ProgressBar bar_;
  std::mutex counting_;
  double finished_ = 0;
};

int storeys(StoreysVerbOptions options) {
  const StopSignals signals;  // before other threads
  std::vector<std::string> products = drive_products();
  products.push_back("recordings");
  OutputFolder folder(options.out, "opal experiment storeys", products);
  Deployment deployment = read_deployment(session::config_file(options.config));
  const PluginRegistry registry = session::load_plugins(deployment);
  options.take_laser(deployment);
  deployment.lasers = {options.world.laser};
  deployment.lasers.insert(deployment.lasers.end(), options.world.more_lasers.begin(), options.world.more_lasers.end());
  options.ride.drive.drives = 1;
  const LocalizerParts parts = build_parts(deployment, registry, session::load_map(registry, options.map));
  if (options.has_recordings) make_folder(options.out + "/recordings");
  const std::vector<experiments::StoreyRun> runs = StoreyRuns(options, parts).run(signals.token());
  const Table table = storey_table(runs);
  std::cout << markdown_of(table);
  const auto unreached = static_cast<std::size_t>(options.drives + options.rides) - runs.size();
  if (unreached > 0 && !signals.token().stop_requested())
    std::cout << unreached << " rides did not take place: furniture or a wall was in the way\n";
  write_drives(options.out, table, storey_rows(runs));
  return end_run(folder, signals.token().stop_requested() ? signals.signal() : 0, kDone);
}

}  // namespace

void add_experiment_storeys(CLI::App& experiment, int& exit_code) {
  auto o = std::make_shared<StoreysVerbOptions>();
  o->ride.drive.distance_m = 80;
  CLI::App* verb = experiment.add_subcommand(
      "storeys", "drives on a storey that the robot does not know, and rides in lifts: what is said, and from when on");
  verb->add_option("MAP", o->map, "map document with storeys")->required();
  verb->add_option("-o,--out", o->out, "folder for drives.csv and table.txt")->required();
  verb->add_option("--config", o->config, "deployment: a file, or the name of one that ships")->capture_default_str();
  add_number(*verb, "--drives", o->drives, 0, 100000, "on storey after storey");
  add_number(*verb, "--rides", o->rides, 0, 100000, "in lift after lift, from each of its storeys to each other");
  add_number(*verb, "--distance", o->ride.drive.distance_m, 1.0, 1e5, "of each drive [m]");
  add_number(*verb, "--before", o->ride.before_m, 0.0, 1e5, "driven before a ride, at least [m]");
  add_number(*verb, "--after", o->ride.after_m, 1.0, 1e5, "driven after a ride [m]");
  add_number(*verb, "--closed", o->ride.closed_s, 0.0, 1000.0, "how long the door of the lift is closed [s]");
  verb->add_flag("--shafts-mapped", o->ride.is_shaft_mapped,
                 "the map has the walls of the lifts; else a cabin is put there that it does not have");
  verb->add_flag("--recordings", o->has_recordings, "also write each drive as a recorded log with its truth");
  add_number(*verb, "--jobs", o->jobs, 1, 1000, "at the same time; results do not depend on it");
  verb->add_option("--seed", o->first_seed, "of the first drive")->capture_default_str();
  o->add_to(*verb);
  verb->callback([o, &exit_code] { exit_code = storeys(*o); });
}

}  // namespace opal::cli
