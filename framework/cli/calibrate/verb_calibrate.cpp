#include "cli/options/verbs.hpp"
#include "common/text_file.hpp"
#include "evaluation/site.hpp"
#include "sensing/log_check.hpp"
#include "sensor_health/motion_pairs.hpp"
#include "sensor_health/sensor_judgement.hpp"
#include "session/session.hpp"
#include "session/shipped_files.hpp"

#include <opal/common/error.hpp>
#include <opal/common/sentence.hpp>
#include <opal/common/strict_json.hpp>
#include <opal/deployment/deployment.hpp>
#include <opal/sensing/replay.hpp>

#include <cstdio>
#include <fstream>

namespace {

struct CalibrateOptions {
  std::string log, config, info, out, motions;
};

std::shared_ptr<const opal::ScanMatcher> matcher_of(const opal::PluginRegistry& registry,
                                                    const opal::Deployment& deployment) {
  const std::string usual = "opal:PointToLineMatcher";
  if (!deployment.matcher) return registry.make<opal::ScanMatcher>(usual);
  return registry.make<opal::ScanMatcher>(deployment.matcher->type, deployment.matcher->options);
}

struct Timed {
  double end_s = 0;
  opal::MotionPair pair;
};

/// All motions of the log that its scans tell.
std::vector<Timed> motions_of(const std::vector<opal::LogRecord>& records, const opal::LaserModel& laser,
                              std::shared_ptr<const opal::ScanMatcher> matcher) {
  opal::Replay replay(records, {laser});
  opal::MotionPairs motions(std::move(matcher), laser.T_base_laser);
  std::vector<Timed> pairs;
  while (const auto sample = replay.next())
    if (auto pair = motions.add(sample->views.front().scan, sample->T_odom_base))
      pairs.push_back({sample->stamp_s, *pair});
  return pairs;
}

void print(const opal::MotionCalibration& drive, const opal::Pose2& T_base_laser) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  std::printf("%d motions, %.1f m and %.1f rad by odometry\n\n%-28s %10s %10s %10s\n", drive.pairs, drive.driven_m,
              drive.turned_rad, "", "estimate", "+-", "described");
  const auto row = [](const char* name, double value, double sigma, double described) {
    std::printf("%-28s %10.4f %10.4f %10.4f\n", name, value, sigma, described);
  };
  row("mount heading [deg]", drive.mount_heading_rad.value * kDegrees, drive.mount_heading_rad.sigma * kDegrees,
      T_base_laser.heading_rad() * kDegrees);
  row("mount x [m]", drive.mount_position_m.x(), drive.mount_position_sigma_m, T_base_laser.x());
  row("mount y [m]", drive.mount_position_m.y(), drive.mount_position_sigma_m, T_base_laser.y());
  row("odometry, distance scale", drive.distance_scale.value, drive.distance_scale.sigma, 1);
  row("odometry, turn scale", drive.turn_scale.value, drive.turn_scale.sigma, 1);
  std::printf("\n");
  for (const opal::SensorFinding& finding : judge_motion(drive, T_base_laser))
    std::printf("%s\n", finding.words.c_str());
}

void write_motions(const std::vector<Timed>& motions, const std::string& path) {
  std::string text = "end_s,odometry_x_m,odometry_y_m,odometry_heading_rad,scans_x_m,scans_y_m,scans_heading_rad\n";
  for (const Timed& motion : motions) {
    const opal::Pose2 &a = motion.pair.T_odometry, &b = motion.pair.T_scans;
    text += opal::sentence("%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f\n", motion.end_s, a.x(), a.y(), a.heading_rad(), b.x(),
                           b.y(), b.heading_rad());
  }
  opal::write_text(path, text);
}

void write_deployment(const opal::MotionCalibration& drive, const CalibrateOptions& options) {
  auto document = nlohmann::ordered_json::parse(std::ifstream(options.config));
  document["sensor"]["T_base_laser"] = {{"x_m", drive.mount_position_m.x()},
                                        {"y_m", drive.mount_position_m.y()},
                                        {"heading_rad", drive.mount_heading_rad.value}};
  document["odometry"] = {{"distance_scale", drive.distance_scale.value}, {"turn_scale", drive.turn_scale.value}};
  opal::write_text(options.out, document.dump(2) + '\n');
  std::printf("written: %s\n", options.out.c_str());
}

int calibrate(CalibrateOptions options) {
  options.config = config_file(options.config);
  const opal::Deployment deployment = opal::read_deployment(options.config);
  const opal::PluginRegistry registry = load_plugins(deployment);
  opal::LaserModel laser = options.info.empty() ? deployment.lasers.front() : opal::read_site_laser(options.info);
  const std::vector<opal::LogRecord> records = opal::read_all(*open_log(registry, options.log, deployment));
  laser = opal::lasers_of_log(records, {laser}, options.log,
                              options.info.empty() ? options.config + ": /sensor" : options.info)
              .front();
  const auto motions = motions_of(records, laser, matcher_of(registry, deployment));
  if (!options.motions.empty()) write_motions(motions, options.motions);
  std::vector<opal::MotionPair> pairs;
  for (const Timed& motion : motions) pairs.push_back(motion.pair);
  const auto drive = opal::calibrate_motion(pairs, laser.T_base_laser);
  if (!drive) throw opal::LogError(options.log + ": too few motions that scans tell, expected a drive with turns");
  print(*drive, laser.T_base_laser);
  if (!options.out.empty()) write_deployment(*drive, options);
  return 0;
}

}  // namespace

void opal::add_calibrate_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<CalibrateOptions>();
  CLI::App* verb = app.add_subcommand("calibrate", "the laser's mount and the scales of the odometry, from a drive");
  verb->add_option("CONFIG", options->config, "deployment document, or the name of one that ships")->required();
  verb->add_option("LOG", options->log, "recorded drive with turns; no map is needed")->required();
  verb->add_option("--info", options->info, "SITE.info.json that describes the laser; overrides the deployment's");
  verb->add_option("-o,--out", options->out, "deployment document to write: CONFIG with the estimates in it");
  verb->add_option("--motions", options->motions, "CSV file to write: each motion by odometry and by scans");
  verb->callback([options, &exit_code] { exit_code = calibrate(*options); });
}
