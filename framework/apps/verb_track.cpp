#include "damage_options.hpp"
#include "session.hpp"
#include "track_run.hpp"
#include "verbs.hpp"

#include <opal/deployment.hpp>
#include <opal/error.hpp>
#include <opal/site.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numeric>
#include <random>
#include <sstream>

namespace {

namespace fs = std::filesystem;

struct TrackOptions {
  std::string config, log, out = "out", map, info, queries, truth, pose, disturb;
  std::uint64_t disturb_seed = 1;
  bool keep_offsets = false;
  DamageOptions damage;
};

std::vector<double> read_numbers(const std::string& option, const std::string& text, std::size_t count,
                                 const std::string& expected) {
  std::vector<double> numbers;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) {
    std::size_t used = 0;
    double value = std::numeric_limits<double>::quiet_NaN();
    try {
      value = std::stod(word, &used);
    } catch (const std::exception&) {
    }
    if (used != word.size() || !std::isfinite(value)) numbers.resize(count + 1);
    numbers.push_back(value);
  }
  if (numbers.size() != count) throw opal::ConfigError(option + ": '" + text + "', expected " + expected);
  return numbers;
}

std::ofstream writable(const fs::path& path) {
  std::ofstream file(path);
  if (!file) throw opal::Error(path.string() + ": cannot be written");
  return file;
}

opal::Deployment deployment_for(const TrackOptions& options) {
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

std::vector<opal::Query> windows_of(const TrackOptions& options) {
  if (!options.queries.empty()) return opal::read_queries(options.queries);
  const double forever = std::numeric_limits<double>::infinity();
  return {{"run", -forever, forever}};
}

}  // namespace

static int track(const TrackOptions& options) {
  const opal::PluginRegistry registry = load_plugins();
  opal::Deployment deployment = deployment_for(options);
  auto map = load_map(registry, deployment.map);
  if (options.damage.any()) map = opal::damaged_map(*map, options.damage.damage());
  const auto reader = open_log(registry, options.log);
  const auto records = opal::read_all(*reader);
  deployment.laser = opal::with_log_geometry(deployment.laser, records);
  opal::PoseTrackerOptions to;
  if (const char* env = std::getenv("TRACK_OPTS")) {
    std::istringstream w(env);
    for (std::string k; std::getline(w, k, ',');) {
      const std::string n = k.substr(0, k.find('='));
      const double v = std::stod(k.substr(k.find('=') + 1));
      if (n == "scale") to.offset_scale_m = v;
      if (n == "memory") to.offset_memory_m = v;
      if (n == "nf") to.horizon_features = int(v);
      if (n == "most") to.horizon_most_poses = int(v);
      if (n == "per") to.features_per_scan = int(v);
      if (n == "robust") to.robust_scale = v;
      if (n == "err") to.wall_error_m = v;
      if (n == "a") to.a = v;
      if (n == "b") to.b = v;
      if (n == "c") to.c = v;
    }
  }
  opal::PoseTracker tracker(opal::build_parts(deployment, registry, map), to);
  std::optional<opal::GroundTruth> truth;
  if (!options.truth.empty()) truth = opal::GroundTruth::read(options.truth);
  std::mt19937_64 random(options.disturb_seed);
  Eigen::Vector2d disturb(0, 0);
  if (!options.disturb.empty()) {
    auto n = read_numbers("--disturb", options.disturb, 2, "metres,radians");
    disturb = {n[0], n[1]};
  }
  std::vector<double> cpu;
  for (const auto& query : windows_of(options)) {
    if (!options.keep_offsets) tracker.forget_offsets();
    opal::ReplayOptions w;
    w.from_s = query.start_s;
    w.to_s = query.end_s;
    opal::Replay replay(records, deployment.laser, w);
    std::uniform_real_distribution<double> u(-1, 1);
    const double dx = u(random) * disturb.x(), dy = u(random) * disturb.x(), dh = u(random) * disturb.y();
    auto at = [&](double stamp) -> std::optional<StartPose> {
      StartPose s;
      s.sigma = {0.05 + disturb.x(), 0.05 + disturb.x(), 0.03 + disturb.y()};
      if (!options.pose.empty()) {
        auto n = read_numbers("--pose", options.pose, 3, "X,Y,THETA [m, m, rad]");
        s.T_map_base = {n[0], n[1], n[2]};
        return s;
      }
      auto t = truth->T_map_laser_at(stamp);
      if (!t) return std::nullopt;
      opal::Pose2 p = *t * deployment.laser.T_base_laser.inverse();
      s.T_map_base = {p.x() + dx, p.y() + dy, p.heading_rad() + dh};
      return s;
    };
    auto window = track_window(tracker, deployment.laser, replay, query.id, at);
    cpu.insert(cpu.end(), window.update_cpu_ms.begin(), window.update_cpu_ms.end());
    if (truth) {
      auto e = errors_of(window.rows, *truth), d = errors_of(window.dead_reckoned, *truth);
      std::printf("%-26s scans %4zu  max %.3f p95 %.3f med %.3f | odometry max %.2f med %.2f\n", query.id.c_str(), e.scans, e.max_m,
                  e.p95_m, e.median_m, d.max_m, d.median_m);
    }
    fs::create_directories(options.out);
    auto f = writable(fs::path(options.out) / (query.id + ".csv"));
    opal::write_results(f, window.rows);
  }
  std::sort(cpu.begin(), cpu.end());
  std::printf("cpu mean %.2f median %.2f p99 %.2f max %.2f\n", std::accumulate(cpu.begin(), cpu.end(), 0.0) / cpu.size(),
              cpu[cpu.size() / 2], cpu[cpu.size() * 99 / 100], cpu.back());
  return 0;
}

void opal::add_track_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<TrackOptions>();
  CLI::App* verb = app.add_subcommand("track", "follow the robot along a recorded log, from a given pose");
  verb->add_option("CONFIG", options->config, "deployment document (configs/*.jsonld)")->required();
  verb->add_option("LOG", options->log, "recorded log (CARMEN text, .gz too; ROS 2 bag .db3)")->required();
  verb->add_option("-o,--out", options->out, "folder for what is written")->capture_default_str();
  verb->add_option("--map", options->map, "map document, or a source to import; overrides the deployment's");
  verb->add_option("--info", options->info, "SITE.info.json that describes the laser; overrides the deployment's");
  verb->add_option("--pose", options->pose, "X,Y,THETA of the robot at the first scan, map frame [m, m, rad]");
  verb->add_option("--queries", options->queries, "SITE.queries.json: track each window on its own");
  verb->add_option("--truth", options->truth, "SITE.gt.csv: report the error against recorded truth");
  verb->add_option("--disturb", options->disturb, "METRES,RADIANS by which start poses from the truth are made worse");
  verb->add_option("--disturb-seed", options->disturb_seed);
  options->damage.add_to(*verb);
  verb->callback([options, &exit_code] { exit_code = track(*options); });
}
