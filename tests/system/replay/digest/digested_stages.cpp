#include "digested_drives.hpp"

#include "simulated_world.hpp"

#include "common/json/event_json.hpp"
#include "sensor_health/sensor_monitors.hpp"

#include <opal/local_map/local_map.hpp>
#include <opal/sensing/scan_pairing.hpp>

#include <algorithm>
#include <functional>

using namespace opal;
using namespace opal::simulation;
using nlohmann::ordered_json;

namespace {

/// Arithmetic without a search or an optimization: hardly anything is rounded otherwise.
constexpr double kHardly = 1e-9;

World corridor() { return world_of({"corridor", 5, 300, 0.5}); }

std::vector<Sample> paired(const std::vector<LaserModel>& lasers, const Arrivals& arrivals,
                           std::map<std::string, int>& counts) {
  ScanPairing pairing(lasers);
  std::vector<Sample> samples;
  const auto take_all = [&] {
    while (auto sample = pairing.next()) samples.push_back(std::move(*sample));
  };
  for (const Arrival& arrival : arrivals) {
    pairing.take(arrival.record);
    take_all();
  }
  pairing.finish();
  take_all();
  counts = pairing.counts();
  return samples;
}

std::vector<Sample> paired(const World& world, const Arrivals& arrivals, std::map<std::string, int>& counts) {
  return paired(world.deployment().lasers, arrivals, counts);
}

ordered_json as_json(const Feature& feature) {
  ordered_json json{{"type", feature.type}, {"support_m", feature.support_m}, {"true_end", feature.true_end}};
  add_geometry(json, feature.geometry);
  for (const double entry : feature.covariance.reshaped()) json["covariance"].push_back(entry);
  return json;
}

ordered_json as_json(const LaserView& view) {
  ordered_json json{{"laser", view.laser},
                    {"stamp_s", view.scan.stamp_s},
                    {"range_max_m", view.scan.range_max_m},
                    {"invalid", view.scan.invalid},
                    {"free_bearings_rad", view.scan.free_bearings_rad},
                    {"T_base_laser", pose_json(view.T_base_laser)},
                    {"points", ordered_json::array()}};
  for (const ScanPoint& point : view.scan.points)
    json["points"].push_back({point.position.x(), point.position.y(), point.range_m, point.bearing_rad, point.beam});
  return json;
}

void take_samples(RunDigest& digest, const std::string& prefix, const std::vector<LaserModel>& lasers,
                  const Arrivals& arrivals) {
  std::map<std::string, int> counts;
  for (const Sample& sample : paired(lasers, arrivals, counts)) {
    digest.take(prefix + "stamp_s", sample.stamp_s);
    digest.take(prefix + "T_odom_base", pose_json(sample.T_odom_base));
    digest.take(prefix + "T_odom_recorded", pose_json(sample.T_odom_recorded));
    digest.take(prefix + "views", static_cast<int>(sample.views.size()));
    for (const LaserView& view : sample.views) digest.take(prefix + "view", as_json(view));
  }
  digest.take(prefix + "counts", counts);
}

/// Lasers that are described in another way, and what they say then.
struct Variant {
  std::string name;
  std::function<void(LaserModel&)> describe;
  std::function<bool(LogRecord&)> keeps;  ///< a record, which it may change
};

/// Changes scans, and keeps all.
std::function<bool(LogRecord&)> scans(const std::function<void(RawScan&)>& change) {
  return [change](LogRecord& record) {
    if (auto* scan = std::get_if<RawScan>(&record)) change(*scan);
    return true;
  };
}

/// Changes odometry. @param change  gives whether it stays.
std::function<bool(LogRecord&)> odometry(const std::function<bool(OdometryRecord&)>& change) {
  return [change](LogRecord& record) {
    auto* odometry = std::get_if<OdometryRecord>(&record);
    return odometry == nullptr || change(*odometry);
  };
}

void turn_clockwise(RawScan& scan) {
  std::ranges::reverse(scan.ranges_m);
  scan.angle_min_rad = 1.658063;
  scan.angle_increment_rad = -0.0087266;
  scan.time_increment_s = 2e-4;
}

void state_beam_times(RawScan& scan) {
  for (std::size_t k = 0; k < scan.ranges_m.size(); ++k)
    scan.beam_times_s.push_back(static_cast<float>(k % 2 == 0 ? 1e-4 * static_cast<double>(k) : 0.02));
}

std::vector<Variant> variants() {
  const auto as_it_is = [](LaserModel&) {};
  const auto by_log = [](LaserModel& laser) {
    laser.sweep_s.reset();
    laser.geometry_from_log = true;
  };
  const auto all_around = [](LaserModel& laser) {
    laser.angle_min_rad = -1;
    laser.angle_increment_rad = 2 * std::numbers::pi / 381;
    laser.range_max_m = 6;
  };
  const auto jumps = [](OdometryRecord& record) {
    if (record.stamp_s > 1.5) record.T_odom_base = Pose2(40, -7, 2) * record.T_odom_base;
    return true;
  };
  const auto is_rare = [](const OdometryRecord& record) { return std::fmod(record.stamp_s, 0.4) < 0.02; };
  return {{"clockwise", by_log, scans(turn_clockwise)},
          {"beam_times", by_log, scans(state_beam_times)},
          {"too_long_sweep", by_log, scans([](RawScan& scan) { scan.time_increment_s = 0.01; })},
          {"all_around", all_around, scans([](RawScan&) {})},
          {"odometry_with_scans", as_it_is, odometry([](const OdometryRecord&) { return false; })},
          {"rare_odometry", as_it_is, odometry(is_rare)},
          {"odometry_jumps", as_it_is, odometry(jumps)}};
}

std::vector<Feature> detected(const LocalizerParts& parts, const Sample& sample) {
  std::vector<Feature> features;
  for (const LaserView& view : sample.views)
    for (const auto& detector : parts.detectors)
      for (const Feature& feature : detector.part->detect(view.scan))
        features.push_back(transformed(view.T_base_laser, feature));
  return features;
}

}  // namespace

