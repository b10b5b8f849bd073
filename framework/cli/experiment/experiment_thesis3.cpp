#include "cli/experiment/experiment_contenders.hpp"
#include "cli/experiment/experiment_output.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/terminal/run_end.hpp"
#include "cli/terminal/stop_signals.hpp"

#include "benchmark/experiments/challenges/baseline.hpp"
#include "benchmark/experiments/challenges/challenge_report.hpp"
#include "benchmark/experiments/kit/in_parallel.hpp"
#include "benchmark/experiments/kit/thesis_robot.hpp"

#include "common/whole_file.hpp"
#include "map_tools/map_raster.hpp"

namespace opal::cli {
namespace {

namespace fs = std::filesystem;
namespace sim = simulation;
using namespace experiments;

std::string two_digits(int number) { return (number < 10 ? "0" : "") + std::to_string(number); }

/// The drives of one challenge and seed, by everybody.
class Challenges {
 public:
  Challenges(const ExperimentOptions& options, const PluginRegistry& registry)
      : options_(options),
        registry_(registry),
        contenders_(contenders(options.configs)),
        map_(building(registry, options.map, "atlas")) {
    for (const std::string& program : options.baselines)
      baselines_.push_back({program, fs::path(program).stem().string()});
    if (!keeps_logs()) return;
    make_folder(logs_.string());
    write_raster(rasterized(*map_), grid());
  }

  const SemanticMap& map() const { return *map_; }

  std::vector<ChallengeRun> run(const sim::Challenge& challenge, int seed) const {
    const sim::ChallengeDrive driven =
        drive(challenge, map_, thesis_robot(), options_.duration_s, static_cast<std::uint64_t>(seed));
    const std::string prefix = (logs_ / (challenge.id + '_' + two_digits(seed))).string();
    std::vector<ChallengeRun> runs;
    for (const Contender& contender : contenders_) runs.push_back(run_challenge(contender, registry_, map_, driven));
    for (const Baseline& baseline : baselines_)
      runs.push_back(run_baseline(baseline, driven, prefix, grid(), static_cast<std::uint64_t>(seed)));
    if (options_.logs && baselines_.empty()) sim::write_recording(driven.recording, prefix);
    for (ChallengeRun& run : runs) {
      run.challenge = challenge.id;
      run.seed = static_cast<std::uint64_t>(seed);
    }
    return runs;
  }

 private:
  bool keeps_logs() const { return options_.logs || !baselines_.empty(); }
  std::string grid() const { return (logs_ / "map.yaml").string(); }

  const ExperimentOptions& options_;
  const PluginRegistry& registry_;
  std::vector<Contender> contenders_;
  std::vector<Baseline> baselines_;
  std::shared_ptr<const SemanticMap> map_;
  fs::path logs_ = fs::path(options_.out) / "logs";
};

}  // namespace

int experiment_thesis3(const ExperimentOptions& options, const PluginRegistry& registry) {
  const std::vector<sim::Challenge> challenges = chosen(sim::thesis3_challenges(), options.only);
  const StopSignals signals;
  OutputFolder folder(options.out, "opal experiment thesis3", experiment_products());
  const Challenges experiment(options, registry);
  const std::size_t each = challenges.size();
  std::vector<std::vector<ChallengeRun>> parts(each * static_cast<std::size_t>(options.seeds));
  const auto run = [&](std::size_t k) {
    parts[k] = experiment.run(challenges[k % each], static_cast<int>(k / each) + 1);
    std::cerr << challenges[k % each].id + " seed " + std::to_string(k / each + 1) + " done\n";
  };
  in_parallel(parts.size(), options.jobs, run, signals.token());
  const int signal = cut_by(signals, parts);
  const std::vector<ChallengeRun> runs = done(std::move(parts));
  if (runs.empty()) return end_run(folder, signal, kDone);
  write_experiment(options.out, std::span<const ChallengeRun>(runs), &ChallengeRun::challenge, challenge_table(runs),
                   challenge_summary(runs), challenge_page(experiment.map(), runs));
  return end_run(folder, signal, kDone);
}

}  // namespace opal::cli
