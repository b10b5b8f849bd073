#include "tests/kit/refusal.hpp"

#include <opal/common/error.hpp>
#include <opal/map/semantic_map.hpp>

#include <catch2/catch.hpp>

#include <fstream>
#include <limits>
#include <set>

using namespace opal;

namespace {

const double kNaN = std::numeric_limits<double>::quiet_NaN();

MapFeature feature(const std::string& id, const Geometry& geometry, int object = 0) {
  MapFeature made;
  made.id = id;
  made.object = MapObjectNumber(object);
  made.sensor = "PlanarLidar2D";
  made.geometry = geometry;
  return made;
}

std::shared_ptr<const SemanticMap> map_of(const Geometry& geometry) {
  return SemanticMap::make("test", {{"wall", "Wall"}}, {feature("face", geometry)});
}

std::string message_of_parse(const std::string& graph) {
  return refused_with<MapError>(
      [&] { SemanticMap::parse(R"({"@context": "urn:opal:v1", "@graph": [)" + graph + "]}", "room.jsonld"); });
}

/// One wall with one segment, of which the begin point is given.
std::string wall_from(const std::string& begin) {
  return R"({"@id": "w", "@type": "Wall", "represented_by": {"@type": "ObjectFeatureRepresentation",
             "perceivable_by": {"@id": "lidar"}, "represented_by": {"@id": "s", "@type": "LineSegment",
             "begin": )" +
         begin + R"(, "end": {"@id": "b", "@type": "Point", "x": 4, "y": 0}}}})";
}

/// One object of which the geometry node is given.
std::string thing(const std::string& geometry, const std::string& more = "") {
  return R"({"@id": "c", "@type": "Column", "represented_by": {"@type": "ObjectFeatureRepresentation",
             "perceivable_by": {"@id": "lidar"}, )" +
         more + R"("represented_by": )" + geometry + "}}";
}

struct Fault {
  std::string graph;
  std::string message;
};

}  // namespace

TEST_CASE("a map made in memory has types, point names and lists of features filled in") {
  const auto map =
      SemanticMap::make("test", {{"wall", "Wall"}, {"column", "urn:opal:v1#Column"}},
                        {feature("face", Segment{{0, 0}, {1, 0}}, 0), feature("rim", Circle{{2, 2}, 0.3}, 1)});
  REQUIRE(map->objects().size() == 2);
  CHECK(map->objects()[0].id == "column");
  CHECK(map->objects()[0].type == "opal:Column");
  CHECK(map->objects()[0].features == std::vector{MapFeatureNumber(1)});
  CHECK(map->objects()[1].type == "opal:Wall");
  CHECK(map->features()[0].type == "opal:Wall");
  CHECK(map->features()[0].object == MapObjectNumber(1));
  CHECK(map->features()[0].points == std::vector<std::string>{"face/begin", "face/end"});
  CHECK(map->features()[1].type == "opal:Column");
  CHECK(map->features()[1].points == std::vector<std::string>{"rim/center"});
}

TEST_CASE("numbers inside ids count as numbers in the order of a map") {
  std::vector<MapFeature> features;
  for (const char* id : {"f10", "f2", "f1", "f02", "a"}) features.push_back(feature(id, Point(1, 2)));
  const auto map = SemanticMap::make("test", {{"thing", "acme:Thing"}}, features);
  std::vector<std::string> ids;
  for (const MapFeature& f : map->features()) ids.push_back(f.id);
  CHECK(ids == std::vector<std::string>{"a", "f1", "f02", "f2", "f10"});
}

TEST_CASE("points that features share take one position, and may not be apart") {
  MapFeature a = feature("a", Segment{{0, 0}, {1, 0}}), b = feature("b", Segment{{1 + 1e-9, 0}, {1, 2}});
  a.points = {"p", "q"};
  b.points = {"q", "r"};
  const auto map = SemanticMap::make("test", {{"wall", "Wall"}}, {a, b});
  CHECK(std::get<Segment>(map->features()[1].geometry).begin.x() == 1.0);
  b.geometry = Segment{{1.01, 0}, {1, 2}};
  CHECK_THROWS_WITH(SemanticMap::make("test", {{"wall", "Wall"}}, {a, b}),
                    Catch::Contains("point 'q' is at [1.01,0.0], but feature 'a' has it at [1.0,0.0]"));
}

