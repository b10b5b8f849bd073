#include "cli/experiment/experiment_faults.hpp"

#include "benchmark/runs/progress_bar.hpp"
#include "cli/experiment/experiment_output.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/options/number_option.hpp"
#include "cli/terminal/run_end.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "session/session.hpp"
#include "session/shipped_files.hpp"

#include "benchmark/experiments/faults/fault_report.hpp"
#include "benchmark/experiments/kit/in_parallel.hpp"

#include <opal/common/error.hpp>

#include <iostream>
#include <mutex>
#include <thread>

namespace opal::cli {
namespace {

namespace experiments = experiments;

struct FaultsVerbOptions {
  std::string config = "two_lasers", out;
  std::vector<std::string> only;
  experiments::FaultDriveOptions drive;
  int drives = 20;
  int jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
};

std::vector<experiments::Trouble> chosen_troubles(const std::vector<std::string>& only) {
  if (only.empty()) return experiments::all_troubles();
  std::vector<experiments::Trouble> troubles;
  for (const std::string& name : only) {
    const auto& all = experiments::all_troubles();
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& trouble) { return trouble.name == name; });
    if (found == all.end()) {
      std::string names;
      for (const auto& trouble : all) names += (names.empty() ? "\"" : ", \"") + trouble.name + "\"";
      throw ConfigError("--only: \"" + name + "\", expected one of " + names);
    }
    troubles.push_back(*found);
  }
  return troubles;
}

std::vector<experiments::FaultRun> run_all(const FaultsVerbOptions& options, const std::stop_token& stop) {
  const Deployment deployment = read_deployment(session::config_file(options.config));
  const PluginRegistry registry = session::load_plugins(deployment);
  if (!deployment.describes_laser || deployment.lasers.front().geometry_from_log)
    throw ConfigError(deployment.file + ": /sensor: describes no laser, expected one to simulate");
  const std::vector<experiments::Trouble> troubles = chosen_troubles(options.only);
  std::vector<experiments::FaultRun> runs(troubles.size() * static_cast<std::size_t>(options.drives));
  std::vector<char> is_done(runs.size(), 0);
  benchmark::ProgressBar bar;
  std::mutex counting;
  double finished = 0;
  const auto run = [&](std::size_t k) {
    const std::uint64_t seed = 1 + k / troubles.size();
    runs[k] = run_drive(deployment, registry, troubles[k % troubles.size()], seed, options.drive);
    is_done[k] = 1;
    const std::lock_guard lock(counting);
    bar.show(++finished / static_cast<double>(runs.size()));
  };
  experiments::in_parallel(runs.size(), options.jobs, run, stop);
  std::vector<experiments::FaultRun> done;
  for (std::size_t k = 0; k < runs.size(); ++k)
    if (is_done[k]) done.push_back(std::move(runs[k]));
  return done;
}

int faults(const FaultsVerbOptions& options) {
  const StopSignals signals;  // before other threads
  OutputFolder folder(options.out, "opal experiment faults", drive_products());
  const std::vector<experiments::FaultRun> runs = run_all(options, signals.token());
  const Table table = fault_table(runs);
  std::cout << markdown_of(table);
  write_drives(options.out, table, fault_rows(runs));
  return end_run(folder, signals.token().stop_requested() ? signals.signal() : 0, kDone);
}

}  // namespace

void add_experiment_faults(CLI::App& experiment, int& exit_code) {
  auto o = std::make_shared<FaultsVerbOptions>();
  CLI::App* verb = experiment.add_subcommand(
      "faults",
      "drives through generated buildings whose sensor streams fail: what is said, and when it is right again");
  verb->add_option("-o,--out", o->out, "folder for drives.csv and table.txt")->required();
  verb->add_option("--config", o->config,
                   "deployment whose lasers are simulated: a file, or the name of one that ships")
      ->capture_default_str();
  verb->add_option("--only", o->only, "only these faults, as the table names them");
  verb->add_option("--drives", o->drives, "of each fault; the same number is the same way in the same building")
      ->check(above_zero())
      ->capture_default_str();
  add_number(*verb, "--duration", o->drive.duration_s, 10.0, 3600.0, "of each drive [s]");
  add_number(*verb, "--fault-at", o->drive.fault_from_s, 0.0, 3600.0, "when the fault begins [s]");
  add_number(*verb, "--jobs", o->jobs, 1, 1000, "at the same time; results do not depend on it");
  verb->callback([o, &exit_code] { exit_code = faults(*o); });
}

}  // namespace opal::cli
