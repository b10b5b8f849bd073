#include "cli/ab/ab_bundle.hpp"
#include "cli/ab/ab_session.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/options/number_option.hpp"
#include "cli/options/verbs.hpp"

#include <functional>
#include <iostream>
#include <memory>

namespace opal::cli {
namespace {

namespace ab = ab;

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
  verb.add_option("--jobs", options.jobs, "processes that compute cells")->check(in_range(1, 4096))->default_str(usual);
}

/// Its experiment is that of the bundle.
void add_repeat(CLI::App& verb, AbOptions& options, int& exit_code) {
  CLI::App* part = verb.add_subcommand(
      "repeat", "compute a bundle's experiment again; exit code 1 if the verdict is another than the bundle's");
  part->add_option("BUNDLE", options.bundle, "folder that opal ab bundle made")->required();
  part->add_option("-o,--out", options.out, "folder for results; what is finished there is not computed again")
      ->default_str("out/BUNDLE_repeated");
  part->add_option("--look-in", options.places,
                   "folder with recordings that the bundle only names; may be repeated; they are known by SHA-256");
  add_jobs(*part, options, "all cores");
  part->callback([&options, &exit_code] { exit_code = repeat_bundle(options); });
}

}  // namespace

void add_ab_verb(CLI::App& app, int& exit_code) {
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
      ->check(in_range(1, 1'000'000))
      ->default_str("100, or as many as there are queries");
  submitter->add_option("--sbatch", options->sbatch, "option for sbatch, as --sbatch=--partition=long; may be repeated")
      ->allow_extra_args(false);
  add("status", "how far it is, and the job array if one was submitted; exit code 1 while cells are missing", status);
  add("collect", "merge what all workers have computed, and say who is better", collect);
  CLI::App* bundler = add("bundle", "put a finished experiment into one folder, from which others repeat it",
                          [](const AbOptions& given) { return bundle_experiment(given); });
  bundler->add_option("--to", options->bundle, "folder of the bundle")->default_str("OUT/bundle");
  bundler->add_option("--largest", options->largest_mb, "recordings above so many MB are named by SHA-256 only")
      ->check(in_range(0.0, 1e6))
      ->capture_default_str();
  add_repeat(*verb, *options, exit_code);
  add_experiment(*verb, *options, false);
  add_jobs(*verb, *options, "all cores");
  verb->callback([verb, options, &exit_code] {
    if (!verb->get_subcommands().empty()) return;
    if (options->experiment.empty()) throw CLI::RequiredError("EXPERIMENT");
    exit_code = run(*options);
  });
}

}  // namespace opal::cli
