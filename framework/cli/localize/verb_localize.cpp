#include "benchmark/runs/event_file.hpp"
#include "benchmark/runs/localize_run.hpp"
#include "benchmark/runs/recorded_log.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/options/log_run_options.hpp"
#include "cli/options/run_products.hpp"
#include "cli/options/verbs.hpp"
#include "cli/terminal/live_view.hpp"
#include "cli/terminal/run_end.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "sensing/log_check.hpp"
#include "session/session.hpp"

#include <opal/deployment/deployment.hpp>
#include "localization/events/run_events.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <optional>

namespace opal::cli {
namespace {

namespace fs = std::filesystem;

struct LocalizeOptions : LogRunOptions {
  bool serve = false;
  int port = LiveServer::kUsualPort;
  double speed = 0;
};

/// What was asked for, ready to run.
struct LocalizeSetup {
  PluginRegistry plugins;
  Deployment deployment;
  benchmark::RecordedLog log;
  std::vector<Query> windows;
  std::string mount_doubt;  ///< in words; empty: the laser's place on the robot is stated
  std::optional<GroundTruth> truth;
  LocalizerParts parts;
  std::vector<std::string> silent_lasers = {};  ///< frames that are described, and have no scan
};

LocalizeSetup set_up(const LocalizeOptions& options) {
  Deployment deployment = options.deployment();
  LocalizeSetup setup{session::load_plugins(deployment), std::move(deployment), {}, {}, {}, {}, {}};
  const auto map = session::load_map(setup.plugins, setup.deployment);
  setup.log = benchmark::read_recorded_log(setup.plugins, options.log, setup.deployment, options.log_words);
  setup.silent_lasers = silent_lasers(setup.log.records, setup.deployment.lasers);
  setup.deployment.lasers = options.lasers_of(setup.log.records, setup.deployment.lasers);
  setup.mount_doubt = options.mount_doubt(setup.log.records, setup.deployment);
  setup.windows = options.windows();
  if (!options.queries.empty()) benchmark::expect_scans(setup.windows, setup.log, options.queries);
  if (!options.truth.empty()) setup.truth = GroundTruth::read(options.truth);
  if (setup.truth) benchmark::expect_overlap(*setup.truth, setup.log, options.truth);
  setup.parts = build_parts(setup.deployment, setup.plugins, map);
  return setup;
}

void tell(const benchmark::LocalizeRun& run, const LocalizeSetup& setup, const std::string& out) {
  run.print();
  if (!setup.mount_doubt.empty()) fmt::print("sensor: {}\n", setup.mount_doubt);
  for (const std::string& frame : setup.silent_lasers) fmt::print("sensor: laser {}: no scan in the log\n", frame);
  for (const auto& [cause, count] : setup.log.defects) fmt::print("log: {}: {} times\n", cause, count);
  for (const std::string& doubt : benchmark::doubts_of(setup.log, setup.deployment.lasers.front()))
    fmt::print("log: {}\n", doubt);
  fmt::print("written to {}: trajectory.tum, results.csv, events.jsonl, first_scan and picture as .svg and .png\n",
             out);
  if (!run.complete() && setup.windows.size() > 1)
    fmt::print("{} of {} queries were finished; results.csv holds these\n", run.finished(), setup.windows.size());
}

int localize(const LocalizeOptions& options) {
  const LocalizeSetup setup = set_up(options);
  const StopSignals signals;  // before other threads
  std::optional<LiveView> live;
  if (options.serve) live.emplace(options.port, signals.token());
  OutputFolder folder(options.out, "opal localize", run_products());
  benchmark::EventFile recorder(folder.file("events.jsonl"));
  NullEventSink nobody;
  EventSplitter events(recorder, live ? live->events() : nobody);
  events.write(run_event({options.log, options.config, setup.deployment.map}, setup.parts.lasers.front()));
  events.write(map_event(*setup.parts.map));

  Localizer localizer(setup.parts, &events);
  benchmark::LocalizeRun run(localizer, setup.deployment.lasers, events, fs::path(options.log).filename().string());
  if (setup.truth) run.set_truth(*setup.truth);
  run.play(setup.log.records, setup.windows, {options.speed, signals.token()}, folder.path());
  recorder.finish();
  run.write(folder.path());
  tell(run, setup, options.out);
  const int exit_code = end_run(folder, run.complete() ? 0 : signals.signal(), run.found() ? kDone : kNo);
  if (live) live->end();
  return exit_code;
}

void add_live_options(CLI::App& verb, const std::shared_ptr<LocalizeOptions>& options) {
  CLI::Option* serve = verb.add_flag("--serve{" + std::to_string(LiveServer::kUsualPort) + "}", options->port,
                                     "show the run while it goes on, to browsers on this machine, until Ctrl-C; "
                                     "--serve=PORT for another port, 0 for any free one");
  serve->check(CLI::Range(-1, 65535, "0 to 65535"));
  CLI::Option* speed =
      verb.add_option("--speed", options->speed, "with --serve: 1 plays the log in real time, 0 as fast as possible");
  speed->check(CLI::NonNegativeNumber)->needs(serve)->default_str("1");
  verb.parse_complete_callback([=] {
    options->serve = serve->count() > 0;
    options->port = std::max(0, options->port);  // a flag's value of 0 reads as "not", which is -1
    if (options->serve && speed->count() == 0) options->speed = 1;
  });
}

}  // namespace

void add_localize_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<LocalizeOptions>();
  CLI::App* verb = app.add_subcommand("localize", "find the robot's pose along a recorded log, from an unknown start");
  options->add_to(*verb, "trajectory, results, events and pictures");
  verb->add_option("--queries", options->queries, "SITE.queries.json: run each query from scratch");
  verb->add_option("--truth", options->truth, "SITE.gt.csv: report the error against recorded truth");
  add_live_options(*verb, options);
  verb->callback([options, &exit_code] { exit_code = localize(*options); });
}

}  // namespace opal::cli
