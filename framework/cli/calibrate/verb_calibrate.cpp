#include "cli/calibrate/calibrated_sensor.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/options/log_run_options.hpp"
#include "cli/options/verbs.hpp"
#include "common/phrases.hpp"
#include "common/text_file.hpp"
#include "evaluation/site.hpp"
#include "sensing/log_check.hpp"
#include "sensor_health/motion_pairs.hpp"
#include "sensor_health/sensor_judgement.hpp"
#include "session/moved_deployment.hpp"
#include "session/session.hpp"
#include "session/shipped_files.hpp"

#include <opal/common/error.hpp>
#include <opal/deployment/deployment.hpp>
#include <opal/sensing/replay.hpp>

#include <fmt/format.h>

#include <fstream>

namespace opal::cli {
namespace {

struct CalibrateOptions {
  std::string log, config, info, out, motions;
  std::vector<std::string> log_words;
};

std::shared_ptr<const ScanMatcher> matcher_of(const PluginRegistry& registry, const Deployment& deployment) {
  const std::string usual = "opal:PointToLineMatcher";
  if (!deployment.matcher) return registry.make<ScanMatcher>(usual);
  return registry.make<ScanMatcher>(deployment.matcher->type, deployment.matcher->options);
}

struct Timed {
  double end_s = 0;
  MotionPair pair;
};

/// All motions of the log that its scans tell.
std::vector<Timed> motions_of(const std::vector<LogRecord>& records, const LaserModel& laser,
                              std::shared_ptr<const ScanMatcher> matcher) {
  Replay replay(records, {laser});
  MotionPairs motions(std::move(matcher), laser.T_base_laser);
  std::vector<Timed> pairs;
  while (const auto sample = replay.next())
    if (auto pair = motions.add(sample->views.front().scan, sample->T_odom_base))
      pairs.push_back({sample->stamp_s, *pair});
  return pairs;
}

void print(const MotionCalibration& drive, const Pose2& T_base_laser) {
  fmt::print("{} motions, {:.1f} m and {:.1f} rad by odometry\n\n{:<28} {:>10} {:>10} {:>10}\n", drive.pairs,
             drive.driven_m, drive.turned_rad, "", "estimate", "+-", "described");
  const auto row = [](const char* name, double value, double sigma, double described) {
    constexpr double kSaysNothing = 1000;
    if (sigma < kSaysNothing)
      fmt::print("{:<28} {:10.4f} {:10.4f} {:10.4f}\n", name, value, sigma, described);
    else
      fmt::print("{:<28} {:>10} {:>10} {:10.4f}\n", name, "not told", "", described);
  };
  row("mount heading [deg]", degrees(drive.mount_heading_rad.value), degrees(drive.mount_heading_rad.sigma),
      degrees(T_base_laser.heading_rad()));
  row("mount x [m]", drive.mount_position_m.x(), drive.mount_position_sigma_m, T_base_laser.x());
  row("mount y [m]", drive.mount_position_m.y(), drive.mount_position_sigma_m, T_base_laser.y());
  row("odometry, distance scale", drive.distance_scale.value, drive.distance_scale.sigma, 1);
  row("odometry, turn scale", drive.turn_scale.value, drive.turn_scale.sigma, 1);
  fmt::print("\n");
  for (const SensorFinding& finding : judge_motion(drive, T_base_laser)) fmt::print("{}\n", finding.words);
}

void write_motions(const std::vector<Timed>& motions, const std::string& path) {
  std::string text = "end_s,odometry_x_m,odometry_y_m,odometry_heading_rad,scans_x_m,scans_y_m,scans_heading_rad\n";
  for (const Timed& motion : motions) {
    const Pose2 &a = motion.pair.T_odometry, &b = motion.pair.T_scans;
    text += fmt::format("{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f}\n", motion.end_s, a.x(), a.y(),
                        a.heading_rad(), b.x(), b.y(), b.heading_rad());
  }
  write_text(path, text);
}

/// What a deployment takes from a drive. What the drive tells too badly stays as it is described.
struct Calibrated {
  nlohmann::ordered_json mount, odometry;  ///< to merge into the document
  std::vector<std::string> left;           ///< names of what stays
};

Calibrated calibrated_by(const MotionCalibration& drive) {
  Calibrated calibrated;
  const auto take = [&](bool is_told, nlohmann::ordered_json& into, const nlohmann::ordered_json& numbers,
                        const char* name) {
    if (is_told)
      into.update(numbers);
    else
      calibrated.left.emplace_back(name);
  };
  take(drive.mount_position_sigma_m < ToldWithin::position_m, calibrated.mount,
       {{"x_m", drive.mount_position_m.x()}, {"y_m", drive.mount_position_m.y()}}, "the mount's position");
  take(drive.mount_heading_rad.sigma < ToldWithin::heading_rad, calibrated.mount,
       {{"heading_rad", drive.mount_heading_rad.value}}, "the mount's heading");
  take(drive.distance_scale.sigma < ToldWithin::scale, calibrated.odometry,
       {{"distance_scale", drive.distance_scale.value}}, "the distance scale");
  take(drive.turn_scale.sigma < ToldWithin::scale, calibrated.odometry, {{"turn_scale", drive.turn_scale.value}},
       "the turn scale");
  return calibrated;
}

/// @param described  the deployment's laser. @param used  the same with the log's beams and mount.
int write_deployment(const MotionCalibration& drive, const CalibrateOptions& options, const LaserModel& described,
                     const LaserModel& used) {
  const Calibrated calibrated = calibrated_by(drive);
  if (drive.turn_scale.value < 0) {
    fmt::print("not written: a deployment cannot say that scans are mirrored\n");
    return kNo;
  }
  if (calibrated.odometry.empty() && calibrated.mount.empty()) {
    fmt::print("not written: the drive tells too little, expected one of some metres with turns\n");
    return kNo;
  }
  auto document = nlohmann::ordered_json::parse(std::ifstream(options.config));
  const std::string objection =
      calibrated.mount.empty() ? "" : write_mount(document, described, used, calibrated.mount);
  if (!calibrated.odometry.empty()) document["odometry"].merge_patch(calibrated.odometry);
  write_text(options.out, session::moved_deployment(std::move(document), options.config, options.out).dump(2) + '\n');
  fmt::print("written: {}\n", options.out);
  if (!objection.empty()) fmt::print("the mount is not written: {}\n", objection);
  if (!calibrated.left.empty())
    fmt::print("left as described, because the drive tells too little of it: {}\n", listed(calibrated.left));
  return kDone;
}

/// Scans are laid over each other from where odometry and mount say. Where the described mount looks elsewhere, what is
/// found is only a better start.
std::optional<MotionCalibration> calibration_of(std::vector<Timed>& motions, const std::vector<LogRecord>& records,
                                                LaserModel laser, const std::shared_ptr<const ScanMatcher>& matcher) {
  constexpr int kMostRounds = 3;
  constexpr double kElsewhere_rad = 0.17;
  std::optional<MotionCalibration> drive;
  for (int round = 0; round < kMostRounds; ++round) {
    motions = motions_of(records, laser, matcher);
    std::vector<MotionPair> pairs;
    for (const Timed& motion : motions) pairs.push_back(motion.pair);
    drive = calibrate_motion(pairs, laser.T_base_laser);
    if (!drive || !(drive->mount_heading_rad.sigma < ToldWithin::heading_rad)) break;
    const double off_rad = drive->mount_heading_rad.value - laser.T_base_laser.heading_rad();
    if (std::abs(wrap_angle(off_rad)) < kElsewhere_rad) break;
    laser.T_base_laser = Pose2(drive->mount_position_m, drive->mount_heading_rad.value);
  }
  return drive;
}

int calibrate(CalibrateOptions options) {
  options.config = session::config_file(options.config);
  const Deployment deployment = read_deployment(options.config);
  const PluginRegistry registry = session::load_plugins(deployment);
  LaserModel laser = options.info.empty() ? deployment.lasers.front() : read_site_laser(options.info);
  const std::vector<LogRecord> records =
      read_all(*session::open_log(registry, options.log, deployment, options.log_words));
  laser =
      lasers_of_log(records, {laser}, options.log, options.info.empty() ? options.config + ": /sensor" : options.info)
          .front();
  std::vector<Timed> motions;
  const auto drive = calibration_of(motions, records, laser, matcher_of(registry, deployment));
  if (!options.motions.empty()) write_motions(motions, options.motions);
  if (!drive) throw LogError(options.log + ": too few motions that scans tell, expected a drive with turns");
  print(*drive, laser.T_base_laser);
  if (options.out.empty()) return kDone;
  const LaserModel& described = deployment.lasers.front();
  return write_deployment(*drive, options, described, with_log_geometry(described, records));
}

}  // namespace

void add_calibrate_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<CalibrateOptions>();
  CLI::App* verb = app.add_subcommand("calibrate", "the laser's mount and the scales of the odometry, from a drive");
  verb->add_option("CONFIG", options->config, "deployment document, or the name of one that ships")->required();
  verb->add_option("LOG", options->log, "recorded drive with turns; no map is needed")->required();
  verb->add_option("--info", options->info, "SITE.info.json that describes the laser; overrides the deployment's");
  add_log_words(*verb, options->log_words);
  verb->add_option("-o,--out", options->out, "deployment document to write: CONFIG with the estimates in it");
  verb->add_option("--motions", options->motions, "CSV file to write: each motion by odometry and by scans");
  verb->callback([options, &exit_code] { exit_code = calibrate(*options); });
}

}  // namespace opal::cli
