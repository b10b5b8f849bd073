#include "benchmark/experiments/faults/fault_run.hpp"

#include "evaluation/pose_tolerance.hpp"
#include "live/live_core.hpp"
#include "simulation/buildings/building.hpp"
#include "simulation/drives/recording.hpp"

#include <algorithm>
#include <array>

namespace opal::experiments {
namespace {

using simulation::Arrival;
using simulation::Fault;

constexpr std::array kKinds{"office", "hall", "corridor", "warehouse"};
constexpr double kSize_m2 = 800, kScanEvery_s = 0.1;

std::shared_ptr<const SemanticMap> building_of(std::uint64_t seed, const std::string& kind) {
  return simulation::generate_building({kind, seed, kSize_m2, 0.2}).map;
}

simulation::Recording recorded(const Deployment& deployment, std::shared_ptr<const SemanticMap> building,
                               std::uint64_t seed, const FaultDriveOptions& options) {
  simulation::SimulationOptions world;
  world.take(deployment.lasers);
  world.people = options.people;
  simulation::Simulation simulation(std::move(building), world, seed);
  simulation::DriveOptions drive;
  drive.scan_every_s = kScanEvery_s;
  return simulation::record_about(simulation, options.duration_s, drive, Random(seed));
}

Deployment as_described(Deployment deployment, const Trouble& trouble) {
  if (trouble.is_laser_turned)
    for (LaserModel& laser : deployment.lasers) laser.T_base_laser = laser.T_base_laser * Pose2(0, 0, std::numbers::pi);
  return deployment;
}

/// Watches the answers of one drive.
class Watch {
 public:
  Watch(const simulation::Recording& recording, const Trouble& trouble, const FaultDriveOptions& options, FaultRun& run)
      : recording_(recording), trouble_(trouble), options_(options), run_(run) {}

  void see(const LiveAnswer& answer, double now_s) {
    ++run_.answers;
    run_.worst_latency_s = std::max(run_.worst_latency_s, answer.latency_s);
    const double end_s = options_.fault_from_s + trouble_.duration_s;
    const double true_s =
        simulation::true_stamp_s(trouble_.fault, {options_.fault_from_s, end_s}, answer.stamp_s, now_s);
    const bool says_localized = answer.estimate.status == Status::localized;
    const bool is_right = says_localized && !trouble_.is_other_map && is_near(answer.estimate, true_s);
    run_.localized.add(true_s, says_localized, is_right);
    if (now_s < options_.fault_from_s) run_.localized_before = is_right;
    if (now_s >= end_s && is_right && !run_.recovered_after_s) run_.recovered_after_s = now_s - end_s;
  }
  void hear(const std::vector<HealthFinding>& health) {
    for (const HealthFinding& finding : health)
      if (!trouble_.named.empty() && finding.words.find(trouble_.named) != std::string::npos) run_.is_named = true;
  }

 private:
  bool is_near(const PoseEstimate& estimate, double stamp_s) const {
    return kRightPose.holds(estimate.T_map_base, simulation::truth_at(recording_, stamp_s));
  }

  const simulation::Recording& recording_;
  const Trouble& trouble_;
  const FaultDriveOptions& options_;
  FaultRun& run_;
};

void play(const std::vector<Arrival>& arrivals, LiveCore& core, Watch& watch) {
  for (const Arrival& arrival : arrivals) {
    core.take(arrival.record, arrival.at_s, arrival.at_s,
              [&](const LiveAnswer& answer) { watch.see(answer, arrival.at_s); });
    watch.hear(core.health(arrival.at_s));
  }
}

}  // namespace

const std::vector<Trouble>& all_troubles() {
  static const std::vector<Trouble> troubles{
      {"none", Fault::none, false, false, 0, ""},
      {"dropped", Fault::dropped, false, false, 10, "a second"},
      {"doubled", Fault::doubled, false, false, 10, "doubled"},
      {"reordered", Fault::reordered, false, false, 10, "order"},
      {"late by 0.5 s", Fault::late, false, false, 10, "after its stamps"},
      {"clock back by 10 s", Fault::clock_back, false, false, 0, "clock reset"},
      {"laser gone for 20 s", Fault::laser_gone, false, false, 20, "no scan for"},
      {"odometry frozen", Fault::odometry_frozen, false, false, 10, "odometry"},
      {"wheels slip", Fault::wheels_slip, false, false, 10, "odometry"},
      {"laser mounted 180 degrees wrong", Fault::none, true, false, 0, "laser"},
      {"another building's map", Fault::none, false, true, 0, "the map"}};
  return troubles;
}

FaultRun run_drive(const Deployment& deployment, const PluginRegistry& registry, const Trouble& trouble,
                   std::uint64_t seed, const FaultDriveOptions& options) {
  FaultRun run{trouble.name, seed, kKinds[seed % kKinds.size()]};
  const auto building = building_of(seed, run.building);
  const simulation::Recording recording = recorded(deployment, building, seed, options);
  const auto map = trouble.is_other_map ? building_of(seed + 1'000'003, run.building) : building;
  LiveCore core(build_parts(as_described(deployment, trouble), registry, map), {}, nullptr);
  const double sweep_s = deployment.lasers.front().sweep_s.value_or(0);
  const std::vector<Arrival> arrivals =
      simulation::with_fault(simulation::arrivals_of(records_of(recording), sweep_s), trouble.fault,
                             {options.fault_from_s, options.fault_from_s + trouble.duration_s},
                             deployment.lasers.back().frame, Random(seed + 7));
  Watch watch(recording, trouble, options, run);
  play(arrivals, core, watch);
  return run;
}

}  // namespace opal::experiments
