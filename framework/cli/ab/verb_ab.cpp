#include "benchmark/cells/ab_manifest.hpp"
#include "benchmark/cells/ab_report.hpp"
#include "benchmark/runs/progress_bar.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/options/verbs.hpp"
#include "session/session.hpp"
#include "session/shipped_files.hpp"

#include "benchmark/ab/execution/slurm.hpp"
#include "benchmark/ab/execution/workers.hpp"

#include <opal/common/error.hpp>
#include <opal/common/sentence.hpp>

#include <filesystem>
#include <iostream>
#include <thread>

namespace {

namespace ab = opal::ab;

struct AbOptions {
  std::string experiment, out, shard = "1/1";
  int jobs = 0;
  int tasks = 0;  // of a job array
  std::vector<std::string> sbatch;
};

/// An experiment with all that its cells are computed from, and where they go.
class AbSession {
 public:
  explicit AbSession(const AbOptions& options)
      : experiment_(ab::read_experiment(options.experiment,
                                        [](const std::string& name) { return shipped_config(name + ".jsonld"); })),
        metrics_(metrics_of(experiment_)),
        plugins_(load_arm_plugins(experiment_)),
        worlds_(experiment_, *plugins_[experiment_.baseline].registry),
        plan_(experiment_, all_queries()),
        manifest_(manifest_of(experiment_, plugins_, worlds_)),
        folder_(out_of(options), manifest_) {}

  void work(const ab::Shard& shard, std::size_t jobs) {
    LocalizingRunner runner(experiment_, plugins_, worlds_);
    ProgressBar bar;
    compute(runner, plan_, folder_, experiment_.limits, shard, jobs, [&](const ab::WorkProgress& progress) {
      bar.show(progress.share(), opal::sentence("%zu of %zu cells, %s left", progress.before + progress.done,
                                                progress.all, duration_text(progress.left_s()).c_str()));
    });
  }

  /// @return whether all cells are finished.
  bool collect() {
    const ab::MergedResults results(folder_, plan_);
    std::cout << results.finished() << " of " << plan_.cells() << " cells are finished\n";
    const int look = look_at(experiment_, folder_, results, plan_);
    if (look == 0 && experiment_.looks > 1)
      std::cout << "looks are at every " << plan_.cells() / static_cast<std::size_t>(experiment_.looks)
                << " cells, once\n";
    if (results.complete()) results.write(arm_digests(manifest_));
    if (look > 0) {
      LocalizingRunner runner(experiment_, plugins_, worlds_);
      const ViewLinks links =
          experiment_.observes ? ViewLinks() : write_views(experiment_, plan_, folder_, results, runner);
      report(experiment_, plan_, folder_, results, manifest_, look, links);
    }
    if (results.complete())
      std::cout << "written: results.jsonl, times.jsonl, verdict.json, report.html in " << folder_.path() << '\n';
    return results.complete();
  }

  ab::SlurmJob submit(const AbOptions& options) const {
    const auto whole = [](const std::string& path) { return std::filesystem::canonical(path).string(); };
    const std::size_t usual = std::min<std::size_t>(plan_.tasks(), 100);
    const std::size_t tasks = options.tasks > 0 ? static_cast<std::size_t>(options.tasks) : usual;
    return ab::submit(folder_, {std::filesystem::path(experiment_.file).stem().string(), whole("/proc/self/exe"),
                                whole(experiment_.file), whole(folder_.path()), tasks, options.sbatch});
  }

  /// @return whether all cells are finished.
  bool status() const {
    const ab::SlurmJob job = ab::submitted_job(folder_);
    std::cout << "job " << job.id << " of " << job.tasks << " tasks:";
    std::size_t waiting = 0;
    for (const auto& [state, count] : ab::task_states(job)) {
      std::cout << ' ' << count << ' ' << state << ',';
      waiting += count;
    }
    const ab::MergedResults results(folder_, plan_);
    std::cout << ' ' << job.tasks - std::min(job.tasks, waiting) << " ended\n"
              << results.finished() << " of " << plan_.cells() << " cells are finished\n";
    if (waiting == 0 && !results.complete())
      std::cout << "what is missing: see logs in " << folder_.path() << "/logs; submit again computes it\n";
    return results.complete();
  }

