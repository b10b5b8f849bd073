#include "digested_drives.hpp"

#include "simulated_world.hpp"

#include "tests/system/replay/event_recorder.hpp"
#include "tests/system/replay/recorded_site.hpp"

#include "common/json/event_json.hpp"
#include "live/live_core.hpp"
#include "map_tools/map_stack.hpp"
#include "tests/kit/shipped_plugins.hpp"

using namespace opal;
using namespace opal::simulation;
using nlohmann::ordered_json;

namespace {

ordered_json as_json(const PoseEstimate& estimate) {
  const Eigen::Matrix3d& covariance = estimate.covariance;
  ordered_json json{{"stamp_s", estimate.stamp_s},
                    {"status", name_of(estimate.status)},
                    {"T_map_base", pose_json(estimate.T_map_base)},
                    {"covariance", std::vector<double>(covariance.data(), covariance.data() + covariance.size())},
                    {"probability", estimate.probability},
                    {"none", estimate.none},
                    {"hypotheses", estimate.hypotheses},
                    {"best", estimate.best},
                    {"storey", estimate.place.storey},
                    {"T_storey_base", pose_json(estimate.place.T_storey_base)},
                    {"alternatives", ordered_json::array()}};
  for (const PoseEstimate::Alternative& other : estimate.alternatives)
    json["alternatives"].push_back({{"hypothesis", other.hypothesis},
                                    {"T_map_base", pose_json(other.T_map_base)},
                                    {"probability", other.probability}});
  return json;
}

/// All events but what the updates cost.
void take_events(RunDigest& digest, const EventRecorder& recorder) {
  for (ordered_json event : recorder.events) {
    const std::string kind = event["event"];
    event.erase("event");
    if (kind != "cost") digest.take(kind, event);
  }
}

/// By which a drive that is another one is told from answers that are.
void take_input(RunDigest& digest, const Arrivals& arrivals) {
  for (const Arrival& arrival : arrivals) {
    if (const auto* odometry = std::get_if<OdometryRecord>(&arrival.record))
      digest.take("input.odometry", pose_json(odometry->T_odom_base));
    if (const auto* scan = std::get_if<RawScan>(&arrival.record)) digest.take("input.ranges_m", scan->ranges_m);
  }
}

struct Listened {
  RunDigest digest;

  void hear(const LiveAnswer& answer) {
    digest.take("answer", as_json(answer.estimate));
    digest.take("answer.T_map_odom", pose_json(answer.T_map_odom));
    digest.take("answer.why", answer.why);
    digest.take("answer.latency_s", answer.latency_s);
    digest.take("answer.waited_s", answer.waited_s);
    for (const HealthFinding& finding : answer.health)
      digest.take("answer.health", {static_cast<int>(finding.level), finding.subject, finding.words});
  }
};

RunDigest played(LocalizerParts parts, const Arrivals& arrivals) {
  EventRecorder recorder;
  LiveCore core(std::move(parts), {}, &recorder);
  Listened all;
  const auto listen = [&](const LiveAnswer& answer) { all.hear(answer); };
  for (const Arrival& arrival : arrivals) core.take(arrival.record, arrival.at_s, arrival.at_s, listen);
  core.finish(listen);
  take_input(all.digest, arrivals);
  for (const auto& [cause, times] : core.counts()) all.digest.take("counts." + cause, times);
  take_events(all.digest, recorder);
  return all.digest;
}

RunDigest with_faults(const World& world, double duration_s, const Faults& faults) {
  return played(world.parts(), arrivals_with(world, duration_s, faults));
}

/// Sample after sample. @param is_told  the robot is given a hint, reduced to its pattern and reset on the way.
RunDigest updated(LocalizerParts parts, const std::vector<Sample>& samples, bool is_told) {
  EventRecorder recorder;
  Localizer localizer(std::move(parts), &recorder);
  RunDigest digest;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (is_told && k == 3) localizer.hint({Pose2(4.2, -10.5, -0.3), 0.4, 0.1});
    if (is_told && k == 12) localizer.keep_pattern();
    if (is_told && k == 20) localizer.reset();
    localizer.update(samples[k]);
    digest.take("answer", as_json(localizer.estimate_at(samples[k].stamp_s, samples[k].T_odom_base)));
    digest.take("answer.match", pose_json(localizer.local_map().T_local_base()));
    const Eigen::Matrix3d& covariance = localizer.local_map().last_match().covariance;
    digest.take("answer.match.covariance", std::vector<double>(covariance.data(), covariance.data() + 9));
  }
  for (const SensorFinding& finding : localizer.sensor_findings())
    digest.take("finding." + std::to_string(static_cast<int>(finding.subject)), {finding.found, finding.sigma});
  take_events(digest, recorder);
  return digest;
}

// ------------------------------------------------------------------------------------------------ the drives

RunDigest recorded_hall() {
  const RecordedSite site("malaga-demo");
  return updated(site.parts(), site.samples, false);
}

/// As in Hendrikx (2023), more or less: branches, poses by associations, patterns of stable features.
RunDigest recorded_hall_with_branches() {
  const RecordedSite site("malaga-demo");
  LocalizerParts parts = site.parts();
  parts.stages.growth.max_branches = 2;
  parts.stages.growth.branch_not_on_map = true;
  parts.stages.growth.register_by_associations = true;
  parts.stages.growth.similar_depth = 4;
  parts.stages.growth.max_consecutive_not_on_map = 5;
  parts.stages.hypotheses.max_hypotheses = 40;
  parts.stages.search.region = RegionPrior{{6, -10}, 12};
  return updated(std::move(parts), site.samples, true);
}

