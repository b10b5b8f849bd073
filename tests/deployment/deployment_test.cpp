#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>
#include <opal/deployment/deployment.hpp>
#include "deployment_text.hpp"

#include "jsonld/json_ld.hpp"
#include "tests/kit/refusal.hpp"
#include "tests/kit/shipped_plugins.hpp"

#include <catch2/catch.hpp>

#include <filesystem>

using namespace opal;
using Catch::StartsWith;

namespace {

/// The message without the file's name, which must be there.
std::string refusal_of(const std::string& text) {
  return refused_with<Error>([&] { parse_deployment(text, kFile); }, kFile);
}

/// Two walls that make a room's corner, and a column.
std::shared_ptr<const SemanticMap> room(bool with_column) {
  std::vector<MapObject> objects{{"south", "opal:Wall", {MapFeatureNumber(0)}},
                                 {"east", "opal:Wall", {MapFeatureNumber(1)}}};
  std::vector<MapFeature> features{
      {"south/face", MapObjectNumber(0), "opal:Wall", "PlanarLidar2D", Segment{{0, 0}, {20, 0}}, 0, 1, {}},
      {"east/face", MapObjectNumber(1), "opal:Wall", "PlanarLidar2D", Segment{{20, 0}, {20, 10}}, 0, 1, {}}};
  if (with_column) {
    objects.push_back({"column", "opal:Column", {MapFeatureNumber(2)}});
    features.push_back(
        {"column/rim", MapObjectNumber(2), "opal:Column", "PlanarLidar2D", Circle{{5, 4}, 0.3}, 0, 1, {}});
  }
  return SemanticMap::make("room", objects, features);
}

template <class T>
std::vector<std::string> names_of(const std::vector<T>& parts) {
  std::vector<std::string> names;
  for (const T& part : parts) names.push_back(part.name);
  return names;
}

std::string building_refusal(const std::string& members) {
  return refused_with<ConfigError>([&] { build_parts(parsed(members), shipped_plugins(), room(true)); });
}

}  // namespace

TEST_CASE("a deployment that says nothing has the defaults of its structs") {
  const Deployment deployment = parsed("");
  CHECK(deployment.map.empty());
  CHECK(deployment.lasers.front().beams == LaserModel{}.beams);
  CHECK(deployment.keyframes.distance_m == KeyframeOptions{}.distance_m);
  CHECK(deployment.local_map.horizon_m == LocalMapOptions{}.horizon_m);
  CHECK_FALSE(deployment.matcher);
  CHECK_FALSE(deployment.detectors);
  CHECK_FALSE(deployment.patterns);
  REQUIRE(deployment.scorers.size() == 1);
  CHECK(deployment.scorers[0].decides());
  CHECK(deployment.scorers[0].weight == 1);
}

TEST_CASE("a deployment is read whole") {
  const Deployment deployment = parsed(R"(
    "name": "hall", "comment": "for a test", "map": "../maps/hall.jsonld",
    "sensor": { "id": "FrontLaser", "angle_min_rad": -3.1, "angle_increment_rad": 0.01, "beams": 620, "range_min_m": 0.1,
                "range_max_m": 20, "no_return_m": 25, "range_sigma_m": 0.03, "geometry_from_log": true,
                "T_base_laser": { "x_m": 0.78, "y_m": -0.1, "heading_rad": 0.5 } },
    "keyframes": { "distance_m": 0.5, "angle_rad": 0.7 },
    "local_map": { "horizon_m": 12, "stable_after": 2, "optimize_every": 0 },
    "matcher": { "@type": "opal:PointToLineMatcher", "options": { "a": 1 } },
    "detectors": [ { "@type": "opal:LineDetector", "options": { "min_points": 8 } }, { "@type": "opal:CircleDetector" } ],
    "patterns": [],
    "scorers": [ { "@type": "opal:Beams", "weight": 0.5 }, { "@type": "opal:Evidence", "role": "observes" } ],
    "stages": { "hypotheses": { "max_hypotheses": 7 } })");
  CHECK(deployment.map == "maps/hall.jsonld");
  CHECK(deployment.lasers.front().id == "FrontLaser");
  CHECK(deployment.lasers.front().angle_min_rad == -3.1);
  CHECK(deployment.lasers.front().beams == 620);
  CHECK(deployment.lasers.front().geometry_from_log);
  CHECK(deployment.lasers.front().T_base_laser.x() == 0.78);
  CHECK(deployment.lasers.front().T_base_laser.heading_rad() == Approx(0.5));
  CHECK(deployment.keyframes.angle_rad == 0.7);
  CHECK(deployment.local_map.horizon_m == 12);
  CHECK(deployment.local_map.stable_after == 2);
  CHECK(deployment.local_map.optimize_every == 0);
  REQUIRE(deployment.matcher);
  CHECK(deployment.matcher->options.at("a") == 1);
  REQUIRE(deployment.detectors);
  REQUIRE(deployment.detectors->size() == 2);
  CHECK((*deployment.detectors)[0].type == "opal:LineDetector");
  CHECK((*deployment.detectors)[1].where == kFile + ": /detectors/1");
  REQUIRE(deployment.patterns);
  CHECK(deployment.patterns->empty());
  REQUIRE(deployment.scorers.size() == 2);
  CHECK(deployment.scorers[0].weight == 0.5);
  CHECK_FALSE(deployment.scorers[1].decides());
  CHECK(deployment.stages.hypotheses.max_hypotheses == 7);
}