TEST_CASE("a map made in memory is refused with the element and what was expected") {
  CHECK_THROWS_WITH(map_of(Segment{{0, 0}, {kNaN, 0}}), Catch::Contains("test: /features/0 'face': coordinate of end"));
  CHECK_THROWS_WITH(map_of(Point(0, 2e6)), Catch::Contains("2000000.0, expected metres"));
  CHECK_THROWS_WITH(map_of(Segment{{1, 1}, {1, 1}}), Catch::Contains("expected two different points"));
  CHECK_THROWS_WITH(map_of(Circle{{0, 0}, 0}), Catch::Contains("radius_m 0.0, expected a positive number"));
  CHECK_THROWS_WITH(map_of(Circle{{0, 0}, kNaN}), Catch::Contains("radius_m null, expected a positive number"));
  CHECK_THROWS_WITH(map_of(OrientedPoint{{0, 0}, 0, 7}),
                    Catch::Contains("opening_rad 7.0, expected an angle in (0, 2 pi)"));
  MapFeature odd = feature("face", Point(0, 0));
  odd.existence = 1.5;
  CHECK_THROWS_WITH(SemanticMap::make("t", {{"w", "Wall"}}, {odd}),
                    Catch::Contains("existence 1.5, expected a probability"));
  odd = feature("face", Point(0, 0), 1);
  CHECK_THROWS_WITH(SemanticMap::make("t", {{"w", "Wall"}}, {odd}),
                    Catch::Contains("object number 1, expected one of 1"));
  odd = feature("w", Point(0, 0));
  CHECK_THROWS_WITH(SemanticMap::make("t", {{"w", "Wall"}}, {odd}),
                    Catch::Contains("stands for an object and a point"));
  CHECK_THROWS_WITH(SemanticMap::make("t", {{"w", "Wal"}}, {}), Catch::Contains("type 'Wal', expected a term"));
  CHECK_THROWS_WITH(SemanticMap::make("t", {{"w", "Wall:Thick"}}, {}), Catch::Contains("expected a term"));
  CHECK_THROWS_WITH(SemanticMap::make("t", {{"w", "a b:Thick"}}, {}), Catch::Contains("expected a term"));
  CHECK_THROWS_WITH(SemanticMap::make("t", {{"", "Wall"}}, {}), Catch::Contains("is empty, expected a name"));
  CHECK_THROWS_WITH(SemanticMap::make("t", {{"_:w", "Wall"}}, {}), Catch::Contains("meaning of its own in JSON-LD"));
  CHECK_THROWS_WITH(SemanticMap::make("t", {{"\xff", "Wall"}}, {}), Catch::Contains("not UTF-8"));
  CHECK_THROWS_WITH(SemanticMap::make("t", {{"w", "Wall"}, {"w", "Door"}}, {}),
                    Catch::Contains("stands for two objects"));
}

TEST_CASE("a pattern of a map has members of one sensor and parts that are no circle") {
  const std::vector<MapObject> objects{{"o", "Column"}};
  const std::vector<MapFeature> features{feature("a", Circle{{0, 0}, 1}), feature("b", Circle{{4, 0}, 1})};
  const auto make = [&](const std::vector<MapPattern>& patterns) {
    return SemanticMap::make("t", objects, features, patterns);
  };
  CHECK(make({{"p", "opal:ColumnPair", {MapFeatureNumber(1), MapFeatureNumber(0)}, {}, {4}}})->patterns()[0].features ==
        std::vector{MapFeatureNumber(1), MapFeatureNumber(0)});
  CHECK_THROWS_WITH(make({{"p", "opal:ColumnPair", {MapFeatureNumber(0), MapFeatureNumber(2)}}}),
                    Catch::Contains("feature number 2, expected one of 2"));
  CHECK_THROWS_WITH(make({{"p", "opal:ColumnPair", {}}}), Catch::Contains("has no features"));
  CHECK_THROWS_WITH(make({{"p", "opal:ColumnPair", {MapFeatureNumber(0)}, {"q"}}}),
                    Catch::Contains("subpattern 'q', expected the id"));
  CHECK_THROWS_WITH(
      make({{"p", "opal:A", {MapFeatureNumber(0)}, {"q"}}, {"q", "opal:A", {MapFeatureNumber(0)}, {"p"}}}),
      Catch::Contains("expected no cycle"));
  CHECK_THROWS_WITH(make({{"p", "opal:A", {MapFeatureNumber(0)}, {}, {kNaN}}}),
                    Catch::Contains("dimension null, expected a finite number"));
}

