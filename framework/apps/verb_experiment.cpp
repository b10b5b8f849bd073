#include "experiment_buildings.hpp"
#include "experiment_report.hpp"
#include "session.hpp"
#include "verbs.hpp"

#include <opal/error.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace {

namespace sim = opal::simulation;
namespace fs = std::filesystem;

struct ExperimentOptions {
  std::string out, map;
  std::vector<std::string> configs{"thesis3", "default"};
  std::vector<std::string> only;
  int seeds = 20;
  double duration_s = 60;
};

/// 180 degrees, 720 beams, mecanum wheels (Hendrikx 2023, 3.5).
sim::SimulationOptions thesis_robot() {
  sim::SimulationOptions options;
  options.laser.angle_min_rad = -std::numbers::pi / 2;
  options.laser.beams = 720;
  options.laser.angle_increment_rad = std::numbers::pi / (options.laser.beams - 1);
  options.drive = sim::Drive::omnidirectional;
  return options;
}

std::vector<Contender> contenders(const ExperimentOptions& options) {
  std::vector<Contender> all;
  for (const std::string& config : options.configs) {
    const bool is_file = config.ends_with(".jsonld");
    all.push_back({is_file ? fs::path(config).stem().string() : config,
                   opal::read_deployment(is_file ? config : shipped_config(config + ".jsonld"))});
  }
  return all;
}

std::vector<sim::Challenge> chosen(const ExperimentOptions& options) {
  std::vector<sim::Challenge> all = sim::thesis3_challenges();
  if (options.only.empty()) return all;
  std::erase_if(all, [&](const sim::Challenge& challenge) {
    return std::find(options.only.begin(), options.only.end(), challenge.id) == options.only.end();
  });
  if (all.empty()) throw opal::ConfigError("experiment: none of the challenges is called '" + options.only.front() + "', expected A1, A3, B1 to B10, C11 or C12");
  return all;
}

int experiment(const ExperimentOptions& options) {
  const opal::PluginRegistry registry = load_plugins();
  const std::vector<Contender> all = contenders(options);
  const auto map = load_map(registry, options.map);
  fs::create_directories(options.out);
  std::vector<ExperimentRun> runs;
  for (const sim::Challenge& challenge : chosen(options)) {
    for (int seed = 1; seed <= options.seeds; ++seed) {
      const sim::ChallengeDrive driven = drive(challenge, map, thesis_robot(), options.duration_s, static_cast<std::uint64_t>(seed));
      for (const Contender& contender : all) {
        runs.push_back(run_challenge(contender, registry, map, driven));
        runs.back().challenge = challenge.id;
        runs.back().seed = static_cast<std::uint64_t>(seed);
      }
    }
    std::cerr << challenge.id << " done\n";
  }
  const std::string table = experiment_table(runs);
  std::cout << table;
  std::ofstream csv(fs::path(options.out) / "runs.csv"), text(fs::path(options.out) / "table.txt");
  write_runs(csv, runs);
  text << table;
  if (!csv || !text) throw opal::Error(options.out + ": cannot be written");
  write_experiment_page((fs::path(options.out) / "report.html").string(), "Experiment thesis3", table, *map, runs);
  std::cout << "written: runs.csv, table.txt, report.html in " << options.out << '\n';
  return 0;
}

}  // namespace

void opal::add_experiment_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ExperimentOptions>();
  CLI::App* experiment = app.add_subcommand("experiment", "the experiments of Hendrikx (2023), in simulation, with several configurations");
  experiment->require_subcommand(1);
  add_experiment_buildings(*experiment, exit_code);
  CLI::App* verb = experiment->add_subcommand("thesis3", "the 14 challenges of section 3.5.2 in one building");
  verb->add_option("-o,--out", options->out, "folder for runs.csv, table.txt and report.html")->required();
  verb->add_option("--map", options->map, "the building: maps/atlas.jsonld, or any other")->required();
  verb->add_option("--config", options->configs, "who takes part: names of shipped configurations, or files (.jsonld)")->capture_default_str();
  verb->add_option("--challenge", options->only, "only these: A1, B7, ...");
  verb->add_option("--seeds", options->seeds, "runs per challenge: clutter, people and noise differ")->check(CLI::PositiveNumber)->capture_default_str();
  verb->add_option("--duration", options->duration_s, "of each run [s]")->check(CLI::PositiveNumber)->capture_default_str();
  verb->callback([options, &exit_code] { exit_code = ::experiment(*options); });
}