TEST_CASE("a careful deployment asks for more, and what its stages say goes first") {
  const StatusOptions usual = parsed("").stages.status, careful = parsed(R"("caution": "careful")").stages.status;
  CHECK(parsed(R"("caution": "usual")").stages.status.localized_lead == usual.localized_lead);
  CHECK(careful.localized_lead > usual.localized_lead);
  CHECK(careful.localized_weight > usual.localized_weight);
  CHECK(careful.lead().nat(100) > usual.lead().nat(100));
  const LocalizerOptions changed =
      parsed(R"("caution": "careful", "stages": {"status": {"localized_lead": 0.2}, "search": {"patterns": 4}})")
          .stages;
  CHECK(changed.status.localized_lead == 0.2);
  CHECK(changed.status.localized_weight == careful.localized_weight);
  CHECK(changed.search.hypotheses > SearchOptions().hypotheses);
  CHECK(refusal_of(document(R"("caution": "bold")")) == R"(/caution: "bold", expected "usual", "careful" or "strict")");
}

TEST_CASE("a strict deployment is careful, and asks for a map that shows the building as it is") {
  const LocalizerOptions careful = parsed(R"("caution": "careful")").stages,
                         strict = parsed(R"("caution": "strict")").stages;
  CHECK(strict.status.localized_weight == careful.status.localized_weight);
  CHECK(strict.status.lead().nat(50) > careful.status.lead().nat(50));  // where a place fits by chance
  CHECK(strict.status.localized_drive_agreement > 0);
  CHECK(careful.status.localized_drive_agreement == 0);
  CHECK(strict.kidnapping.doubted_share > 0);
  CHECK(careful.kidnapping.doubted_share == 0);
  CHECK(strict.kidnapping.doubted_weight > 0);
  CHECK(careful.kidnapping.doubted_weight == 0);
}

TEST_CASE("a scorer may stand twice where one observes, or with other options") {
  CHECK(parsed(R"("scorers": [{"@type": "a"}, {"@type": "a", "role": "observes"}])").scorers.size() == 2);
  CHECK(parsed(R"("scorers": [{"@type": "a"}, {"@type": "a", "options": {"b": 1}}])").scorers.size() == 2);
}

TEST_CASE("a map's path starts from the folder of the deployment") {
  CHECK(parsed(R"("map": "hall.jsonld")").map == "configs/hall.jsonld");
  CHECK(parsed(R"("map": "/maps/hall.jsonld")").map == "/maps/hall.jsonld");
}

TEST_CASE("overlays are one or several files, from the folder of the deployment") {
  CHECK(parsed("").overlays.empty());
  CHECK(parsed(R"("overlays": "../maps/may.jsonld")").overlays == std::vector<std::string>{"maps/may.jsonld"});
  CHECK(parsed(R"("overlays": ["may.jsonld", "/maps/june.jsonld"])").overlays ==
        std::vector<std::string>{"configs/may.jsonld", "/maps/june.jsonld"});
  CHECK(refusal_of(document(R"("overlays": [1])")) == "/overlays: [1], expected a list of texts");
}

