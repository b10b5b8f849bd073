#include "benchmark/experiments/integrity/integrity_run.hpp"

#include "benchmark/experiments/kit/recorded_way.hpp"
#include "evaluation/pose_tolerance.hpp"
#include "live/live_core.hpp"

namespace opal::experiments {
namespace {

/// Watches the answers of one drive.
class Watch {
 public:
  Watch(const DrawnDrive& drive, const simulation::Recording& recording, IntegrityRun& run)
      : drive_(drive), window_(event_window(drive)), recording_(recording), way_(recording), run_(run) {
    run_.driven_m = way_.all_m();
  }

  JudgedAnswer see(const LiveAnswer& answer, double now_s) {
    JudgedAnswer judged;
    judged.stamp_s = simulation::true_stamp_s(drive_.fault, window_, answer.stamp_s, now_s);
    judged.truth = simulation::truth_at(recording_, judged.stamp_s);
    judged.said = answer.estimate.T_map_base;
    judged.is_localized = answer.estimate.status == Status::localized;
    judged.is_right = judged.is_localized && kRightPose.holds(judged.said, judged.truth);
    count(judged);
    return judged;
  }

 private:
  void count(const JudgedAnswer& judged) {
    ++run_.answers;
    run_.is_right = judged.is_right;
    run_.duration_s = judged.stamp_s;
    run_.localized.add(judged.stamp_s, judged.is_localized, judged.is_right);
    if (!judged.is_right) return;
    if (!run_.localized_after_m) run_.localized_after_m = way_.driven_m(judged.stamp_s);
    if (judged.stamp_s >= window_.to_s && !run_.recovered_after_s)
      run_.recovered_after_s = judged.stamp_s - window_.to_s;
  }

  const DrawnDrive& drive_;
  simulation::FaultWindow window_;
  const simulation::Recording& recording_;
  RecordedWay way_;
  IntegrityRun& run_;
};

std::vector<simulation::Arrival> arrivals(const DrawnDrive& drive, const simulation::Recording& recording,
                                          const Deployment& robot) {
  const double sweep_s = recording.laser.sweep_s.value_or(0);
  return simulation::with_fault(simulation::arrivals_of(records_of(recording), sweep_s), drive.fault,
                                event_window(drive), robot.lasers.back().frame, Random(drive.seed + 7));
}

/// The numbers of a run by name. @param visit  gets a name and a double, or an optional one.
template <class Run, class Visit>
void for_each_value(Run& run, Visit visit) {
  visit("wrong_s", run.localized.wrong_s);
  visit("longest_wrong_s", run.localized.longest_wrong_s);
  visit("wrong_from_s", run.localized.wrong_from_s);
  visit("localized_s", run.localized.right_s);
  visit("localized_after_m", run.localized_after_m);
  visit("recovered_after_s", run.recovered_after_s);
  visit("driven_m", run.driven_m);
  visit("duration_s", run.duration_s);
}

}  // namespace

IntegrityRun run_drive(const DrawnDrive& drive, const DriveWorld& world, const CampaignRobots& robots,
                       const IntegrityObserver& observer) {
  const Deployment& robot = robots.of(drive);
  const simulation::Recording recording = recorded(drive, world, robot);
  if (observer.begins) observer.begins(recording);
  IntegrityRun run;
  Watch watch(drive, recording, run);
  LiveCore core(build_parts(robot, *robots.registry, world.map), {}, observer.events);
  for (const simulation::Arrival& arrival : arrivals(drive, recording, robot))
    core.take(arrival.record, arrival.at_s, arrival.at_s, [&](const LiveAnswer& answer) {
      const JudgedAnswer judged = watch.see(answer, arrival.at_s);
      if (observer.answered) observer.answered(judged);
    });
  return run;
}

std::map<std::string, double> values_of(const IntegrityRun& run) {
  std::map<std::string, double> values{{"answers", run.answers}, {"is_right", run.is_right ? 1 : 0}};
  for_each_value(run, [&](const char* name, const std::optional<double>& value) {
    if (value) values[name] = *value;
  });
  return values;
}

IntegrityRun integrity_run_from(const std::map<std::string, double>& values) {
  IntegrityRun run;
  run.answers = static_cast<int>(values.at("answers"));
  run.is_right = values.at("is_right") != 0;
  for_each_value(run, [&](const char* name, auto& value) {
    if (const auto found = values.find(name); found != values.end()) value = found->second;
  });
  return run;
}

}  // namespace opal::experiments
