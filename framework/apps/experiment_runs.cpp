#include "experiment_runs.hpp"

#include <algorithm>

namespace {

/// What a run says at one scan, beside the truth.
struct JudgedScan {
  double error_m = 0, driven_m = 0;
  bool has_pose = false, localized = false;
};

void judge(const std::vector<JudgedScan>& scans, ExperimentRun& run) {
  constexpr double kRight_m = 1;
  std::size_t right_from = scans.size();
  while (right_from > 0 && scans[right_from - 1].has_pose && scans[right_from - 1].error_m < kRight_m) --right_from;
  run.success = right_from < scans.size();
  if (run.success) {
    run.right_after_m = scans[right_from].driven_m;
    double sum = 0;
    for (std::size_t k = right_from; k < scans.size(); ++k) sum += scans[k].error_m;
    run.error_m = sum / static_cast<double>(scans.size() - right_from);
  }
  for (const JudgedScan& scan : scans) {
    if (!scan.localized) continue;
    if (run.localized_after_m < 0) run.localized_after_m = scan.driven_m;
    ++run.localized_rows;
    run.false_rows += scan.error_m > kRight_m;
  }
}

}  // namespace

ExperimentRun run_challenge(const Contender& contender, const opal::PluginRegistry& registry,
                            std::shared_ptr<const opal::SemanticMap> map, const opal::simulation::ChallengeDrive& driven) {
  const opal::simulation::Recording& recording = driven.recording;
  opal::Deployment deployment = contender.deployment;
  const std::string sensor = deployment.laser.id;
  deployment.laser = recording.laser;
  deployment.laser.id = sensor;
  if (driven.region)
    deployment.association["region"] = {
        {"x_m", driven.region->center.x()}, {"y_m", driven.region->center.y()}, {"radius_m", driven.region->radius_m}};
  opal::Localizer localizer(opal::build_parts(deployment, registry, std::move(map)));
  ExperimentRun run;
  run.contender = contender.name;
  std::vector<JudgedScan> judged;
  bool was_localized = false;
  double driven_m = 0;
  opal::Pose2 before = recording.scans.front().T_map_base;
  for (const opal::simulation::RecordedScan& recorded : recording.scans) {
    driven_m += distance_m(before, recorded.T_map_base);
    before = recorded.T_map_base;
    const opal::Scan scan = opal::make_scan(recorded.scan, deployment.laser);
    if (const auto updated = localizer.update(scan, *recorded.scan.T_odom_base)) {
      ++run.updates;
      run.cpu_ms += 1e3 * localizer.last_times().total_s();
      int& most = was_localized ? run.hypotheses_after : run.hypotheses_before;
      most = std::max(most, updated->hypotheses);
    }
    const opal::PoseEstimate said = localizer.estimate_at(scan.stamp_s, *recorded.scan.T_odom_base);
    const bool localized = said.status == opal::Status::localized;
    was_localized = was_localized || localized;
    judged.push_back({distance_m(said.T_map_base, recorded.T_map_base), driven_m, said.has_pose, localized});
    if (judged.size() % 5 == 1) run.truth.push_back(recorded.T_map_base.position());
  }
  judge(judged, run);
  if (run.updates > 0) run.cpu_ms /= run.updates;
  return run;
}