TEST_CASE("the example room is read with its topology, qualities and pattern") {
  const auto map = SemanticMap::read(OPAL_SOURCE_DIR "/maps/example_room.jsonld");
  CHECK(map->name() == "Example room");
  CHECK(map->objects().size() == 8);
  REQUIRE(map->features().size() == 8);
  const auto at = [&](const std::string& id) -> const MapFeature& {
    for (const MapFeature& f : map->features())
      if (f.id == id) return f;
    FAIL("no feature " << id);
    throw std::logic_error(id);
  };
  CHECK(at("south_face").points[1] == at("east_face").points[0]);
  CHECK(at("south_west_angle").points[0] == at("south_face").points[0]);
  CHECK(at("south_west_angle").type == "opal:Corner");
  CHECK(at("column_2_rim").existence == 0.9);
  CHECK(at("west_face").position_sigma_m == 0.05);
  CHECK(std::get<Circle>(at("column_1_rim").geometry).radius_m == 0.25);
  REQUIRE(map->patterns().size() == 1);
  CHECK(map->patterns()[0].pattern_template == "opal:ColumnPair");
  CHECK(map->feature(map->patterns()[0].features[1]).id == "column_2_rim");
  CHECK(map->unused().empty());
}

TEST_CASE("a document is refused with its place, what was found and what was expected") {
  const std::string good_point = R"({"@id": "a", "@type": "Point", "x": 0, "y": 0})";
  const std::string center = R"("center": {"@type": "Point", "x": 1, "y": 1})";
  const auto fault = GENERATE_COPY(values<Fault>({
      {wall_from(R"("nowhere")"), "/@graph/0/represented_by/represented_by/begin: LineSegment 's' refers to 'nowhere'"},
      {wall_from(R"({"@id": "a", "@type": "Point", "x": 0})"), "Point 'a' has no y, expected one"},
      {wall_from(R"({"@id": "a", "@type": "Point", "x": "far", "y": 0})"),
       "x of Point 'a' is \"far\", expected a number"},
      {wall_from(R"({"@id": "a", "@type": "Point", "x": [0, 1], "y": 0})"),
       "has the values 0 and 1 for x, expected one"},
      {wall_from(R"({"@id": "a", "@type": "Point", "x": 1e7, "y": 0})"), "expected metres in the map frame"},
      {wall_from(R"({"@id": "a", "x": 0, "y": 0})"), "expected @type Point"},
      {wall_from(R"({"@type": "Point", "x": 4, "y": 0})"), "expected two different points"},
      {wall_from(R"("b")"), "expected two different points"},
      {wall_from(good_point) + R"(, {"@id": "a", "x": 1})", "has the values 0 and 1 for x"},
      {wall_from(good_point) + R"(, {"@id": "s", "radius_m": 1})", "has radius_m, which means nothing there; expected"},
      {wall_from(good_point) + R"(, {"@id": "s", "opal:lenght": 1})", "unknown key opal:lenght"},
      {wall_from(good_point) + R"(, {"@id": "s", "lenght": 1})", "/@graph/1/lenght: unknown term"},
      {wall_from(good_point) + R"(, {"@id": "w2", "@type": "Wal"})",
       "/@graph/1/@type: unknown term: \"Wal\" maps to no IRI, expected a term of urn:opal:v1"},
      {wall_from(good_point) + R"(, {"@id": "o2", "@type": "Door", "represented_by": "s"})",
       "represented by a LineSegment 's', expected an ObjectFeatureRepresentation"},
      {R"({"@id": "r", "@type": "ObjectFeatureRepresentation", "represented_by": "s"})", "belongs to no object"},
      {R"({"@id": "w", "represented_by": {"@id": "r"}})", "has no @type"},
      {thing(R"({"@id": "k", "@type": "Circle", "radius_m": -1, )" + center + "}"),
       "radius_m -1.0, expected a positive number"},
      {thing(R"({"@id": "k", "@type": "Circle", )" + center + "}"), "Circle 'k' has no radius_m"},
      {thing(R"({"@type": "Circle", "radius_m": 1, )" + center + "}"), "Circle without @id, expected an @id"},
      {thing(R"({"@id": "k", "@type": "Polygon"})"), "\"Polygon\" maps to no IRI"},
      {thing(R"({"@id": "k", "@type": "sf:Polygon"})"), "expected one of the types LineSegment, Corner, Circle, Point"},
      {thing(R"({"@id": "k", "@type": "Point", "x": 1, "y": 2})", R"("existence": 2, )"),
       "existence 2.0, expected a probability"},
      {thing(R"({"@id": "k", "@type": "Point", "x": 1, "y": 2})", R"("feature_type": "Waal", )"),
       "/feature_type: unknown term: \"Waal\""},
      {R"({"@id": "p", "@type": "FeaturePattern", "template": "opal:A", "features": ["x"]})", "has the member 'x'"},
      {R"({"@type": "SemanticMap"}, {"@type": "SemanticMap"})", "a second SemanticMap"},
      {R"({"@id": "g", "@graph": [{"@id": "w", "@type": "Wall"}]})", "named graph"},
  }));
  const std::string message = message_of_parse(fault.graph);
  CAPTURE(fault.graph, message);
  CHECK(message.find("room.jsonld: ") == 0);
  CHECK(message.find(fault.message) != std::string::npos);
}