RunDigest kidnapped_in_an_office() {
  const World world = world_of({"office", 2, 400, 0.6});
  Simulation simulation(world.map, world.options, 5);
  DriveOptions drive;
  drive.drives = 2;
  drive.distance_m = 6;
  drive.scan_every_s = 0.1;
  drive.pause_s = 1;
  return played(world.parts(), arrivals_in(record(simulation, drive, Random(4))));
}

RunDigest careful_hall_where_wheels_slip() {
  return with_faults(world_of({"hall", 7, 500, 0.9}, "careful_two_lasers.jsonld"), 15, {{Fault::wheels_slip, {7, 12}}});
}

RunDigest warehouse_where_odometry_freezes() {
  return with_faults(world_of({"warehouse", 5, 500, 0.5}), 16, {{Fault::odometry_frozen, {7, 13}}});
}

RunDigest corridor_with_poor_records() {
  return with_faults(world_of({"corridor", 5, 300, 0.5}), 20,
                     {{Fault::dropped, {4, 6}},
                      {Fault::doubled, {6, 8}},
                      {Fault::reordered, {8, 10}},
                      {Fault::late, {10, 12}},
                      {Fault::laser_gone, {12, 15}},
                      {Fault::clock_back, {15, 16}}});
}

RunDigest other_buildings_map() {
  const World world = world_of({"office", 6, 400, 0.5});
  const Arrivals arrivals = arrivals_in(driven(world, 15, 6));
  return played(world_of({"office", 7, 400, 0.5}).parts(), arrivals);
}

/// The lasers are described with front and rear exchanged.
RunDigest wrongly_described_lasers() {
  const World world = world_of({"hall", 8, 400, 0.3});
  Deployment described = world.deployment();
  std::swap(described.lasers[0].T_base_laser, described.lasers[1].T_base_laser);
  return played(build_parts(described, shipped_plugins(), world.map), arrivals_in(driven(world, 20, 8)));
}

std::shared_ptr<const SemanticMap> with_lift(const SemanticMap& map, const MapConnection& lift) {
  MapOrigin origin = map.origin();
  origin.connections = {lift};
  return SemanticMap::make(map.name(), map.objects(), map.features(), map.patterns(), origin);
}

/// Drives for 6 s on a storey, stands for 6 s, of which it is on another storey for 3 s, and drives on there.
/// @param T_storey_lift  becomes where it stood.
std::vector<Sample> ridden(const World& world, const Pose2& T_storey_start, Pose2& T_storey_lift) {
  constexpr int kStands = 30, kIsAbove = 45, kGoesOn = 60, kEnds = 100;
  const auto& storeys = world.map->origin().storeys;
  const LaserModel& laser = world.options.laser;
  Simulation robot(world.map, world.options, 3);
  robot.place(storeys[0].to_map(T_storey_start));
  std::vector<Sample> samples;
  for (int step = 0; step < kEnds; ++step) {
    const bool drives = step < kStands || step >= kGoesOn;
    if (step == kStands) T_storey_lift = storeys[0].to_storey(robot.T_map_base());
    if (step == kIsAbove) robot.place(storeys[1].to_map(T_storey_lift));
    robot.drive({{drives ? 0.5 : 0, 0}, drives ? 0.4 * std::sin(step / 10.0) : 0}, 0.2);
    samples.push_back(sample_of(make_scan(robot.scan(), laser), robot.T_odom_base(), laser.T_base_laser));
  }
  return samples;
}

RunDigest ride_between_storeys() {
  const auto low = generate_building({"office", 2, 300, 0.5}).map, top = generate_building({"office", 7, 300, 0.5}).map;
  const std::vector<StoreyPart> parts{{"low", "", {}, low}, {"top", "", {}, top}};
  World world{stacked_map("house", parts).map, "default.jsonld", {}};
  Random random(9);
  const Pose2 T_storey_start(Simulation(low, world.options, 3).floor().anywhere(random), 0.3);
  Pose2 T_storey_lift;
  const std::vector<Sample> samples = ridden(world, T_storey_start, T_storey_lift);
  world.map = with_lift(*world.map, {"lift", "opal:Lift", "", 1, {{"low", T_storey_lift}, {"top", T_storey_lift}}});
  return updated(world.parts(), samples, false);
}

}  // namespace

const std::vector<DigestedDrive>& digested_drives() {
  static const std::vector<DigestedDrive> all{{"recorded", recorded_hall},
                                              {"branching", recorded_hall_with_branches},
                                              {"kidnapped", kidnapped_in_an_office},
                                              {"slipping", careful_hall_where_wheels_slip},
                                              {"frozen", warehouse_where_odometry_freezes},
                                              {"poor_records", corridor_with_poor_records},
                                              {"other_map", other_buildings_map},
                                              {"exchanged_lasers", wrongly_described_lasers},
                                              {"ride", ride_between_storeys},
                                              {"samples", samples_of_poor_records},
                                              {"other_lasers", samples_of_other_lasers},
                                              {"features", features_of_scans},
                                              {"local_map", local_map_of_a_drive},
                                              {"sensor_findings", sensor_findings}};
  return all;
}
