#include "cli/ab/ab_session.hpp"

#include "benchmark/cells/ab_manifest.hpp"
#include "benchmark/cells/ab_report.hpp"
#include "benchmark/runs/progress_bar.hpp"
#include "session/shipped_files.hpp"

#include "benchmark/ab/execution/workers.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <thread>

namespace opal::cli {
namespace {

namespace ab = ab;

std::string out_of(const AbOptions& options) {
  if (!options.out.empty()) return options.out;
  return (std::filesystem::path("out") / std::filesystem::path(options.experiment).stem()).string();
}

std::string duration_text(double s) {
  const long all_s = std::lround(s);
  return all_s < 3600 ? fmt::format("{}:{:02}", all_s / 60, all_s % 60)
                      : fmt::format("{}:{:02} h", all_s / 3600, all_s / 60 % 60);
}

/// @return whether tasks of the job have not ended.
bool tell_tasks(const ab::SlurmJob& job) {
  std::cout << "job " << job.id << " of " << job.tasks << " tasks:";
  std::size_t waiting = 0;
  for (const auto& [state, count] : ab::task_states(job)) {
    std::cout << ' ' << count << ' ' << state << ',';
    waiting += count;
  }
  std::cout << ' ' << job.tasks - std::min(job.tasks, waiting) << " ended\n";
  return waiting > 0;
}

}  // namespace

std::size_t jobs_of(const AbOptions& options) {
  return options.jobs > 0 ? static_cast<std::size_t>(options.jobs) : std::max(1u, std::thread::hardware_concurrency());
}

AbSession::AbSession(const AbOptions& options)
    : experiment_(ab::read_experiment(
          options.experiment, [](const std::string& name) { return session::shipped_config(name + ".jsonld"); })),
      metrics_(benchmark::metrics_of(experiment_)),
      plugins_(benchmark::load_arm_plugins(experiment_)),
      worlds_(experiment_, *plugins_[experiment_.baseline].registry),
      plan_(experiment_, all_queries()),
      manifest_(benchmark::manifest_of(experiment_, plugins_, worlds_)),
      folder_(out_of(options), manifest_) {}

void AbSession::work(const ab::Shard& shard, std::size_t jobs) {
  benchmark::LocalizingRunner runner(experiment_, plugins_, worlds_);
  benchmark::ProgressBar bar;
  compute(runner, plan_, folder_, experiment_.limits, shard, jobs, [&](const ab::WorkProgress& progress) {
    bar.show(progress.share(), fmt::format("{} of {} cells, {} left", progress.before + progress.done, progress.all,
                                           duration_text(progress.left_s())));
  });
}

bool AbSession::collect() {
  const ab::MergedResults results(folder_, plan_);
  std::cout << results.finished() << " of " << plan_.cells() << " cells are finished\n";
  const int look = benchmark::look_at(experiment_, folder_, results, plan_);
  if (look == 0 && experiment_.looks > 1)
    std::cout << "looks are at every " << plan_.cells() / static_cast<std::size_t>(experiment_.looks)
              << " cells, once\n";
  if (results.complete()) results.write(benchmark::arm_digests(manifest_));
  if (look > 0) {
    benchmark::LocalizingRunner runner(experiment_, plugins_, worlds_);
    const benchmark::ViewLinks links = experiment_.observes
                                           ? benchmark::ViewLinks()
                                           : benchmark::write_views(experiment_, plan_, folder_, results, runner);
    benchmark::report(experiment_, plan_, folder_, results, manifest_, look, links);
  }
  if (results.complete())
    std::cout << "written: results.jsonl, times.jsonl, verdict.json, report.html, paper in " << folder_.path() << '\n';
  return results.complete();
}

ab::SlurmJob AbSession::submit(const AbOptions& options) const {
  const auto whole = [](const std::string& path) { return std::filesystem::canonical(path).string(); };
  const std::size_t usual = std::min<std::size_t>(plan_.tasks(), 100);
  const std::size_t tasks = options.tasks > 0 ? static_cast<std::size_t>(options.tasks) : usual;
  return ab::submit(folder_, {std::filesystem::path(experiment_.file).stem().string(), whole("/proc/self/exe"),
                              whole(experiment_.file), whole(folder_.path()), tasks, options.sbatch});
}

bool AbSession::status() const {
  const auto job = ab::submitted_job(folder_);
  const bool waits = job && tell_tasks(*job);
  const ab::MergedResults results(folder_, plan_);
  std::cout << results.finished() << " of " << plan_.cells() << " cells are finished\n";
  if (job && !waits && !results.complete())
    std::cout << "what is missing: see logs in " << folder_.path() << "/logs; submit again computes it\n";
  return results.complete();
}

std::vector<std::vector<std::string>> AbSession::all_queries() const {
  std::vector<std::vector<std::string>> queries;
  for (const ab::Scenario& scenario : experiment_.scenarios) queries.push_back(worlds_.queries(scenario));
  return queries;
}

}  // namespace opal::cli
