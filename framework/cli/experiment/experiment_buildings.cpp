#include "cli/experiment/experiment_buildings.hpp"

#include "benchmark/runs/progress_bar.hpp"
#include "cli/experiment/experiment_contenders.hpp"
#include "cli/experiment/experiment_output.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/options/number_option.hpp"
#include "cli/terminal/run_end.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "session/session.hpp"

#include "benchmark/experiments/buildings/buildings_page.hpp"
#include "benchmark/experiments/kit/in_parallel.hpp"

#include "common/text_file.hpp"
#include "common/whole_file.hpp"
#include "drawing/figure.hpp"
#include "report/table_files.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <mutex>
#include <sstream>
#include <thread>

namespace opal::cli {
namespace {

namespace fs = std::filesystem;
namespace experiments = experiments;
using simulation::SuiteBuilding;

struct BuildingsVerbOptions {
  simulation::SuiteRequest suite;
  experiments::BuildingsOptions runs;
  std::vector<std::string> configs{"default"}, only;
  std::string out;
  int jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  bool record = false;
};

template <class T>
void say(std::ostream& command, const char* option, const std::vector<T>& values, const std::vector<T>& usual) {
  if (values == usual) return;
  for (std::size_t k = 0; k < values.size(); ++k)
    command << (k == 0 ? std::string(" ") + option + " " : ",") << values[k];
}

template <class T>
void say(std::ostream& command, const char* option, const T& value, const T& usual) {
  if (value != usual) command << ' ' << option << ' ' << value;
}

/// What decides the results and is not as usual; folders and jobs do not.
std::string command_of(const BuildingsVerbOptions& o, bool with_choice) {
  const BuildingsVerbOptions usual;
  std::ostringstream command;
  command << "opal experiment buildings -o out";
  say(command, "--config", o.configs, usual.configs);
  say(command, "--seeds", o.runs.seeds, usual.runs.seeds);
  say(command, "--duration", o.runs.duration_s, usual.runs.duration_s);
  if (o.suite.symmetry) command << " --symmetry " << *o.suite.symmetry;
  if (o.suite.size_factor) command << " --size " << *o.suite.size_factor;
  if (o.suite.clutter) command << " --clutter " << *o.suite.clutter;
  say(command, "--buildings", o.suite.buildings, usual.suite.buildings);
  say(command, "--difficulty", o.suite.difficulties, usual.suite.difficulties);
  say(command, "--kind", o.suite.kinds, usual.suite.kinds);
  if (!with_choice) return command.str();
  say(command, "--building", o.only, usual.only);
  say(command, "--challenge", o.runs.challenges, usual.runs.challenges);
  return command.str();
}

std::vector<experiments::BuildingRuns> run(const BuildingsVerbOptions& options, const std::vector<SuiteBuilding>& suite,
                                           const std::stop_token& stop) {
  const PluginRegistry registry = session::load_plugins();
  experiments::BuildingsOptions runs = options.runs;
  runs.contenders = contenders(options.configs);
  if (options.record) make_folder(runs.recordings = (fs::path(options.out) / "recordings").string());
  std::vector<std::vector<experiments::BuildingRuns>> parts(suite.size());
  benchmark::ProgressBar bar;
  std::mutex counting;
  double finished = 0;
  const auto run = [&](std::size_t k) {
    parts[k].push_back(run_building(suite[k], registry, runs));
    const std::lock_guard lock(counting);
    bar.show(++finished / static_cast<double>(suite.size()));
  };
  experiments::in_parallel(suite.size(), options.jobs, run, stop);
  return done(std::move(parts));
}

void write(const experiments::BuildingsExperiment& experiment, const fs::path& out) {
  const Table rows = buildings_table(experiment);
  const std::string table = markdown_of(rows);
  std::cout << table;
  write_table((out / "table").string(), rows);
  for (const auto& [name, plot] : share_plots(experiment)) write_figure((out / ("figure_" + name)).string(), plot);
  write_text((out / "table.txt").string(), table);
  write_text((out / "buildings.json").string(), to_json(experiment).dump(1) + '\n');
  write_text((out / "report.html").string(), buildings_page(experiment));
  std::cout << "written: buildings.json, table.txt, table.*, report.html, figure_* in " << out.string() << '\n';
}

int buildings(const BuildingsVerbOptions& options) {
  const std::vector<SuiteBuilding> suite = chosen(building_suite(options.suite), options.only);
  chosen(simulation::thesis3_challenges(), options.runs.challenges);  // all of them are there
  const StopSignals signals;                                          // before other threads
  OutputFolder folder(options.out, "opal experiment buildings",
                      {"buildings.json", "table.*", "report.html", "figure_*"});
  experiments::BuildingsExperiment experiment;
  experiment.command = command_of(options, true);
  experiment.run_command = command_of(options, false);
  experiment.buildings = run(options, suite, signals.token());
  const int signal = experiment.buildings.size() < suite.size() ? signals.signal() : 0;
  if (experiment.buildings.empty()) return end_run(folder, signal, kDone);
  experiment.groups = groups_of(experiment.buildings);
  write(experiment, options.out);
  return end_run(folder, signal, kDone);
}

}  // namespace

void add_experiment_buildings(CLI::App& experiment, int& exit_code) {
  auto o = std::make_shared<BuildingsVerbOptions>();
  CLI::App* verb = experiment.add_subcommand(
      "buildings", "the 14 challenges of section 3.5.2 in many synthetic buildings, ever more difficult");
  verb->add_option("-o,--out", o->out, "folder for buildings.json, table.txt and report.html")->required();
  verb->add_option("--buildings", o->suite.buildings, "how many: one of each kind at each difficulty, and again")
      ->check(in_range(1, 100000))
      ->capture_default_str();
  verb->add_option("--kind", o->suite.kinds, "only these: office, hall, warehouse, corridor")->delimiter(',');
  verb->add_option("--difficulty", o->suite.difficulties,
                   "0 to 1 each; the more, the more alike, larger and fuller; 0.5: as is usual")
      ->delimiter(',')
      ->capture_default_str();
  verb->add_option("--symmetry", o->suite.symmetry,
                   "the same at every difficulty; 0: all parts of a building differ, 1: all are copies")
      ->check(in_range(0.0, 1.0));
  verb->add_option("--size", o->suite.size_factor, "the same at every difficulty, times the usual size")
      ->check(in_range(0.1, 20.0));
  verb->add_option("--clutter", o->suite.clutter, "the same at every difficulty; 1: everyday")
      ->check(in_range(0.0, 10.0));
  verb->add_option("--config", o->configs, "who takes part: names of shipped configurations, or files (.jsonld)")
      ->delimiter(',')
      ->capture_default_str();
  verb->add_option("--building", o->only, "only these of the buildings: office-75-3, ...")->delimiter(',');
  verb->add_option("--challenge", o->runs.challenges, "only these: A1, B7, ...")->delimiter(',');
  verb->add_option("--seeds", o->runs.seeds, "runs per challenge: clutter, people and noise differ")
      ->check(above_zero())
      ->capture_default_str();
  verb->add_option("--duration", o->runs.duration_s, "of each run [s]")->check(above_zero())->capture_default_str();
  verb->add_option("--jobs", o->jobs, "buildings at the same time; results do not depend on it")
      ->check(in_range(1, 1024))
      ->capture_default_str();
  verb->add_flag("--record", o->record, "keep a recording of every run in OUT/recordings, as opal bench takes it");
  verb->callback([o, &exit_code] { exit_code = buildings(*o); });
}

}  // namespace opal::cli