TEST_CASE("text that is no map is refused, whatever it is") {
  for (const std::string& text : {std::string(), std::string("{"), std::string("[1, 2"), std::string("\xff\xfe"),
                                  std::string(R"({"@context": "https://example.org/c", "@graph": []})"),
                                  std::string(R"({"@context": {"@import": "urn:opal:v1"}, "a": 1, "a": 2})"),
                                  std::string(R"({"@context": {"a": "b:c", "b": "a:d"}})"), std::string(10000, '[')}) {
    CAPTURE(text.substr(0, 80));
    CHECK_THROWS_AS(SemanticMap::parse(text, "broken.jsonld"), MapError);
  }
  CHECK_THROWS_WITH(SemanticMap::read("/nowhere/room.jsonld"), Catch::Contains("/nowhere/room.jsonld"));
}

TEST_CASE("what other vocabularies say is kept and written back") {
  const auto map = SemanticMap::parse(
      R"({"@context": ["urn:opal:v1", {"props": "https://example.org/props#"}], "@graph": [
          {"@id": "w", "@type": ["Wall", "bot:Element", "https://example.org/ifc#IfcWall"], "props:width": 0.2,
           "represented_by": {"@type": "ObjectFeatureRepresentation", "perceivable_by": {"@id": "lidar"}, "props:by": "hand",
             "represented_by": {"@id": "s", "@type": "LineSegment",
               "begin": {"@type": "Point", "x": 0, "y": 0, "props:z": 1}, "end": {"@type": "Point", "x": 1, "y": 0}}}},
          {"@id": "floor", "@type": "Storey", "contains_element": "w", "props:note": {"props:text": "blank"}}]})",
      "bim");
  CHECK(map->objects()[0].type == "opal:Wall");
  CHECK(map->features()[0].points == std::vector<std::string>{"s/begin", "s/end"});
  CHECK(map->features()[0].representation == "s/representation");
  CHECK(map->unused().size() == 5);
  const auto again = SemanticMap::parse(map->to_json_ld().dump(), "again");
  CHECK(again->unused() == map->unused());
  CHECK(again->to_json_ld() == map->to_json_ld());
}

