#include "cli/options/damage_options.hpp"
#include "cli/options/log_run_options.hpp"
#include "cli/options/verbs.hpp"
#include "cli/track/start_poses.hpp"
#include "cli/track/track_output.hpp"
#include "session/session.hpp"

#include <opal/common/error.hpp>
#include <opal/deployment/deployment.hpp>

namespace {

struct TrackOptions : LogRunOptions {
  std::string pose, disturb;
  std::uint64_t disturb_seed = 1;
  bool keep_offsets = false, offline = false;
  DamageOptions damage;
};

opal::Deployment deployment_for(const TrackOptions& options) {
  opal::Deployment deployment = options.deployment();
  // Every scan that moved is a pose of its own when the whole log is smoothed.
  if (options.offline) deployment.keyframes = {0.02, 0.02};
  return deployment;
}

void expect_start(const TrackOptions& options) {
  if (options.pose.empty() && options.truth.empty())
    throw opal::ConfigError("opal track: no start pose, expected --pose X,Y,THETA or --truth SITE.gt.csv");
  if (!options.pose.empty() && !options.queries.empty())
    throw opal::ConfigError("opal track: --pose with --queries, expected --truth: every window starts elsewhere");
}

/// What a person points out on a map.
constexpr double kGivenSigma_m = 0.3, kGivenSigma_rad = 0.1;

StartAt given_start(const opal::Pose2& T_map_base) {
  return [=](double) { return StartPose{T_map_base, {kGivenSigma_m, kGivenSigma_m, kGivenSigma_rad}}; };
}

int track(const TrackOptions& options) {
  expect_start(options);
  const auto pose = options.pose.empty() ? std::nullopt : std::make_optional(read_pose(options.pose));
  const Disturbance disturbance = options.disturb.empty() ? Disturbance{} : read_disturbance(options.disturb);
  const opal::PluginRegistry registry = load_plugins();
  opal::Deployment deployment = deployment_for(options);
  auto map = load_map(registry, deployment);
  if (options.damage.any()) map = opal::damaged_map(*map, options.damage.damage());
  const auto reader = open_log(registry, options.log, deployment, options.log_words);
  const std::vector<opal::LogRecord> records = opal::read_all(*reader);
  deployment.laser = options.laser_of(records, deployment.laser);
  std::optional<opal::GroundTruth> truth;
  if (!options.truth.empty()) truth = opal::GroundTruth::read(options.truth);
  std::optional<StartPoses> starts;
  if (truth) starts.emplace(*truth, deployment.laser.T_base_laser, disturbance, options.disturb_seed);

  opal::PoseTracker tracker(opal::build_parts(deployment, registry, map));
  TrackOutput output(options.out, deployment.laser, map, truth);
  TrackedWindow window;
  for (const opal::Query& query : options.windows()) {
    if (!options.keep_offsets) tracker.forget_offsets();
    opal::ReplayOptions cut;
    cut.from_s = query.start_s;
    cut.to_s = query.end_s;
    opal::Replay replay(records, deployment.laser, cut);
    window = track_window(tracker, deployment.laser, replay, query.id, pose ? given_start(*pose) : starts->next());
    output.add(window);
  }
  opal::MapBelief belief = tracker.belief();
  if (options.offline) {
    const opal::SmoothedTrack smoothed =
        opal::smooth_track(tracker.map(), window.track, {kGivenSigma_m, kGivenSigma_m, kGivenSigma_rad}, belief);
    output.write_smoothed(window, smoothed);
    belief = smoothed.belief;
  }
  output.write();
  output.write_deviations(belief);
  if (window.rows.empty())
    throw opal::LogError(options.log + ": no scan with odometry to track" + (truth ? " that the truth covers" : ""));
  return window.last.lost ? 1 : 0;
}

}  // namespace

void opal::add_track_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<TrackOptions>();
  CLI::App* verb = app.add_subcommand(
      "track", "follow the robot along a recorded log from a known pose; where the building differs from its map");
  options->add_to(*verb, "trajectory, results, summary, pictures and deviations");
  verb->add_option(
      "--pose", options->pose,
      "X,Y,THETA of the robot at the first scan, map frame [m, m, rad], within about 0.5 m and 10 degrees");
  verb->add_option("--queries", options->queries, "SITE.queries.json: track each window on its own, from the truth");
  verb->add_option("--truth", options->truth,
                   "SITE.gt.csv: report the error against recorded truth; without --pose, start from it");
  verb->add_option("--disturb", options->disturb, "METRES,RADIANS by which start poses from the truth are made worse");
  verb->add_option("--disturb-seed", options->disturb_seed, "of the disturbance")->capture_default_str();
  verb->add_flag("--keep-offsets", options->keep_offsets,
                 "with --queries: a window begins with what the ones before have taught about the map");
  verb->add_flag("--offline", options->offline,
                 "smooth the whole log afterwards, and write it as truth.csv (of the last window, with --queries)");
  options->damage.add_to(*verb);
  verb->callback([options, &exit_code] { exit_code = track(*options); });
}