RunDigest samples_of_poor_records() {
  const World world = corridor();
  const Arrivals arrivals = arrivals_with(world, 7,
                                          {{Fault::dropped, {1, 2}},
                                           {Fault::doubled, {2, 3}},
                                           {Fault::reordered, {3, 4}},
                                           {Fault::laser_gone, {4, 5}},
                                           {Fault::clock_back, {6, 7}}});
  RunDigest digest(kHardly);
  take_samples(digest, "", world.deployment().lasers, arrivals);
  return digest;
}

RunDigest samples_of_other_lasers() {
  const World world = corridor();
  const Arrivals arrivals = arrivals_with(world, 3, {});
  RunDigest digest(kHardly);
  for (const Variant& variant : variants()) {
    std::vector<LaserModel> lasers = world.deployment().lasers;
    for (LaserModel& laser : lasers) variant.describe(laser);
    Arrivals changed = arrivals;
    std::erase_if(changed, [&](Arrival& arrival) { return !variant.keeps(arrival.record); });
    take_samples(digest, variant.name + ".", lasers, changed);
  }
  return digest;
}

RunDigest features_of_scans() {
  const World world = world_of({"office", 2, 400, 0.6});
  const LocalizerParts parts = world.parts();
  std::map<std::string, int> counts;
  RunDigest digest(1e-6);
  for (const Sample& sample : paired(world, arrivals_with(world, 8, {}), counts)) {
    const std::vector<Feature> features = detected(parts, sample);
    digest.take("features", static_cast<int>(features.size()));
    for (const Feature& feature : features) digest.take("feature", as_json(feature));
  }
  return digest;
}

RunDigest local_map_of_a_drive() {
  const World world = world_of({"office", 2, 400, 0.6});
  const LocalizerParts parts = world.parts();
  std::map<std::string, int> counts;
  LocalMap map(parts.local_map, parts.matcher);
  RunDigest digest;
  int number = 0;
  for (const Sample& sample : paired(world, arrivals_with(world, 14, {}), counts)) {
    if (number++ % 3 != 0) continue;
    map.add(sample, detected(parts, sample));
    digest.take("T_local_base", pose_json(map.T_local_base()));
    for (const double entry : map.last_match().covariance.reshaped()) digest.take("match.covariance", entry);
    digest.take("keyframes", static_cast<int>(map.keyframes().size()));
    digest.take("oldest", {{"id", map.keyframes().front().id}, {"driven_m", map.keyframes().front().driven_m}});
    for (const LocalFeatureId id : map.last_associations()) digest.take("association", id);
    for (const LocalFeature& local : map.features()) {
      digest.take("local.id", local.id);
      digest.take("local.feature", as_json(local.feature));
      digest.take("local.measurements", static_cast<int>(local.measurements.size()));
      digest.take("local.poses", local.distinct_poses);
      digest.take("local.stable", local.stable);
      digest.take("local.last", local.last_keyframe);
    }
  }
  return digest;
}

/// Lasers and wheels as they are described, then with one thing wrong after the other.
RunDigest sensor_findings() {
  const World world = world_of({"hall", 8, 400, 0.3});
  std::map<std::string, int> counts;
  const std::vector<Sample> samples =
      paired(world, arrivals_with(world, 16, {{Fault::odometry_frozen, {10, 13}}}), counts);
  std::vector<LaserModel> described = world.deployment().lasers;
  RunDigest digest(1e-3);  // of hundreds of scan matches one ends elsewhere on other processors
  for (const char* wrong : {"nothing", "turned", "moved"}) {
    if (wrong == std::string("turned")) described[0].T_base_laser = Pose2(0.3, 0, 0.2);
    if (wrong == std::string("moved")) described[1].T_base_laser = Pose2(0.1, 0.3, 3.1);
    SensorMonitors monitors(described, world.parts().matcher);
    for (const Sample& sample : samples) {
      if (!monitors.add(sample)) continue;
      const std::string field = std::string(wrong) + ".finding";
      for (const SensorFinding& finding : monitors.findings())
        digest.take(field + std::to_string(static_cast<int>(finding.subject)),
                    {static_cast<int>(finding.verdict), finding.found, finding.described, finding.sigma});
      digest.take(field + ".contradiction", monitors.contradiction());
      digest.take(field + ".frozen", monitors.is_odometry_frozen());
    }
  }
  return digest;
}
