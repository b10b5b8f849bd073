#include "recorded_site.hpp"

#include <opal/localization/events/event_stream.hpp>
#include "map_tools/test_maps/map_damage.hpp"

#include <catch2/catch.hpp>

using namespace opal;

namespace {

/// Counts what became of places that a search proposed, from the eleventh update on.
class SearchCounter final : public EventSink {
 public:
  bool listening() const override { return true; }
  void write(const nlohmann::ordered_json& event) override {
    if (event["keyframe"] <= 10) return;
    if (event["event"] == "spawned") ++spawned;
    if (event["event"] != "searched") return;
    for (const auto& rejected : event["rejected"])
      contradicted += rejected["reason"].get<std::string>().find("earlier scan") != std::string::npos;
  }
  int spawned = 0, contradicted = 0;
};

struct Outcome {
  SearchCounter counts;
  double error_m = 0;
  bool localized = false;
};

Outcome outcome_of(const RecordedSite& site, LocalizerParts parts) {
  Outcome outcome;
  Localizer localizer(std::move(parts), &outcome.counts);
  const auto scans = replay(localizer, site.samples);
  const auto truth = site.truth.T_map_laser_at(scans.back().stamp_s);
  REQUIRE(truth);
  outcome.error_m = distance_m(*truth, scans.back().estimate.T_map_base * site.laser.T_base_laser);
  outcome.localized = scans.back().estimate.status == Status::localized;
  return outcome;
}

/// The map with walls across the way that the robot looks and drives through: glass that was mapped as solid.
std::shared_ptr<const SemanticMap> with_glass(const RecordedSite& site, int panes) {
  std::vector<MapObject> objects = site.map->objects();
  std::vector<MapFeature> features = site.map->features();
  const auto& poses = site.truth.poses();
  for (int k = 0; k < panes; ++k) {
    const Pose2& T_map_laser = poses[(2 * k + 1) * poses.size() / (2 * panes)].pose;
    const Pose2 ahead = T_map_laser * Pose2(2.5, 0, 0);
    MapFeature pane = features.front();
    pane.id = "glass-" + std::to_string(k) + "/face";
    pane.object = MapObjectNumber(objects.size());
    pane.type = "opal:Wall";
    pane.geometry = Segment{ahead * Point(0, -1.5), ahead * Point(0, 1.5)};
    pane.points.clear();
    pane.representation.clear();
    objects.push_back({"glass-" + std::to_string(k), "opal:Wall"});
    features.push_back(std::move(pane));
  }
  return SemanticMap::make("with glass", std::move(objects), std::move(features));
}

/// Keeps when the pose was called localized first, and in which words the status was told otherwise.
class StatusReader final : public EventSink {
 public:
  bool listening() const override { return true; }
  void write(const nlohmann::ordered_json& event) override {
    if (event["event"] != "estimate") return;
    if (event["status"] == "localized" && !first_localized) first_localized = event["keyframe"].get<int>();
    const bool said =
        event["why"].get<std::string>().find("straight walls that were seen are not on the map") != std::string::npos;
    told += said && event["status"] != "localized";
  }
  std::optional<int> first_localized;
  int told = 0;
};

StatusReader read_status(const RecordedSite& site, std::shared_ptr<const SemanticMap> map, double weight_per_m,
                         double most_weight = 20) {
  LocalizerParts parts = site.parts(std::move(map));
  parts.stages.status.localized_weight_per_m = weight_per_m;
  parts.stages.status.localized_most_weight = most_weight;
  StatusReader reader;
  Localizer localizer(std::move(parts), &reader);
  replay(localizer, site.samples);
  return reader;
}

}  // namespace

TEST_CASE("a robot among walls that its map lacks waits longer until it calls its pose localized") {
  const RecordedSite site("malaga");
  MapDamage damage;
  damage.plan_m = 1.5;
  damage.drop = 0.3;
  const auto lacking = damaged_map(*site.map, damage);
  const StatusReader soon = read_status(site, lacking, 0), late = read_status(site, lacking, 1);
  REQUIRE(soon.first_localized);
  CHECK(soon.told == 0);
  CHECK(late.told > 0);
  CHECK((!late.first_localized || *late.first_localized > *soon.first_localized + 5));
  const StatusReader bounded = read_status(site, lacking, 100, 4);
  REQUIRE(bounded.first_localized);
  CHECK(*bounded.first_localized > *soon.first_localized);
  CHECK((!late.first_localized || *bounded.first_localized <= *late.first_localized));
}

TEST_CASE("a robot whose map holds the walls around it does not wait") {
  const RecordedSite site("malaga-demo");
  const StatusReader soon = read_status(site, site.map, 0), late = read_status(site, site.map, 1);
  REQUIRE(soon.first_localized);
  CHECK(late.first_localized == soon.first_localized);
  CHECK(late.told == 0);
}

TEST_CASE("late candidates that earlier scans contradict are rejected, and the answer stays") {
  const RecordedSite site("malaga");
  LocalizerParts blind = site.parts();
  blind.stages.verification.scans = 0;
  const Outcome with = outcome_of(site, site.parts()), without = outcome_of(site, blind);
  CHECK(without.counts.contradicted == 0);
  CHECK(with.counts.contradicted > 5);
  CHECK(with.counts.spawned < without.counts.spawned);
  CHECK(with.error_m < 0.3);
  CHECK(without.error_m < 0.3);
}

TEST_CASE("who is spawned late beside the right place does not overtake it by what it is told of the scans before") {
  const RecordedSite site("malaga", RecordedSite::Extent::whole_log);
  Localizer localizer(site.parts());
  int checked = 0;
  for (const ReplayedScan& scan : replay(localizer, site.samples)) {
    const auto truth = site.truth.T_map_laser_at(scan.stamp_s);
    if (!truth) continue;
    INFO(scan.stamp_s << " s, " << checked << " scans with recorded truth before");
    CHECK(distance_m(*truth, scan.estimate.T_map_base * site.laser.T_base_laser) < 0.3);
    ++checked;
  }
  CHECK(checked > 200);
}

TEST_CASE("glass that the map holds for solid walls does not mislead") {
  const RecordedSite site("malaga");
  const Outcome outcome = outcome_of(site, site.parts(with_glass(site, 12)));
  CHECK(outcome.localized);
  CHECK(outcome.error_m < 0.3);
}