TEST_CASE("a wrong deployment is refused with the place, what was found and what was expected") {
  const auto refusal = [](const std::string& members) { return refusal_of(document(members)); };
  CHECK(refusal(R"("sensor": {"beams": 0})") == "/sensor/beams: 0, expected an integer from 1 to 100000");
  CHECK(refusal(R"("sensor": {"beams": 3.5})") == "/sensor/beams: 3.5, expected an integer from 1 to 100000");
  CHECK(refusal(R"("sensor": {"range_max_m": "far"})") ==
        "/sensor/range_max_m: \"far\", expected a number from 0.0001 to 1000");
  CHECK(refusal(R"("sensor": {"range_min_m": 40})") == "/sensor/range_max_m: absent, expected more than range_min_m");
  CHECK(refusal(R"("sensor": {"T_base_laser": [0, 0, 0]})") == "/sensor/T_base_laser: [0,0,0], expected an object");
  CHECK(refusal(R"("sensor": {"slice": {}})") ==
        "/sensor/topic: absent, expected the topic of the point clouds that are sliced");
  CHECK(refusal(R"("sensor": {"topic": "/a", "slice": {"z_max_m": 0.1}})") ==
        "/sensor/slice/z_max_m: 0.1, expected more than z_min_m");
  CHECK(refusal(R"("sensor": {"topic": "/a", "slice": {"height": 1}})").find("/sensor/slice/height: unknown key") !=
        std::string::npos);
  CHECK(refusal(R"("detectors": {"@type": "a"})") == "/detectors: {\"@type\":\"a\"}, expected a list");
  CHECK(refusal(R"("detectors": ["opal:LineDetector"])") == "/detectors/0: \"opal:LineDetector\", expected an object");
  CHECK(refusal(R"("detectors": [{"options": {}}])") == "/detectors/0/@type: absent, expected a text");
  CHECK(refusal(R"("detectors": [{"@type": "a", "options": 3}])") == "/detectors/0/options: 3, expected an object");
  CHECK(refusal(R"("detectors": [{"@type": "a"}, {"@type": "a"}])") ==
        "/detectors/1/@type: \"a\", expected a type that is not in the list already");
  CHECK(refusal(R"("scorers": [{"@type": "a", "role": "judges"}])") ==
        "/scorers/0/role: \"judges\", expected \"decides\" or \"observes\"");
  CHECK(refusal(R"("scorers": [{"@type": "a", "weight": -1}])") ==
        "/scorers/0/weight: -1, expected a number from 0 to 1000");
  CHECK(refusal(R"("scorers": [{"@type": "a", "role": "observes"}])") ==
        "/scorers: no scorer decides, expected at least one with role \"decides\" and a weight above 0");
  CHECK(refusal(R"("scorers": [{"@type": "a", "weight": 0}])") ==
        "/scorers: no scorer decides, expected at least one with role \"decides\" and a weight above 0");
  CHECK_THAT(refusal(R"("scorers": [{"@type": "a"}, {"@type": "b"}, {"@type": "a"}])"),
             StartsWith("/scorers/2/@type: \"a\", expected a scorer that does not decide already with these options"));
  CHECK_THAT(refusal(R"("stages": {"hypotheses": {"max_hypotheses": 0}})"),
             StartsWith("/stages/hypotheses/max_hypotheses: 0, expected"));
  CHECK_THAT(refusal_of("[]"), StartsWith("/: [], expected an object"));
  CHECK(
      refusal_of(R"({"@context": "urn:opal:v2"})") ==
      "/@context: \"urn:opal:v2\", expected \"urn:opal:v1\", or a list of it and objects that define prefixes by IRIs");
  CHECK(refusal_of(R"({"@context": "urn:opal:v1", "@type": "Plugin"})") ==
        "/@type: \"Plugin\", expected \"opal:Deployment\"");
  CHECK(refusal_of("{\"@context\": ") != "accepted");
}

TEST_CASE("a key that is misspelt or obsolete is refused, with those that there are") {
  CHECK_THAT(refusal_of(document(R"("sensors": {})")),
             StartsWith("/sensors: unknown key, expected one of: @context, @type, "));
  CHECK(refusal_of(document(R"("keyframes": {"distance": 1})")) ==
        "/keyframes/distance: unknown key, expected one of: angle_rad, distance_m");
  CHECK(refusal_of(document(R"("matcher": {"@type": "a", "role": "decides"})")) ==
        "/matcher/role: unknown key, expected one of: @type, options");
  CHECK_THAT(refusal_of(document(R"("local_map": {"hor/izon~m": 1})")),
             StartsWith("/local_map/hor~1izon~0m: unknown key"));
}

TEST_CASE("a deployment that cannot be opened is an error that names it") {
  CHECK_THROWS_WITH(read_deployment("/nonexistent/a.jsonld"), StartsWith("/nonexistent/a.jsonld"));
}

TEST_CASE("without lists in the deployment, the map decides what runs") {
  const PluginRegistry& registry = shipped_plugins();
  const LocalizerParts walls = build_parts(parsed(""), registry, room(false));
  CHECK_THAT(names_of(walls.detectors), Catch::VectorContains(std::string("opal:LineDetector")));
  CHECK_THAT(names_of(walls.detectors), !Catch::VectorContains(std::string("opal:CircleDetector")));
  CHECK_THAT(names_of(walls.patterns), !Catch::VectorContains(std::string("opal:ColumnPair")));
  const LocalizerParts hall = build_parts(parsed(""), registry, room(true));
  CHECK_THAT(names_of(hall.detectors), Catch::VectorContains(std::string("opal:CircleDetector")));
  CHECK_THAT(names_of(hall.patterns), Catch::VectorContains(std::string("opal:ColumnPair")));
}

