#include "golden_file.hpp"
#include "recorded_site.hpp"

#include <catch2/catch.hpp>

using namespace opal;

namespace {

nlohmann::ordered_json measure(const std::string& site_name) {
  const RecordedSite site(site_name);
  Localizer localizer(site.parts());
  nlohmann::ordered_json found;
  found["map_features"] = site.map->features().size();
  int keyframes = 0, localized = 0;
  double hypotheses = 0;
  auto poses = nlohmann::ordered_json::array();
  for (const ReplayedScan& scan : replay(localizer, site.samples)) {
    localized += scan.estimate.status == Status::localized;
    if (!scan.keyframe) continue;
    ++keyframes;
    hypotheses += scan.estimate.hypotheses;
    const Pose2& pose = scan.estimate.T_map_base;
    poses.push_back({scan.stamp_s, pose.x(), pose.y(), pose.heading_rad()});
  }
  int stable = 0;
  for (const LocalFeature& feature : localizer.local_map().features()) stable += feature.stable;
  found["scans"] = site.samples.size();
  found["keyframes"] = keyframes;
  found["stable_local_features_at_end"] = stable;
  found["mean_hypotheses"] = hypotheses / std::max(1, keyframes);
  found["scans_localized"] = localized;
  found["poses"] = poses;
  return found;
}

/// Stage by stage, in pipeline order, so that the first complaint names the stage that moved.
void compare(const nlohmann::ordered_json& found, const nlohmann::ordered_json& golden) {
  for (const char* stage : {"map_features", "scans", "keyframes", "stable_local_features_at_end", "scans_localized"}) {
    INFO("stage: " << stage);
    const double expected = golden.at(stage);
    CHECK(found.at(stage).get<double>() == Approx(expected).epsilon(0.05).margin(1));
  }
  INFO("stage: mean_hypotheses");
  CHECK(found["mean_hypotheses"].get<double>() == Approx(golden["mean_hypotheses"].get<double>()).epsilon(0.25));
  REQUIRE(found["poses"].size() == golden["poses"].size());
  for (std::size_t k = 0; k < golden["poses"].size(); ++k) {
    const auto &a = found["poses"][k], &b = golden["poses"][k];
    INFO("keyframe " << k << " at " << b[0] << " s: found " << a << ", golden " << b);
    CHECK(std::hypot(a[1].get<double>() - b[1].get<double>(), a[2].get<double>() - b[2].get<double>()) < 0.05);
    CHECK(std::abs(wrap_angle(a[3].get<double>() - b[3].get<double>())) < 0.02);
  }
}

}  // namespace

TEST_CASE("a recorded log still gives the answers of the golden file") {
  const std::string site = GENERATE(as<std::string>(), "malaga-demo", "malaga");
  CAPTURE(site);
  const nlohmann::ordered_json found = measure(site);
  compare(found, golden_file(site + "/golden.json", found.dump(1) + '\n'));
}

TEST_CASE("the answers of the golden replays are right") {
  const std::string name = GENERATE(as<std::string>(), "malaga-demo", "malaga");
  CAPTURE(name);
  const RecordedSite site(name);
  Localizer localizer(site.parts());
  int checked = 0;
  for (const ReplayedScan& scan : replay(localizer, site.samples)) {
    if (scan.estimate.status != Status::localized) continue;
    const auto truth = site.truth.T_map_laser_at(scan.stamp_s);
    if (!truth) continue;
    CAPTURE(scan.stamp_s);
    CHECK(distance_m(*truth, scan.estimate.T_map_base * site.laser.T_base_laser) < 0.3);
    ++checked;
  }
  CHECK(checked > 10);
}
