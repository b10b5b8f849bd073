// A map's pattern layer on recorded data: it alone is looked up, and a pattern is one node at the tree's root.
#include "event_recorder.hpp"
#include "recorded_site.hpp"

#include "tests/kit/shipped_plugins.hpp"

#include "patterns/pattern_layer.hpp"

#include <catch2/catch.hpp>

#include <set>

using namespace opal;

namespace {

std::shared_ptr<const SemanticMap> with_layer(const RecordedSite& site, const std::vector<std::string>& names) {
  const PluginRegistry& registry = shipped_plugins();
  std::vector<Named<PatternTemplate>> templates;
  for (const std::string& name : names) templates.push_back({name, registry.make<PatternTemplate>(name)});
  return site.map->with_patterns(find_pattern_layer(MapView(site.map, "PlanarLidar2D"), templates).patterns);
}

}  // namespace

TEST_CASE("with a pattern layer, only its patterns are looked up, and each gives a root with all its members") {
  const RecordedSite site("malaga");
  const std::vector<std::string> names{"opal:ColumnPair", "opal:Collinear", "opal:LShape"};
  const LocalizerParts parts = site.parts(with_layer(site, names));
  std::set<std::string> running;
  for (const auto& pattern : parts.patterns) running.insert(pattern.name);
  CHECK(running == std::set<std::string>(names.begin(), names.end()));

  EventRecorder recorder;
  Localizer localizer(parts, &recorder);
  const auto scans = replay(localizer, site.samples);
  int spawned = 0;
  for (const auto& event : recorder.events) {
    if (event["event"] != "spawned") continue;
    ++spawned;
    CHECK(event["pairs"].size() == (event["template"] == "opal:ColumnPair" ? 2u : 3u));
  }
  CHECK(spawned > 0);
  const ReplayedScan& last = scans.back();
  REQUIRE(last.estimate.has_pose);
  const auto truth = site.truth.T_map_laser_at(last.stamp_s);
  REQUIRE(truth);
  CHECK(distance_m(last.estimate.T_map_base * site.laser.T_base_laser, *truth) < 0.5);
}
