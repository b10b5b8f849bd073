#include "answer.hpp"
#include "run_picture.hpp"
#include "run_record.hpp"
#include "session.hpp"
#include "verbs.hpp"

#include <opal/deployment.hpp>
#include <opal/error.hpp>
#include <opal/ground_truth.hpp>
#include <opal/registration.hpp>
#include <opal/site.hpp>

#include <unistd.h>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace {

namespace fs = std::filesystem;

struct LocalizeOptions {
  std::string config, log, out = "out", map, info, queries, truth;
};

std::ofstream writable(const fs::path& path) {
  std::ofstream file(path);
  if (!file) throw opal::Error(path.string() + ": cannot be written");
  return file;
}

/// A bar on a terminal, nothing elsewhere.
class ProgressBar {
 public:
  void show(double share) {
    const int percent = static_cast<int>(100 * share);
    if (!terminal_ || percent == shown_) return;
    shown_ = percent;
    std::fprintf(stderr, "\r[%-50.*s] %3d %%", 50, bar(percent).c_str(), percent);
  }
  ~ProgressBar() {
    if (terminal_ && shown_ >= 0) std::fputc('\n', stderr);
  }

 private:
  static std::string bar(int percent) { return std::string(std::clamp(percent / 2, 0, 50), '#'); }
  const bool terminal_ = isatty(STDERR_FILENO) != 0;
  int shown_ = -1;
};

void write_picture(opal::DrawingScene scene, const std::string& title, const fs::path& without_extension) {
  scene.title = title;
  opal::write_svg(scene, without_extension.string() + ".svg");
  opal::write_png(scene, without_extension.string() + ".png");
}

void print_errors(const RunRecord& record, const opal::GroundTruth& truth) {
  if (record.rows.empty()) return;
  std::vector<double> errors;
  for (const opal::ResultRow& row : record.rows)
    if (const auto pose = truth.T_map_laser_at(row.stamp_s))
      errors.push_back(distance_m(*pose, row.T_map_laser));
  if (errors.empty()) return;
  const double last = errors.back();
  std::sort(errors.begin(), errors.end());
  std::printf("error against the recorded truth: %.3f m now, median %.3f m, worst %.3f m over %zu scans\n",
              last, errors[errors.size() / 2], errors.back(), errors.size());
}

opal::Deployment read_deployment_for(const LocalizeOptions& options) {
  opal::Deployment deployment = opal::read_deployment(options.config);
  if (!options.map.empty()) deployment.map = options.map;
  if (deployment.map.empty())
    throw opal::ConfigError(options.config + ": /map: missing; name a map here or with --map");
  if (!options.info.empty()) {
    const std::string sensor = deployment.laser.id;
    deployment.laser = opal::read_site_laser(options.info);
    deployment.laser.id = sensor;
  }
  return deployment;
}

std::vector<opal::Query> windows_of(const LocalizeOptions& options) {
  if (!options.queries.empty()) return opal::read_queries(options.queries);
  const double forever = std::numeric_limits<double>::infinity();
  return {{"run", -forever, forever}};
}

/// One localizer over all windows of a log, and what it leaves behind.
class LocalizeRun {
 public:
  LocalizeRun(opal::Localizer& localizer, const opal::LaserModel& laser, const LocalizeOptions& options)
      : localizer_(localizer),
        laser_(laser),
        out_(options.out),
        log_(fs::path(options.log).filename().string()) {
    if (!options.truth.empty()) truth_ = opal::GroundTruth::read(options.truth);
  }

  void play(const std::vector<opal::LogRecord>& records, const std::vector<opal::Query>& windows) {
    ProgressBar bar;
    for (std::size_t k = 0; k < windows.size(); ++k) {
      localizer_.reset();
      opal::ReplayOptions window;
      window.from_s = windows[k].start_s;
      window.to_s = windows[k].end_s;
      opal::Replay replay(records, laser_, window);
      RunObserver observer;
      observer.progress = [&](double share) { bar.show((double(k) + share) / double(windows.size())); };
      observer.updated = [this](const RunRecord& so_far) { draw_first_scan(so_far); };
      newest_ = run_log(localizer_, laser_, replay, windows[k].id, observer);
      for (const auto& [cause, count] : replay.counts()) oddities_[cause] += count;
      all_.append(newest_);
    }
    bar.show(1);
  }

