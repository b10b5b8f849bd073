#include "benchmark/runs/localize_run.hpp"
#include "cli/options/log_run_options.hpp"
#include "cli/options/verbs.hpp"
#include "cli/terminal/live_view.hpp"
#include "session/session.hpp"

#include <opal/common/error.hpp>
#include <opal/deployment/deployment.hpp>
#include "localization/events/run_events.hpp"

#include <filesystem>
#include <fstream>
#include <optional>

namespace {

namespace fs = std::filesystem;

struct LocalizeOptions : LogRunOptions {
  bool serve = false;
  int port = opal::LiveServer::kUsualPort;
  double speed = 0;
};

std::ofstream event_file(const fs::path& out) {
  fs::create_directories(out);
  std::ofstream file(out / "events.jsonl");
  if (!file) throw opal::Error((out / "events.jsonl").string() + ": cannot be written");
  return file;
}

int localize(const LocalizeOptions& options) {
  const opal::PluginRegistry registry = load_plugins();
  opal::Deployment deployment = options.deployment();
  const auto map = load_map(registry, deployment);
  const auto reader = open_log(registry, options.log, deployment, options.log_words);
  const std::vector<opal::LogRecord> records = opal::read_all(*reader);
  deployment.laser = options.laser_of(records, deployment.laser);
  const std::vector<opal::Query> windows = options.windows();
  const opal::LocalizerParts parts = opal::build_parts(deployment, registry, map);

  std::optional<LiveView> live;
  if (options.serve) live.emplace(options.port);
  std::ofstream file = event_file(options.out);
  opal::JsonLinesSink recorder(file);
  opal::NullEventSink nobody;
  EventSplitter listeners(recorder, live ? live->events() : nobody);
  LastReason events(listeners);
  events.write(opal::run_event({options.log, options.config, deployment.map}, parts.laser));
  events.write(opal::map_event(*parts.map));

  opal::Localizer localizer(parts, &events);
  LocalizeRun run(localizer, deployment.laser, events, fs::path(options.log).filename().string());
  if (!options.truth.empty()) run.set_truth(opal::GroundTruth::read(options.truth));
  run.play(records, windows, {options.speed, live ? live->stop() : std::stop_token()}, options.out);
  file.close();
  run.write(options.out);
  run.print();
  for (const auto& [cause, count] : reader->defects()) std::printf("log: %s: %d times\n", cause.c_str(), count);
  std::printf("written to %s: trajectory.tum, results.csv, events.jsonl, first_scan and picture as .svg and .png\n",
              options.out.c_str());
  if (live) live->end();
  return run.found() ? 0 : 1;
}

void add_live_options(CLI::App& verb, const std::shared_ptr<LocalizeOptions>& options) {
  CLI::Option* serve = verb.add_flag("--serve{" + std::to_string(opal::LiveServer::kUsualPort) + "}", options->port,
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

void opal::add_localize_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<LocalizeOptions>();
  CLI::App* verb = app.add_subcommand("localize", "find the robot's pose along a recorded log, from an unknown start");
  options->add_to(*verb, "trajectory, results, events and pictures");
  verb->add_option("--queries", options->queries, "SITE.queries.json: run each query from scratch");
  verb->add_option("--truth", options->truth, "SITE.gt.csv: report the error against recorded truth");
  add_live_options(*verb, options);
  verb->callback([options, &exit_code] { exit_code = localize(*options); });
}
