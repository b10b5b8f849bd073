#include "benchmark/experiments/storeys/storey_run.hpp"

#include "benchmark/experiments/kit/recorded_way.hpp"
#include "benchmark/experiments/storeys/storey_difference.hpp"
#include "evaluation/pose_tolerance.hpp"
#include "live/live_core.hpp"
#include "map_tools/map_stack.hpp"
#include "simulation/drives/faults.hpp"

namespace opal::experiments {
namespace {

/// Watches the answers of one drive.
class StoreyWatch {
 public:
  StoreyWatch(const SemanticMap& map, const RecordedWay& way, std::optional<double> after_s, StoreyRun& run)
      : map_(map), way_(way), after_s_(after_s), run_(run) {}

  void see(const LiveAnswer& answer) {
    const PoseEstimate& said = answer.estimate;
    const Pose2& truth = way_.truth(answer.stamp_s);
    const double driven_m = way_.driven_m(answer.stamp_s);
    const bool is_near = said.has_pose && kRightPose.holds(said.T_map_base, truth);
    const bool is_localized = said.status == Status::localized;
    ++run_.answers;
    run_.is_storey = said.has_pose && said.place.storey == place_in_building(map_, truth).storey;
    run_.is_right = is_near && is_localized;
    if (is_localized && !is_near) {
      if (run_.wrong == 0) run_.wrong_at_m = driven_m;
      ++run_.wrong;
      run_.wrong_storey += !run_.is_storey;
    }
    if (after_s_ && answer.stamp_s <= *after_s_) return;
    if (!is_near)
      run_.right_from_m.reset();
    else if (!run_.right_from_m)
      run_.right_from_m = driven_m;
    if (run_.is_right && !run_.localized_from_m) run_.localized_from_m = driven_m;
  }

 private:
  const SemanticMap& map_;
  const RecordedWay& way_;
  std::optional<double> after_s_;
  StoreyRun& run_;
};

void play(const LocalizerParts& parts, const simulation::Recording& recording,
          const std::function<void(const LiveAnswer&)>& see) {
  LiveCore core(parts, {}, nullptr);
  const double sweep_s = recording.laser.sweep_s.value_or(0);
  for (const simulation::Arrival& arrival : simulation::arrivals_of(records_of(recording), sweep_s))
    core.take(arrival.record, arrival.at_s, arrival.at_s, see);
}

/// @param after_s  what is driven until then does not count.
double difference(const LocalizerParts& parts, const simulation::Recording& recording, std::optional<double> after_s) {
  std::vector<Pose2> poses;
  for (const simulation::RecordedScan& scan : recording.scans)
    if (!after_s || scan.scan.stamp_s > *after_s) poses.push_back(scan.T_map_base);
  return storey_difference(*parts.map, poses, recording.laser);
}

}  // namespace

StoreyRun run_storey_drive(const StoreyWorld& world, const std::string& storey, const simulation::DriveOptions& drive,
                           std::uint64_t seed) {
  const SemanticMap& map = world.parts.map->map();
  simulation::Simulation simulation(storey_of_map(map, storey), world.world, seed);
  const simulation::Recording recording = record(simulation, drive, Random(seed).branch());
  if (world.keep) world.keep(recording, seed);
  StoreyRun run;
  run.seed = seed;
  run.from = run.to = storey;
  const RecordedWay way(recording);
  StoreyWatch watch(map, way, std::nullopt, run);
  play(world.parts, recording, [&](const LiveAnswer& answer) { watch.see(answer); });
  run.driven_m = way.all_m();
  run.difference = difference(world.parts, recording, std::nullopt);
  return run;
}

std::optional<StoreyRun> run_ride(const StoreyWorld& world, const MapConnection& lift, const std::string& from,
                                  const std::string& to, const simulation::RideDriveOptions& options,
                                  std::uint64_t seed) {
  const SemanticMap& map = world.parts.map->map();
  const auto made = simulation::record_ride(map, world.world, lift, from, to, options, seed);
  if (!made) return std::nullopt;
  if (world.keep) world.keep(made->recording, seed);
  StoreyRun run;
  run.is_ride = true;
  run.seed = seed;
  run.from = from;
  run.to = to;
  run.lift = lift.id;
  const RecordedWay way(made->recording, made->ride.leaves_s);
  StoreyWatch watch(map, way, made->ride.leaves_s, run);
  play(world.parts, made->recording, [&](const LiveAnswer& answer) {
    watch.see(answer);
    if (answer.stamp_s <= made->ride.stands_s) run.localized_before = run.is_right;
  });
  run.driven_m = way.all_m();
  run.difference = difference(world.parts, made->recording, made->ride.leaves_s);
  return run;
}

}  // namespace opal::experiments