  void write() const {
    auto tum = writable(out_ / "trajectory.tum");
    opal::write_tum(tum, all_.trajectory);
    auto results = writable(out_ / "results.csv");
    opal::write_results(results, all_.rows);
    draw("at the end", newest_, "picture");
  }

  void print() const {
    print_answer(localizer_, all_.last);
    for (const auto& [cause, count] : oddities_) std::printf("log: %s: %d times\n", cause.c_str(), count);
    if (truth_) print_errors(all_, *truth_);
    std::printf(
        "written to %s: trajectory.tum, results.csv, events.jsonl, first_scan and picture as .svg and .png\n",
        out_.string().c_str());
  }

  bool found() const { return all_.last.has_pose && all_.last.status != opal::Status::lost; }

 private:
  /// All that the first scans leave possible: the picture to compare the end with.
  void draw_first_scan(const RunRecord& so_far) {
    if (first_scan_drawn_ || so_far.last.hypotheses == 0) return;
    draw("first scan", so_far, "first_scan");
    first_scan_drawn_ = true;
  }

  void draw(const std::string& moment, const RunRecord& record, const std::string& file) const {
    opal::DrawingScene scene = scene_of(localizer_, laser_, record);
    if (truth_) add_truth(scene, truth_->poses(), laser_);
    write_picture(std::move(scene), log_ + ": " + moment, out_ / file);
  }

  opal::Localizer& localizer_;
  const opal::LaserModel& laser_;
  const fs::path out_;
  const std::string log_;
  std::optional<opal::GroundTruth> truth_;
  RunRecord all_, newest_;
  std::map<std::string, int> oddities_;
  bool first_scan_drawn_ = false;
};

int localize(const LocalizeOptions& options) {
  const opal::PluginRegistry registry = load_plugins();
  opal::Deployment deployment = read_deployment_for(options);
  const auto map = load_map(registry, deployment.map);
  const auto reader = open_log(registry, options.log);
  const std::vector<opal::LogRecord> records = opal::read_all(*reader);
  deployment.laser = opal::with_log_geometry(deployment.laser, records);
  const std::vector<opal::Query> windows = windows_of(options);

  fs::create_directories(options.out);
  auto event_file = writable(fs::path(options.out) / "events.jsonl");
  opal::JsonLinesSink events(event_file);
  opal::Localizer localizer(opal::build_parts(deployment, registry, map), &events);

  LocalizeRun run(localizer, deployment.laser, options);
  run.play(records, windows);
  run.write();
  run.print();
  for (const auto& [cause, count] : reader->defects())
    std::printf("log: %s: %d times\n", cause.c_str(), count);
  return run.found() ? 0 : 1;
}

}  // namespace

void opal::add_localize_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<LocalizeOptions>();
  CLI::App* verb =
      app.add_subcommand("localize", "find the robot's pose along a recorded log, from an unknown start");
  verb->add_option("CONFIG", options->config, "deployment document (configs/*.jsonld)")->required();
  verb->add_option("LOG", options->log, "recorded log (CARMEN text, .gz too; ROS 2 bag .db3)")->required();
  verb->add_option("-o,--out", options->out, "folder for trajectory, results, events and pictures")
      ->capture_default_str();
  verb->add_option("--map", options->map, "map document, or a source to import; overrides the deployment's");
  verb->add_option("--info", options->info,
                   "SITE.info.json that describes the laser; overrides the deployment's");
  verb->add_option("--queries", options->queries, "SITE.queries.json: run each query from scratch");
  verb->add_option("--truth", options->truth, "SITE.gt.csv: report the error against recorded truth");
  verb->callback([options, &exit_code] { exit_code = localize(*options); });
}
