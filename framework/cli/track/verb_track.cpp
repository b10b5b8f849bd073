#include "benchmark/runs/progress_bar.hpp"
#include "cli/options/damage_options.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/options/log_run_setup.hpp"
#include "cli/options/run_products.hpp"
#include "cli/options/verbs.hpp"
#include "cli/terminal/run_end.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "cli/track/start_poses.hpp"
#include "cli/track/track_output.hpp"
#include "common/phrases.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

namespace opal::cli {
namespace {

struct TrackOptions : LogRunOptions {
  std::string pose, disturb;
  std::uint64_t disturb_seed = 1;
  bool keep_offsets = false, offline = false;
  DamageOptions damage;
};

Deployment deployment_for(const TrackOptions& options) {
  Deployment deployment = options.deployment();
  // Every scan that moved is a pose of its own when the whole log is smoothed.
  if (options.offline) deployment.keyframes = {0.02, 0.02};
  return deployment;
}

void expect_start(const TrackOptions& options) {
  if (options.pose.empty() && options.truth.empty())
    throw ConfigError("opal track: no start pose, expected --pose X,Y,THETA or --truth SITE.gt.csv");
  if (!options.pose.empty() && !options.queries.empty())
    throw ConfigError("opal track: --pose with --queries, expected --truth: every window starts elsewhere");
  if (!options.pose.empty()) read_pose(options.pose);
  if (!options.disturb.empty()) read_disturbance(options.disturb);
}

/// What a person points out on a map.
constexpr double kGivenSigma_m = 0.3, kGivenSigma_rad = 0.1;

StartAt given_start(const Pose2& T_map_base) {
  return [=](double) { return StartPose{T_map_base, {kGivenSigma_m, kGivenSigma_m, kGivenSigma_rad}}; };
}

std::vector<std::string> products(const TrackOptions& options) {
  std::vector<std::string> names = run_products();
  if (options.offline) names.emplace_back("truth.csv");
  return names;
}

/// Tracks one window after the other. @return the last one, which may be cut.
TrackedWindow track_windows(const TrackOptions& options, const LogRunSetup& setup, PoseTracker& tracker,
                            TrackOutput& output, const std::stop_token& stop) {
  const auto pose = options.pose.empty() ? std::nullopt : std::make_optional(read_pose(options.pose));
  const Disturbance disturbance = options.disturb.empty() ? Disturbance{} : read_disturbance(options.disturb);
  const LaserModel& laser = setup.deployment.lasers.front();
  std::optional<StartPoses> starts;
  if (setup.truth) starts.emplace(*setup.truth, laser.T_base_laser, disturbance, options.disturb_seed);
  TrackedWindow window;
  for (const Query& query : setup.windows) {
    if (!options.keep_offsets) tracker.forget_offsets();
    ReplayOptions cut;
    cut.from_s = query.start_s;
    cut.to_s = query.end_s;
    Replay replay(setup.log.records, setup.deployment.lasers, cut);
    window = track_window(tracker, laser, replay, query.id, pose ? given_start(*pose) : starts->next(), stop);
    if (!window.is_cut || setup.windows.size() == 1) output.add(window);
    if (window.is_cut) break;
  }
  return window;
}

/// The whole log, into truth.csv. @return what is believed of the map then; a stop leaves it as it was.
MapBelief smooth(const PoseTracker& tracker, const TrackedWindow& window, TrackOutput& output,
                 const std::stop_token& stop) {
  benchmark::ProgressBar bar;
  const auto goes_on = [&](double share) {
    bar.show(share, "smoothing " + count_of(window.track.size(), "pose"));
    return !stop.stop_requested();
  };
  const Eigen::Vector3d sigma(kGivenSigma_m, kGivenSigma_m, kGivenSigma_rad);
  const auto smoothed = smooth_track(tracker.map(), window.track, sigma, tracker.belief(), {}, goes_on);
  if (!smoothed) return tracker.belief();
  output.write_smoothed(window, *smoothed);
  return smoothed->belief;
}

int track(const TrackOptions& options) {
  expect_start(options);
  const LogRunSetup setup = set_up(options, deployment_for(options), options.damage.asked());
  PoseTracker tracker(setup.parts);
  const StopSignals signals;
  OutputFolder folder(options.out, "opal track", products(options));
  TrackOutput output(folder.path(), setup.deployment.lasers.front(), setup.map, setup.truth);
  const TrackedWindow window = track_windows(options, setup, tracker, output, signals.token());
  const bool is_smoothed = options.offline && !window.is_cut;
  output.write();
  output.write_deviations(is_smoothed ? smooth(tracker, window, output, signals.token()) : tracker.belief());
  if (window.rows.empty() && !window.is_cut)
    throw LogError(options.log + ": no scan with odometry to track" + (setup.truth ? " that the truth covers" : ""));
  setup.tell_doubts();
  if (window.last.lost) fmt::print("lost: at the end the scans do not fit the map where the track is\n");
  return end_run(folder, signals.signal(), window.last.lost ? kNo : kDone);
}

}  // namespace

void add_track_verb(CLI::App& app, int& exit_code) {
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

}  // namespace opal::cli
