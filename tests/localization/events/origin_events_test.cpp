// What the event stream says of where places come from, in a house of two storeys.
#include "map_tools/map_stack.hpp"
#include "tests/localization/synthetic_scene.hpp"

#include <opal/localization/localizer.hpp>

#include <catch2/catch.hpp>

#include <set>

using namespace opal;
using namespace opal::synthetic;
using nlohmann::ordered_json;

namespace {

std::shared_ptr<const SemanticMap> map_of(const Features& features) {
  const std::shared_ptr<const MapView> view = view_of(features);
  return {view, &view->map()};
}

/// The rooms of both storeys are alike, but no corner of the upper one is on the map: patterns do not find it.
std::shared_ptr<const MapView> house() {
  Features upper = room();
  std::erase_if(upper, [](const Feature& feature) { return feature.type == "opal:Corner"; });
  const std::vector<StoreyPart> parts{{"a", "", {}, map_of(room())}, {"b", "", {}, map_of(upper)}};
  return std::make_shared<MapView>(stacked_map("house", parts).map, "lidar");
}

/// Keeps what is said of places that a search found.
struct Places : EventSink {
  std::vector<ordered_json> spawned, rejected;
  bool listening() const override { return true; }
  void write(const ordered_json& event) override {
    if (event["event"] == "spawned") spawned.push_back(event);
    if (event["event"] == "searched")
      rejected.insert(rejected.end(), event["rejected"].begin(), event["rejected"].end());
  }
  std::set<std::string> origins() const {
    std::set<std::string> all;
    for (const auto& places : {spawned, rejected})
      for (const ordered_json& place : places) all.insert(place.at("origin"));
    return all;
  }
};

/// Finds what is there.
struct RoomDetector : FeatureDetector {
  Features features;
  std::vector<Feature> detect(const Scan&) const override { return features; }
};

/// A robot on the first storey, that sees one scan.
Places seen_once(const std::optional<PoseHint>& hint, std::vector<Named<PatternTemplate>> templates) {
  const auto map = house();
  const Pose2 T_map_base = map->map().origin().storeys.front().to_map(Pose2(6.5, 4.2, 0.4));
  const auto detector = std::make_shared<RoomDetector>();
  detector->features = detected_from(*map, T_map_base);
  LocalizerParts parts;
  parts.map = map;
  parts.lasers[0].T_base_laser = T_base_laser;
  parts.detectors = {{"told", detector}};
  parts.patterns = std::move(templates);
  parts.scorers = {{"fit", fit_scorer(), ScorerRole::decides, 1}};
  Places places;
  Localizer localizer(std::move(parts), &places);
  if (hint) localizer.hint({T_map_base * hint->T_map_base, hint->sigma_m, hint->sigma_rad});
  localizer.update(sample_of(scan_from(*map, T_map_base), Pose2(), T_base_laser));
  return places;
}

}  // namespace

TEST_CASE("a place of another storey is told as one, and not as a hint") {
  const Places places = seen_once({}, {{"corner", std::make_shared<CornerTemplate>()}});
  CHECK(places.origins() == std::set<std::string>{"pattern", "other_storey"});
}

TEST_CASE("a place about a hint is told as one, and so is the same place of another storey") {
  const Places places = seen_once(PoseHint{Pose2(0.3, -0.2, 0.1), 0.5, 0.2}, {});
  CHECK(places.origins() == std::set<std::string>{"hint", "other_storey"});
}

TEST_CASE("a place names a template if it comes from a pattern, and only then") {
  const Places places = seen_once(PoseHint{}, {{"corner", std::make_shared<CornerTemplate>()}});
  REQUIRE_FALSE(places.spawned.empty());
  for (const auto& all : {places.spawned, places.rejected})
    for (const ordered_json& place : all) {
      CAPTURE(place.dump());
      CHECK(place.contains("template") == (place["origin"] == "pattern"));
      if (place.contains("template")) CHECK(place["template"] == "corner");
    }
}