TEST_CASE("a deployment narrows what the map calls for, and keeps its own order") {
  const PluginRegistry& registry = shipped_plugins();
  const Deployment deployment =
      parsed(R"("detectors": [{"@type": "opal:CircleDetector"}, {"@type": "opal:LineDetector"}])");
  CHECK(names_of(build_parts(deployment, registry, room(true)).detectors) ==
        std::vector<std::string>{"opal:CircleDetector", "opal:LineDetector"});
  CHECK(names_of(build_parts(deployment, registry, room(false)).detectors) ==
        std::vector<std::string>{"opal:LineDetector"});
}

TEST_CASE("a pattern that waits to be named runs where the deployment names it") {
  CHECK_THAT(names_of(build_parts(parsed(""), shipped_plugins(), room(true)).patterns),
             !Catch::VectorContains(std::string("opal:ColumnWallPair")));
  const auto parts =
      build_parts(parsed(R"("patterns": [{"@type": "opal:ColumnWallPair"}])"), shipped_plugins(), room(true));
  CHECK(names_of(parts.patterns) == std::vector<std::string>{"opal:ColumnWallPair"});
}

TEST_CASE("a pattern whose features no detector of the deployment produces does not run") {
  const LocalizerParts parts =
      build_parts(parsed(R"("detectors": [{"@type": "opal:LineDetector"}])"), shipped_plugins(), room(true));
  CHECK_THAT(names_of(parts.patterns), !Catch::VectorContains(std::string("opal:ColumnPair")));
  CHECK_THAT(names_of(parts.patterns), Catch::VectorContains(std::string("opal:LinePair")));
}

TEST_CASE("parts that no plugin offers, of another kind, or with wrong options are refused by file and place") {
  CHECK_THAT(
      building_refusal(R"("detectors": [{"@type": "acme:Nothing"}])"),
      StartsWith(kFile +
                 ": /detectors/0/@type: \"acme:Nothing\", which no plugin offers, expected a FeatureDetector (opal:"));
  CHECK_THAT(
      building_refusal(R"("detectors": [{"@type": "opal:Beams"}])"),
      StartsWith(kFile +
                 ": /detectors/0/@type: \"opal:Beams\", which is a HypothesisScorer, expected a FeatureDetector"));
  CHECK_THAT(building_refusal(R"("detectors": [{"@type": "opal:LineDetector", "options": {"min_points": 1}}])"),
             StartsWith(kFile + ": /detectors/0/options/min_points: 1, expected an integer"));
  CHECK_THAT(building_refusal(R"("scorers": [{"@type": "opal:Beams", "options": {"sigma": 1}}])"),
             StartsWith(kFile + ": /scorers/0/options/sigma: unknown, expected one of: "));
  CHECK_THAT(building_refusal(R"("patterns": [])"),
             StartsWith(kFile + ": /patterns: nothing is left to run with this map"));
}

TEST_CASE("every shipped configuration is readable, and its parts can be made") {
  const PluginRegistry& registry = shipped_plugins();
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(OPAL_SOURCE_DIR "/configs")) {
    if (entry.path().filename() == "behaviours.jsonld") continue;  // tests/behaviours
    CAPTURE(entry.path().string());
    const Deployment deployment = read_deployment(entry.path().string());
    CHECK_NOTHROW(build_parts(deployment, registry, room(true)));
    ++files;
  }
  CHECK(files >= 2);
}

TEST_CASE("every shipped configuration is JSON-LD of Opal's vocabulary, its lists ordered") {
  json_ld::Options options;
  options.contexts["urn:opal:v1"] = read_json(OPAL_SOURCE_DIR "/maps/context/opal.jsonld");
  options.reject_unknown_terms = true;
  for (const auto& entry : std::filesystem::directory_iterator(OPAL_SOURCE_DIR "/configs")) {
    if (entry.path().filename() == "behaviours.jsonld") continue;
    CAPTURE(entry.path().string());
    const nlohmann::json expanded = json_ld::expand(read_json(entry.path().string()), options);
    REQUIRE(expanded.size() == 1);
    CHECK(expanded[0]["@type"][0] == "urn:opal:v1#Deployment");
    CHECK(expanded[0]["urn:opal:v1#scorers"][0].contains("@list"));
  }
}
