#include "run_record.hpp"
#include "session.hpp"
#include "verbs.hpp"

#include <opal/deployment.hpp>
#include <opal/drawing.hpp>
#include <opal/error.hpp>
#include <opal/ground_truth.hpp>
#include <opal/registration.hpp>
#include <opal/run_events.hpp>
#include <opal/site.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <unistd.h>

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

std::string pose_text(const opal::Pose2& pose) {
  char text[96];
  std::snprintf(text, sizeof text, "x %.2f m, y %.2f m, heading %.1f deg", pose.x(), pose.y(),
                pose.heading_rad() * 180 / std::numbers::pi);
  return text;
}

const opal::LocalFeature* find_local(const opal::LocalMap& map, int id) {
  const auto it = std::find_if(map.features().begin(), map.features().end(),
                               [&](const opal::LocalFeature& f) { return f.id == id; });
  return it == map.features().end() ? nullptr : &*it;
}

/// An association of the best hypothesis with its geometry, in the map frame.
struct NamedAssociation {
  opal::Association pair;
  std::string object, feature;
  opal::DrawingScene::DrawnAssociation geometry;
  double off_m = 0;
};

std::vector<NamedAssociation> associations_of(const opal::Localizer& localizer) {
  std::vector<NamedAssociation> named;
  if (localizer.hypotheses().empty()) return named;
  const opal::Hypothesis& best = localizer.hypotheses().front();
  const opal::SemanticMap& map = localizer.map().map();
  for (const opal::Association& pair : best.associations) {
    const opal::LocalFeature* local = find_local(localizer.local_map(), pair.local_feature);
    if (!local || pair.map_feature < 0) continue;
    const opal::MapFeature& mapped = map.features()[pair.map_feature];
    const opal::Geometry placed = transformed(best.T_map_local, local->feature.geometry);
    named.push_back({pair,
                     map.objects()[mapped.object].id,
                     mapped.id,
                     {placed, mapped.geometry},
                     mismatch(placed, mapped.geometry).position_m});
  }
  return named;
}

void print_answer(const opal::Localizer& localizer, const opal::PoseEstimate& answer) {
  std::cout << "status: " << opal::name_of(answer.status);
  if (answer.has_pose) {
    std::printf(" (probability %.3f, %d hypotheses)\n", answer.probability, answer.hypotheses);
    std::cout << "pose:   " << pose_text(answer.T_map_base) << '\n';
  } else {
    std::cout << "\nno pose\n";
  }
  for (const auto& rival : answer.rivals)
    std::printf("rival:  %s, probability %.3f\n", pose_text(rival.T_map_base).c_str(), rival.probability);
  std::cout << "it rests on:\n";
  for (const NamedAssociation& named : associations_of(localizer))
    std::printf("  local feature %d is %s of %s (%.2f m off)\n", named.pair.local_feature, named.feature.c_str(),
                named.object.c_str(), named.off_m);
  for (const auto& [plugin, count] : localizer.plugin_failures())
    std::printf("skipped: %s failed %d times\n", plugin.c_str(), count);
}

void draw(const opal::Localizer& localizer, const opal::LaserModel& laser, const RunRecord& record,
          const std::vector<opal::StampedPose>& truth, const std::string& title, const fs::path& out) {
  opal::DrawingScene scene;
  scene.title = title;
  const opal::MapView& view = localizer.map();
  scene.map = std::shared_ptr<const opal::SemanticMap>(std::shared_ptr<void>(), &view.map());
  if (record.last.has_pose) {
    const opal::PoseEstimate at_scan = localizer.estimate_at(record.last.stamp_s, record.last_T_odom_base);
    const opal::Pose2 T_map_laser = at_scan.T_map_base * laser.T_base_laser;
    for (const opal::Point& point : record.last_points) scene.scan_points.push_back(T_map_laser * point);
    scene.hypotheses.push_back({record.last.T_map_base, record.last.probability});
    for (const auto& rival : record.last.rivals) scene.hypotheses.push_back({rival.T_map_base, rival.probability});
    scene.notes.push_back(std::string(opal::name_of(record.last.status)) + ": " + pose_text(record.last.T_map_base));
  }
  for (const NamedAssociation& named : associations_of(localizer)) scene.associations.push_back(named.geometry);
  for (const opal::StampedPose& pose : record.trajectory) scene.trajectory.push_back(pose.pose.position());
  for (const opal::StampedPose& pose : truth) scene.truth.push_back(pose.pose.position());
  opal::write_svg(scene, (out / "picture.svg").string());
  opal::write_png(scene, (out / "picture.png").string());
}

