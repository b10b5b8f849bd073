#include "cli/experiment/experiment_buildings.hpp"
#include "cli/experiment/experiment_faults.hpp"
#include "cli/experiment/experiment_integrity.hpp"
#include "cli/experiment/experiment_storeys.hpp"
#include "cli/experiment/experiments.hpp"
#include "cli/options/number_option.hpp"
#include "cli/options/verbs.hpp"
#include "session/session.hpp"

#include <opal/common/error.hpp>

namespace opal::cli {
namespace {

int experiment(ExperimentOptions options) {
  const bool third = options.name == "thesis3";
  if (options.configs.empty())
    options.configs =
        third ? std::vector<std::string>{"thesis3", "default"} : std::vector<std::string>{"thesis4", "default"};
  const PluginRegistry registry = session::load_plugins();
  return third ? experiment_thesis3(options, registry) : experiment_thesis4(options, registry);
}

void add_thesis3(CLI::App& verb, ExperimentOptions& options) {
  verb.add_option("--duration", options.duration_s, "of each run [s]")->check(above_zero())->capture_default_str();
  verb.add_option("--baseline", options.baselines, "programs that localize on the same logs, one more block each");
  verb.add_flag("--logs", options.logs, "keep what was recorded, and the map as a grid, in OUT/logs");
}

/// It closes the loop, which a log cannot.
void add_thesis4(CLI::App& verb, ExperimentOptions& options) {
  verb.add_option("--most", options.most_s, "of each drive, before it is given up [s]")
      ->check(above_zero())
      ->capture_default_str();
  verb.add_option("--behaviour", options.behaviour, "by which all drive")
      ->default_str("inspect for the thesis' configurations, the first tree for others");
  verb.add_option("--trees", options.trees, "document of behaviour trees")->default_str("configs/behaviours.jsonld");
}

void add_thesis(CLI::App& experiments, const std::string& name, const std::string& description, int& exit_code) {
  auto options = std::make_shared<ExperimentOptions>();
  options->name = name;
  CLI::App* verb = experiments.add_subcommand(name, description);
  verb->add_option("-o,--out", options->out, "folder for runs.csv, table.txt, summary.json and report.html")
      ->required();
  verb->add_option("--map", options->map,
                   "the building, if another than the one like the thesis': a map, or a source to import")
      ->default_str("maps/atlas.jsonld for thesis3, maps/gemini.jsonld for thesis4");
  verb->add_option("--config", options->configs, "who takes part: names of shipped configurations, or files (.jsonld)")
      ->default_str("thesis3 default, or thesis4 default");
  verb->add_option("--only,--challenge", options->only, "only these: A1, B7, ...");
  verb->add_option("--seeds", options->seeds, "runs of each: clutter, people and noise differ")
      ->check(above_zero())
      ->capture_default_str();
  verb->add_option("--jobs", options->jobs, "at the same time; results do not depend on it")
      ->check(in_range(1, 1000))
      ->capture_default_str();
  name == "thesis3" ? add_thesis3(*verb, *options) : add_thesis4(*verb, *options);
  verb->callback([options, &exit_code] { exit_code = experiment(*options); });
}

}  // namespace

void add_experiment_verb(CLI::App& app, int& exit_code) {
  CLI::App* experiments = app.add_subcommand(
      "experiment", "the experiments of Hendrikx (2023), in simulation, with several configurations");
  experiments->require_subcommand(1);
  add_thesis(*experiments, "thesis3", "the 14 challenges of section 3.5.2", exit_code);
  add_thesis(*experiments, "thesis4", "the 12 closed-loop runs of table 4.1", exit_code);
  add_experiment_buildings(*experiments, exit_code);
  add_experiment_faults(*experiments, exit_code);
  add_experiment_integrity(*experiments, exit_code);
  add_experiment_storeys(*experiments, exit_code);
}

}  // namespace opal::cli
