#include "benchmark/experiments/challenges/challenge_run.hpp"

#include <algorithm>

namespace opal::experiments {
namespace {

void judge_success(ChallengeRun& run) {
  const std::vector<JudgedMoment>& moments = run.moments;
  std::size_t right_from = moments.size();
  while (right_from > 0 && moments[right_from - 1].right()) --right_from;
  run.success = right_from < moments.size();
  if (!run.success) return;
  run.right_after_m = moments[right_from].driven_m;
  double sum = 0;
  for (std::size_t k = right_from; k < moments.size(); ++k) sum += moments[k].error_m();
  run.error_m = sum / static_cast<double>(moments.size() - right_from);
}

/// Of the best hypothesis that is right.
double probability_of(const PoseEstimate& said, const Pose2& truth) {
  if (said.has_pose && kRightPose.holds(said.T_map_base, truth)) return said.probability;
  for (const PoseEstimate::Alternative& alternative : said.alternatives)
    if (kRightPose.holds(alternative.T_map_base, truth)) return alternative.probability;
  return 0;
}

}  // namespace

void judge(ChallengeRun& run) {
  judge_success(run);
  for (const JudgedMoment& moment : run.moments) {
    int& most = run.localized_after_m ? run.hypotheses_after : run.hypotheses_before;
    most = std::max(most, moment.hypotheses);
    run.updates += moment.cpu_ms > 0;
    run.cpu_ms += moment.cpu_ms;
    if (!moment.localized()) continue;
    if (!run.localized_after_m) run.localized_after_m = moment.driven_m;
    ++run.localized_rows;
    run.false_rows += !moment.right();
  }
  if (run.updates > 0) run.cpu_ms /= run.updates;
}

ChallengeRun run_challenge(const Contender& contender, const PluginRegistry& registry,
                           std::shared_ptr<const SemanticMap> map, const simulation::ChallengeDrive& driven) {
  const simulation::Recording& recording = driven.recording;
  Deployment deployment = with_lasers(contender.deployment, {recording.laser});
  if (driven.region) deployment.stages.search.region = driven.region;
  Localizer localizer(build_parts(deployment, registry, std::move(map)));
  ChallengeRun run;
  run.contender = contender.name;
  run.region = driven.region;
  double driven_m = 0;
  Pose2 before = recording.scans.front().T_map_base;
  PoseEstimate said;
  for (const simulation::RecordedScan& recorded : recording.scans) {
    driven_m += distance_m(before, recorded.T_map_base);
    before = recorded.T_map_base;
    const Scan scan = make_scan(recorded.scan, deployment.lasers.front());
    const bool updated =
        localizer.update(sample_of(scan, *recorded.scan.T_odom_base, deployment.lasers.front().T_base_laser))
            .has_value();
    said = localizer.estimate_at(scan.stamp_s, *recorded.scan.T_odom_base);
    run.moments.push_back({scan.stamp_s - recording.scans.front().scan.stamp_s, driven_m, recorded.T_map_base,
                           said.T_map_base, said.has_pose, said.status, said.hypotheses,
                           updated ? 1e3 * localizer.last_times().total_s() : 0, false});
  }
  judge(run);
  run.truth_probability = probability_of(said, recording.scans.back().T_map_base);
  return run;
}

}  // namespace opal::experiments