void print_errors(const RunRecord& record, const opal::GroundTruth& truth) {
  if (record.rows.empty()) return;
  std::vector<double> errors;
  for (const opal::ResultRow& row : record.rows)
    if (const auto pose = truth.T_map_laser_at(row.stamp_s)) errors.push_back(distance_m(*pose, row.T_map_laser));
  if (errors.empty()) return;
  const double last = errors.back();
  std::sort(errors.begin(), errors.end());
  std::printf("error against the recorded truth: %.3f m now, median %.3f m, worst %.3f m over %zu scans\n", last,
              errors[errors.size() / 2], errors.back(), errors.size());
}

opal::Deployment read_deployment_for(const LocalizeOptions& options) {
  opal::Deployment deployment = opal::read_deployment(options.config);
  if (!options.map.empty()) deployment.map = options.map;
  if (deployment.map.empty()) throw opal::ConfigError(options.config + ": /map: missing; name a map here or with --map");
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

/// The truth of a window, as poses of the robot.
nlohmann::ordered_json truth_event_of(const opal::GroundTruth& truth, const opal::Query& window,
                                      const opal::LaserModel& laser) {
  std::vector<opal::StampedPose> poses;
  for (const opal::StampedPose& pose : truth.poses())
    if (pose.stamp_s >= window.start_s - 1 && pose.stamp_s <= window.end_s + 1)
      poses.push_back({pose.stamp_s, pose.pose * laser.T_base_laser.inverse()});
  return opal::truth_event(poses);
}

int localize(const LocalizeOptions& options) {
  const opal::PluginRegistry registry = load_plugins();
  opal::Deployment deployment = read_deployment_for(options);
  const auto map = load_map(registry, deployment.map);
  const auto reader = open_log(registry, options.log);
  const std::vector<opal::LogRecord> records = opal::read_all(*reader);
  deployment.laser = opal::with_log_geometry(deployment.laser, records);
  const std::vector<opal::Query> windows = windows_of(options);

  const fs::path out = options.out;
  fs::create_directories(out);
  auto event_file = writable(out / "events.jsonl");
  opal::JsonLinesSink events(event_file);
  const opal::LocalizerParts parts = opal::build_parts(deployment, registry, map);
  events.write(opal::run_event({options.log, options.config, deployment.map}, parts.laser));
  events.write(opal::map_event(*parts.map));
  opal::Localizer localizer(parts, &events);
  std::optional<opal::GroundTruth> truth;
  if (!options.truth.empty()) truth = opal::GroundTruth::read(options.truth);

  RunRecord all;
  std::map<std::string, int> odd = reader->defects();
  ProgressBar bar;
  for (std::size_t k = 0; k < windows.size(); ++k) {
    localizer.reset();
    events.write(opal::start_event(windows[k].id));
    if (truth) events.write(truth_event_of(*truth, windows[k], deployment.laser));
    opal::ReplayOptions window;
    window.from_s = windows[k].start_s;
    window.to_s = windows[k].end_s;
    opal::Replay replay(records, deployment.laser, window);
    const auto progress = [&](double share) { bar.show((double(k) + share) / double(windows.size())); };
    const RunRecord one = run_log(localizer, deployment.laser, replay, windows[k].id, progress);
    for (const auto& [cause, count] : replay.counts()) odd[cause] += count;
    all.append(one);
  }
  bar.show(1);

  auto tum = writable(out / "trajectory.tum");
  opal::write_tum(tum, all.trajectory);
  auto results = writable(out / "results.csv");
  opal::write_results(results, all.rows);
  print_answer(localizer, all.last);
  for (const auto& [cause, count] : odd) std::printf("log: %s: %d times\n", cause.c_str(), count);
  std::vector<opal::StampedPose> true_poses;
  if (truth) {
    print_errors(all, *truth);
    true_poses = truth->poses();
  }
  draw(localizer, deployment.laser, all, true_poses, fs::path(options.log).filename().string(), out);
  std::cout << "written: " << (out / "trajectory.tum").string() << ", results.csv, events.jsonl, picture.svg, picture.png\n";
  return all.last.has_pose && all.last.status != opal::Status::lost ? 0 : 1;
}

}  // namespace

void opal::add_localize_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<LocalizeOptions>();
  CLI::App* verb = app.add_subcommand("localize", "find the robot's pose along a recorded log, from an unknown start");
  verb->add_option("CONFIG", options->config, "deployment document (configs/*.jsonld)")->required();
  verb->add_option("LOG", options->log, "recorded log (CARMEN text, .gz too; ROS 2 bag .db3)")->required();
  verb->add_option("-o,--out", options->out, "folder for trajectory, results, events and pictures")
      ->capture_default_str();
  verb->add_option("--map", options->map, "map document, or a source to import; overrides the deployment's");
  verb->add_option("--info", options->info, "SITE.info.json that describes the laser; overrides the deployment's");
  verb->add_option("--queries", options->queries, "SITE.queries.json: run each query from scratch");
  verb->add_option("--truth", options->truth, "SITE.gt.csv: report the error against recorded truth");
  verb->callback([options, &exit_code] { exit_code = localize(*options); });
}
