#include "map/check/map_check.hpp"
#include "deployment/pipeline_plan.hpp"

#include <catch2/catch.hpp>

using namespace opal;

namespace {

MapFeature feature(const std::string& id, const Geometry& geometry, const std::string& sensor = "lidar") {
  MapFeature made;
  made.id = id;
  made.object = MapObjectNumber(0);
  made.sensor = sensor;
  made.geometry = geometry;
  return made;
}

const std::vector<MapFeatureNumber> kBoth{MapFeatureNumber(0), MapFeatureNumber(1)};

std::shared_ptr<const SemanticMap> map_of(std::vector<MapFeature> features, std::vector<MapPattern> patterns = {}) {
  return SemanticMap::make("test", {{"thing", "Wall"}}, std::move(features), std::move(patterns));
}

RegisteredType type(PluginKind kind, const std::string& name, std::vector<std::string> consumes,
                    std::vector<std::string> produces) {
  RegisteredType made;
  made.info = {name, std::move(consumes), std::move(produces)};
  made.kind = kind;
  return made;
}

const std::vector<RegisteredType> kTypes{
    type(PluginKind::pattern_template, "t:Pair", {"opal:Column"}, {}),
    type(PluginKind::pattern_template, "t:Post", {"opal:Wall", "opal:Column"}, {}),
    type(PluginKind::pattern_template, "t:Any", {}, {}),
    type(PluginKind::feature_detector, "t:Lines", {}, {"opal:Wall", "opal:Corner"}),
    type(PluginKind::feature_detector, "t:Circles", {}, {"opal:Column"}),
    type(PluginKind::hypothesis_scorer, "t:Scorer", {}, {}),
};

const Geometry kWall = Segment{{0, 0}, {4, 0}}, kColumn = Circle{{2, 2}, 0.3};

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("a detector runs if the map holds what it produces, a pattern if all it consumes is there") {
  const PipelinePlan plan = plan_pipeline(*map_of({feature("w", kWall)}), "lidar", kTypes);
  CHECK(plan.detectors == Names{"t:Lines"});
  CHECK(plan.patterns == Names{"t:Any"});
  CHECK(plan.reasons == Names{"t:Circles: does not run, the map holds no opal:Column for lidar",
                              "t:Lines: runs, the map holds 1 opal:Wall for lidar",
                              "t:Any: runs, it consumes any feature",
                              "t:Pair: does not run, it consumes opal:Column, which no running detector produces",
                              "t:Post: does not run, it consumes opal:Column, which no running detector produces"});
  const PipelinePlan both = plan_pipeline(*map_of({feature("w", kWall), feature("c", kColumn)}), "lidar", kTypes);
  CHECK(both.detectors == Names{"t:Circles", "t:Lines"});
  CHECK(both.patterns == Names{"t:Any", "t:Pair", "t:Post"});
}

TEST_CASE("templates that the map's patterns name run alone") {
  const auto map = map_of({feature("c1", kColumn), feature("c2", Circle{{6, 2}, 0.3})},
                          {{"p", "t:Pair", kBoth}, {"q", "t:Missing", kBoth}});
  const PipelinePlan plan = plan_pipeline(*map, "lidar", kTypes);
  CHECK(plan.patterns == Names{"t:Pair"});
  CHECK(plan.reasons.back() == "t:Missing: no plugin offers it; 1 patterns of the map stay unused");
}

TEST_CASE("a template that waits to be named runs only where the map's patterns name it") {
  std::vector<RegisteredType> types = kTypes;
  types.front().on_request = true;  // t:Pair
  const std::vector<MapFeature> columns{feature("c1", kColumn), feature("c2", Circle{{6, 2}, 0.3})};
  const PipelinePlan plan = plan_pipeline(*map_of(columns), "lidar", types);
  CHECK(plan.patterns == Names{"t:Any"});
  CHECK(plan.on_request == Names{"t:Pair"});
  const PipelinePlan named = plan_pipeline(*map_of(columns, {{"p", "t:Pair", kBoth}}), "lidar", types);
  CHECK(named.patterns == Names{"t:Pair"});
  CHECK(named.on_request.empty());
}

TEST_CASE("what one sensor perceives starts no detector for another") {
  const auto map = map_of({feature("w", kWall, "camera")});
  const PipelinePlan plan = plan_pipeline(*map, "lidar", kTypes);
  CHECK(plan.detectors.empty());
  CHECK(plan.patterns.empty());
}

TEST_CASE("features that no detector produces are said to stay unseen") {
  MapFeature odd = feature("w", kWall);
  odd.type = "acme:Skirting";
  const PipelinePlan plan = plan_pipeline(*map_of({odd}), "lidar", kTypes);
  CHECK(std::ranges::count(plan.reasons, "acme:Skirting: no detector produces it; 1 features of the map stay unseen") ==
        1);
}

TEST_CASE("a check counts what the example room holds and finds only its door unrepresented") {
  const MapCheck check = check_map(*SemanticMap::read(OPAL_SOURCE_DIR "/maps/example_room.jsonld"));
  CHECK(check.objects_by_type ==
        std::map<std::string, int>{{"opal:Column", 2}, {"opal:Corner", 1}, {"opal:Door", 1}, {"opal:Wall", 4}});
  CHECK(check.features_by_geometry == std::array<int, 4>{0, 1, 5, 2});
  CHECK(check.wall_length_m == Approx(8 + 5 + 2.6 + 4.5 + 5));
  CHECK(check.shared_points == 4);
  CHECK(check.bounds[1] == Point(8, 5));
  CHECK(check.warnings.empty());
}

TEST_CASE("a wall that nothing represents or nobody perceives is warned about, a door or an imported pane is not") {
  MapObject pane{"pane", "Wall"};
  pane.notes.source_class = "IfcCurtainWall";
  std::vector<MapFeature> features{feature("seen", kWall), feature("unseen", Segment{{0, 3}, {4, 3}}, ""),
                                   feature("leaf", Segment{{0, 2}, {1, 2}}, ""),
                                   feature("glass", Segment{{2, 2}, {3, 2}}, "")};
  features[2].object = MapObjectNumber(2);
  features[3].object = MapObjectNumber(3);
  const auto map = SemanticMap::make(
      "test", {{"wall", "Wall"}, {"ghost", "Wall"}, {"door", "Door"}, pane, {"opening", "Door"}}, features, {});
  CHECK(check_map(*map).warnings ==
        Names{"1 object that nothing represents: 'ghost'", "1 feature that no sensor perceives: 'unseen'"});
}

TEST_CASE("ends of walls that were measured, and are not sure to a centimetre, may lie side by side") {
  std::vector<MapFeature> sides{feature("front", kWall), feature("back", Segment{{4, 0.001}, {0, 0.001}})};
  CHECK(check_map(*map_of(sides)).warnings.size() == 1);
  for (MapFeature& side : sides) side.position_sigma_m = 0.03;
  CHECK(check_map(*map_of(sides)).warnings.empty());
}

TEST_CASE("an imported pane may be thinner than points may lie side by side, a drawn wall may not") {
  const std::vector<MapFeature> sides{feature("front", kWall), feature("back", Segment{{4, 0.008}, {0, 0.008}})};
  MapObject pane{"wall", "Wall"};
  CHECK(check_map(*SemanticMap::make("test", {pane}, sides, {})).warnings.size() == 1);
  pane.notes.source_class = "IfcPlate";
  CHECK(check_map(*SemanticMap::make("test", {pane}, sides, {})).warnings.empty());
}

TEST_CASE("repeated geometry, unshared ends and lonely features are warned about") {
  const auto map = map_of({feature("a", kWall), feature("a2", Segment{{0.001, 0}, {4, 0.001}}),
                           feature("back", Segment{{4, 0}, {0, 0}}), feature("far", Circle{{500, 0}, 1})});
  const Names warnings = check_map(*map).warnings;
  REQUIRE(warnings.size() == 3);
  CHECK(warnings[0] == "1 feature with the geometry of another one: 'a' and 'a2'");
  CHECK(warnings[1] ==
        "4 points within 1 cm of another point, without being one: 'a2/begin' and 'a/begin', 'a2/end' "
        "and 'a/end', 'back/begin' and 'a/end' and 1 more");
  CHECK(warnings[2] == "1 feature with no other within 15 m: 'far'");
}

TEST_CASE("degrees for radians, millimetres for metres and misspelt types of a map made by hand are warned about") {
  const auto warnings_of = [](const std::string& type, const Geometry& geometry) {
    return check_map(*SemanticMap::make("test", {{"thing", type}}, {feature("f", geometry)})).warnings;
  };
  CHECK(warnings_of("opal:Column", OrientedPoint{{0, 0}, 45, 1.57}) ==
        Names{"1 corner with a heading_rad of more than a turn, are these degrees?: 'f'"});
  CHECK(warnings_of("opal:Wall", Segment{{0, 0}, {4200, 0}}) ==
        Names{"1 segment longer than 1 km, are these millimetres?: 'f'"});
  CHECK(warnings_of("opal:Wal", kWall) ==
        Names{"type opal:Wal is no word of Opal's vocabulary, is opal:Wall meant? At 1 object: 'thing'"});
  for (const char* type : {"opal:Kiosk", "opal:Wall", "acme:Wal", "opal:Corner"})
    CHECK(warnings_of(type, kWall).empty());
}

TEST_CASE("a face that was drawn backward is warned about, faces of a room and of lines that meet are not") {
  const auto room = [](const Segment& south) {
    return map_of({feature("south", south), feature("east", Segment{{4, 0}, {4, 3}}),
                   feature("north", Segment{{4, 3}, {0, 3}}), feature("west", Segment{{0, 3}, {0, 0}})});
  };
  const auto about_faces = [](const SemanticMap& map) {
    const Names warnings = check_map(map).warnings;
    return std::ranges::count(warnings,
                              "1 face whose neighbours all run the other way, are begin and end exchanged?: 'south'");
  };
  CHECK(about_faces(*room({{0, 0}, {4, 0}})) == 0);
  CHECK(about_faces(*room({{4, 0}, {0, 0}})) == 1);
  const auto backward = room({{4, 0}, {0, 0}});
  std::vector<MapObject> objects = backward->objects();
  objects.front().notes.source_class = "wall";
  CHECK(about_faces(*SemanticMap::make("plan", objects, backward->features())) == 0);
  CHECK(about_faces(*map_of({feature("south", kWall), feature("back", Segment{{4, 0}, {0, 0}}),
                             feature("on", Segment{{4, 0}, {8, 0}})})) == 0);
}

TEST_CASE("a check names storeys and lifts, and says that there is nothing to warn about") {
  MapOrigin origin;
  origin.storeys = {{"low"}, {"top"}};
  origin.storeys[1].origin = {200, 0};
  origin.connections = {{"lift", "opal:Lift", "", 1, {{"low", Pose2(1, 1, 0)}, {"top", Pose2(1, 1, 0)}}}};
  const std::vector<MapFeature> faces{feature("low/a", kWall), feature("low/b", Segment{{4, 0}, {4, 3}}),
                                      feature("top/a", Segment{{200, 0}, {204, 0}}),
                                      feature("top/b", Segment{{204, 0}, {204, 3}})};
  std::vector<std::string> sentences =
      check_map(*SemanticMap::make("house", {{"low/thing", "opal:Wall"}}, faces, {}, origin)).sentences();
  const auto says = [&](const std::string& wanted) { return std::ranges::count(sentences, wanted) == 1; };
  CHECK(says("2 storeys: low (2 features), top (2 features)"));
  CHECK(says("1 connection: 1 opal:Lift"));
  CHECK(check_map(*SemanticMap::read(OPAL_SOURCE_DIR "/maps/example_room.jsonld")).sentences().back() ==
        "nothing to warn about");
}

TEST_CASE("a map without features has no extent and says so") {
  const MapCheck check = check_map(*map_of({}));
  CHECK(check.bounds[0] == Point(0, 0));
  CHECK(check.warnings.front() == "no feature at all: nothing to localize by");
  CHECK(check.sentences().front() == "1 object: 1 opal:Wall");
}

TEST_CASE("a check of a map as wide as coordinates go is quick") {
  std::vector<MapFeature> features;
  for (int i = 0; i < 2000; ++i) features.push_back(feature(std::to_string(i), Segment{{-1e6, 0.02 * i}, {1e6, 0}}));
  for (int i = 2000; i < 4000; ++i) features.push_back(feature(std::to_string(i), Circle{{0, 0}, 1}));
  const MapCheck check = check_map(*map_of(features));
  CHECK(check.features_by_geometry[3] == 2000);
}

TEST_CASE("what only runs classes of Python is not told of, for no map can call for it") {
  std::vector<RegisteredType> types = kTypes;
  types.push_back(type(PluginKind::feature_detector, "opal:PythonDetector", {}, {"opal:FoundByPython"}));
  types.push_back(type(PluginKind::pattern_template, "opal:PythonPattern", {}, {}));
  types.back().on_request = true;
  const PipelinePlan plan = plan_pipeline(*map_of({feature("w", kWall)}), "lidar", types);
  CHECK(plan.reasons == plan_pipeline(*map_of({feature("w", kWall)}), "lidar", kTypes).reasons);
  CHECK(plan.on_request == Names{"opal:PythonPattern"});
}

TEST_CASE("a map of which no sensor perceives anything is warned of, also if it is made of doors and glass alone") {
  const std::string warning = "no feature that a sensor perceives: nothing to localize by";
  const auto map_with = [](const std::string& sensor) {
    return SemanticMap::make("test", {{"pane", "opal:Window"}},
                             {feature("pane/line-1", kWall, ""), feature("pane/line-2", kColumn, sensor)}, {});
  };
  const auto warnings = check_map(*map_with("")).warnings;
  CHECK(std::ranges::find(warnings, warning) != warnings.end());
  const auto seen = check_map(*map_with("lidar")).warnings;
  CHECK(std::ranges::find(seen, warning) == seen.end());
}