 private:
  static std::string out_of(const AbOptions& options) {
    if (!options.out.empty()) return options.out;
    return (std::filesystem::path("out") / std::filesystem::path(options.experiment).stem()).string();
  }
  static std::string duration_text(double s) {
    const long all_s = std::lround(s);
    return all_s < 3600 ? opal::sentence("%ld:%02ld", all_s / 60, all_s % 60)
                        : opal::sentence("%ld:%02ld h", all_s / 3600, all_s / 60 % 60);
  }
  std::vector<std::vector<std::string>> all_queries() const {
    std::vector<std::vector<std::string>> queries;
    for (const ab::Scenario& scenario : experiment_.scenarios) queries.push_back(worlds_.queries(scenario));
    return queries;
  }

  ab::Experiment experiment_;
  std::vector<opal::statistics::Metric> metrics_;  // a wrong name shows before hours of work
  std::vector<ArmPlugins> plugins_;
  WorldSource worlds_;
  ab::CellPlan plan_;
  nlohmann::ordered_json manifest_;
  ab::ResultFolder folder_;
};

std::size_t jobs_of(const AbOptions& options) {
  return options.jobs > 0 ? static_cast<std::size_t>(options.jobs) : std::max(1u, std::thread::hardware_concurrency());
}

int run(const AbOptions& options) {
  AbSession session(options);
  session.work(ab::read_shard(options.shard), jobs_of(options));
  return session.collect() ? kDone : kNo;
}

int work(const AbOptions& options) {
  AbSession(options).work(ab::read_shard(options.shard), options.jobs > 0 ? jobs_of(options) : 1);
  return kDone;
}

int submit(const AbOptions& options) {
  const ab::SlurmJob job = AbSession(options).submit(options);
  std::cout << "submitted: job " << job.id << ", an array of " << job.tasks
            << " tasks; opal ab status, then collect, with the same words\n";
  return kDone;
}

int status(const AbOptions& options) { return AbSession(options).status() ? kDone : kNo; }

int collect(const AbOptions& options) { return AbSession(options).collect() ? kDone : kNo; }

void add_experiment(CLI::App& verb, AbOptions& options, bool required) {
  verb.add_option("EXPERIMENT", options.experiment,
                  "experiment document (.jsonld): arms, sites, seeds; docs/compare_scorers.md")
      ->required(required);
  verb.add_option("-o,--out", options.out, "folder for results; what is finished there is not computed again")
      ->default_str("out/EXPERIMENT");
}

void add_jobs(CLI::App& verb, AbOptions& options, const std::string& usual) {
  verb.add_option("--jobs", options.jobs, "processes that compute cells")
      ->check(CLI::Range(1, 4096))
      ->default_str(usual);
}

}  // namespace

void opal::add_ab_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<AbOptions>();
  CLI::App* verb =
      app.add_subcommand("ab", "which of several scorers or configurations is better, and whether that is luck");
  verb->require_subcommand(0, 1);
  const auto add = [&](const std::string& name, const std::string& help,
                       const std::function<int(const AbOptions&)>& act) {
    CLI::App* part = verb->add_subcommand(name, help);
    add_experiment(*part, *options, true);
    part->callback([options, act, &exit_code] { exit_code = act(*options); });
    return part;
  };
  add_jobs(*add("run", "compute what is missing on this machine, then collect; `opal ab EXPERIMENT` is the same", run),
           *options, "all cores");
  CLI::App* worker = add("work", "compute one part of it: what GNU parallel and job arrays call", work);
  add_jobs(*worker, *options, "1");
  worker->add_option("--shard", options->shard, "I/N: part I of N, from 1 on")->capture_default_str();
  CLI::App* submitter = add("submit", "compute it as a job array under Slurm", submit);
  submitter->add_option("--tasks", options->tasks, "of the array")
      ->check(CLI::Range(1, 1'000'000))
      ->default_str("100, or as many as there are queries");
  submitter->add_option("--sbatch", options->sbatch, "option for sbatch, as --sbatch=--partition=long; may be repeated")
      ->allow_extra_args(false);
  add("status", "how far the job array is; exit code 1 while cells are missing", status);
  add("collect", "merge what all workers have computed, and say who is better", collect);
  add_experiment(*verb, *options, false);
  add_jobs(*verb, *options, "all cores");
  verb->callback([verb, options, &exit_code] {
    if (!verb->get_subcommands().empty()) return;
    if (options->experiment.empty()) throw CLI::RequiredError("EXPERIMENT");
    exit_code = run(*options);
  });
}
