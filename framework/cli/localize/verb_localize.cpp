#include "benchmark/runs/event_file.hpp"
#include "benchmark/runs/localize_run.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/options/log_run_setup.hpp"
#include "cli/options/number_option.hpp"
#include "cli/options/run_products.hpp"
#include "cli/options/verbs.hpp"
#include "cli/terminal/live_view.hpp"
#include "cli/terminal/run_end.hpp"
#include "cli/terminal/stop_signals.hpp"
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

void tell(const benchmark::LocalizeRun& run, const LogRunSetup& setup, const std::string& out) {
  run.print();
  setup.tell_doubts();
  fmt::print("written to {}: trajectory.tum, results.csv, events.jsonl, first_scan and picture as .svg and .png\n",
             out);
  if (!run.complete() && setup.windows.size() > 1)
    fmt::print("{} of {} queries were finished; results.csv holds these\n", run.finished(), setup.windows.size());
}

int localize(const LocalizeOptions& options) {
  const LogRunSetup setup = set_up(options, options.deployment());
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
  serve->check(port_of_flag());
  CLI::Option* speed =
      verb.add_option("--speed", options->speed, "with --serve: 1 plays the log in real time, 0 as fast as possible");
  speed->check(zero_or_more())->needs(serve)->default_str("1");
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