TEST_CASE("one geometry can be perceived by two sensors, and a pattern says for which it is") {
  const std::string map_text = R"({"@context": ["urn:opal:v1", {"acme": "https://acme.example/types#"}], "@graph": [
      {"@id": "c", "@type": "Column", "represented_by": [
        {"@type": "ObjectFeatureRepresentation", "perceivable_by": {"@id": "lidar"}, "represented_by": "k"},
        {"@type": "ObjectFeatureRepresentation", "perceivable_by": {"@id": "camera"}, "feature_type": "acme:Pillar", "geometry": "k"}]},
      {"@id": "k", "@type": "Circle", "radius_m": 0.3, "center": {"@type": "Point", "x": 1, "y": 1}},
      {"@id": "p", "@type": "FeaturePattern", "template": "acme:One", SENSOR "features": ["k"]}]})";
  const auto with = [&](const std::string& sensor) {
    std::string text = map_text;
    return text.replace(text.find("SENSOR"), 6, sensor);
  };
  CHECK_THROWS_WITH(SemanticMap::parse(with(""), "two"), Catch::Contains("expected a perceivable_by"));
  const auto map = SemanticMap::parse(with(R"("perceivable_by": {"@id": "camera"}, )"), "two");
  REQUIRE(map->features().size() == 2);
  CHECK(map->feature(map->patterns()[0].features[0]).type == "acme:Pillar");
  CHECK(SemanticMap::parse(map->to_json_ld().dump(), "two")->to_json_ld() == map->to_json_ld());
}

TEST_CASE("names have the prefix that the document defines, so that they are those that plugins register") {
  const std::string rest =
      R"("@id": "acme:k1", "@type": "acme:Kiosk", "represented_by": {"@type": "ObjectFeatureRepresentation",
      "feature_type": "acme:Edge", "represented_by": {"@id": "e", "@type": "Point", "x": 1, "y": 1}}})";
  const auto map =
      SemanticMap::parse(R"({"@context": ["urn:opal:v1", {"acme": "https://acme.example/types#"}], )" + rest, "kiosk");
  CHECK(map->objects()[0].id == "acme:k1");
  CHECK(map->objects()[0].type == "acme:Kiosk");
  CHECK(map->features()[0].type == "acme:Edge");
  CHECK(map->to_json_ld()["@context"][1]["acme"] == "https://acme.example/types#");
  CHECK_THROWS_WITH(SemanticMap::parse(R"({"@context": "urn:opal:v1", )" + rest, "kiosk"),
                    Catch::Contains("a @type that stands for no IRI, acme:Kiosk: @context does not define"));
  CHECK_THROWS_WITH(SemanticMap::parse(R"({"@context": "urn:opal:v1", "@type": "Wall", "lab:owner": "me"})", "w"),
                    Catch::Contains(R"(key lab:owner: @context does not define the prefix 'lab', expected ["u)"));
}

TEST_CASE("a representation without a sensor stays in the map and is not perceivable") {
  const auto map = SemanticMap::parse(
      R"({"@context": "urn:opal:v1", "@id": "c", "@type": "opal:Sign", "represented_by": {"@type": "ObjectFeatureRepresentation",
          "represented_by": {"@id": "k", "@type": "Point", "x": 1, "y": 1}}})",
      "off");
  CHECK(map->features()[0].sensor.empty());
  CHECK(SemanticMap::parse(map->to_json_ld().dump(), "off")->to_json_ld() == map->to_json_ld());
}

TEST_CASE("every word of the context is described, in the vocabulary file and in its document") {
  std::ifstream context_file(OPAL_SOURCE_DIR "/maps/context/opal.jsonld"),
      text_file(OPAL_SOURCE_DIR "/docs/vocabulary.md");
  const nlohmann::json vocabulary = nlohmann::json::parse(context_file);
  const std::string text{std::istreambuf_iterator<char>(text_file), {}};
  std::set<std::string> described;
  for (const auto& node : vocabulary.at("@graph")) described.insert(node.at("@id"));
  for (const auto& [term, definition] : vocabulary.at("@context").items()) {
    if (term.starts_with('@')) continue;
    CAPTURE(term);
    const std::string iri = definition.is_string() ? definition : definition.at("@id");
    const bool is_prefix = iri.ends_with('#') || iri.ends_with('/');
    CHECK(text.find("`" + term + (is_prefix ? ":`" : "`")) != std::string::npos);
    if (iri.starts_with("opal:")) CHECK(described.count(iri) == 1);
  }
}
