// Asking maps by frames: strictly, within limits, and with messages that say whose fault it is.
#include "map_tools/map_frame.hpp"

#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>
#include "tests/kit/refusal.hpp"

#include <catch2/catch.hpp>

namespace {

using Catch::Contains;
using Catch::StartsWith;
using json = nlohmann::json;
using opal::framed_map;

opal::NamedDocument room() {
  const std::string file = OPAL_SOURCE_DIR "/maps/example_room.jsonld";
  return {opal::read_json(file), file};
}

opal::NamedDocument frame(const std::string& text) { return {json::parse(text), "f.jsonld"}; }

std::string refusal(const opal::NamedDocument& map, const std::string& text,
                    const opal::json_ld::FrameOptions& options = {}) {
  return opal::refused_with<opal::MapError>([&] { framed_map(map, frame(text), options); });
}

/// A chain of nodes, each of which refers to the next so many times.
opal::NamedDocument chain(int length, int times) {
  json graph = json::array();
  for (int i = 0; i < length; ++i) {
    json next = json::array();
    for (int k = 0; k < times; ++k) next.push_back({{"urn:to", {{"@id", "urn:n" + std::to_string(i + 1)}}}});
    graph.push_back({{"@id", "urn:n" + std::to_string(i)}, {"urn:next", next}});
  }
  return {json{{"@graph", graph}}, "chain.jsonld"};
}

}  // namespace

TEST_CASE("a frame shows segments with the objects that they stand for") {
  const opal::NamedDocument shipped{opal::read_json(OPAL_SOURCE_DIR "/maps/frames/segments.jsonld"), "segments.jsonld"};
  const json framed = framed_map(room(), shipped);
  CHECK(opal::matches_in(framed) == 5);
  const json& east = framed["@graph"][0];
  CHECK(east["@id"] == "east_face");
  CHECK(east["begin"] == json({{"@id", "south_east"}, {"@type", "Point"}, {"x", 8.0}, {"y", 0.0}}));
  CHECK(east["represents"]["represents"] == json({{"@id", "east_wall"}, {"@type", "Wall"}}));
}

TEST_CASE("matches are counted") {
  CHECK(opal::matches_in(framed_map(room(), frame(R"({"@context": "urn:opal:v1", "@type": "Window"})"))) == 0);
  CHECK(opal::matches_in(framed_map(room(), frame(R"({"@context": "urn:opal:v1", "@id": "door"})"))) == 1);
  CHECK(opal::matches_in(framed_map(room(), frame(R"({"@context": "urn:opal:v1", "@type": "Column"})"))) == 2);
}

TEST_CASE("numbers of a map are matched as they are") {
  const auto ids = [](const std::string& text) { return framed_map(room(), frame(text)).value("@id", ""); };
  CHECK(ids(R"({"@context": "urn:opal:v1", "existence": 0.9, "@explicit": true})") == "column_2_rim");
  CHECK(ids(R"({"@context": "urn:opal:v1", "position_sigma_m": {}, "@explicit": true})") == "west_face");
}

TEST_CASE("faults name the frame or the map, and the place") {
  CHECK_THAT(refusal(room(), R"({"@context": "urn:opal:v1", "@type": "Wal"})"),
             StartsWith("f.jsonld: /@type: unknown term: \"Wal\""));
  CHECK_THAT(refusal(room(), R"({"@context": "urn:opal:v1", "begin": {"rdius_m": {}}})"),
             StartsWith("f.jsonld: /begin/rdius_m: unknown term"));
  CHECK_THAT(refusal(room(), R"({"@context": "urn:other"})"), StartsWith("f.jsonld: ") && Contains("none is fetched"));
  CHECK_THAT(refusal(room(), R"({"@context": "urn:opal:v1", "@embed": "@last"})"),
             StartsWith("f.jsonld: (root): invalid @embed value"));
  CHECK_THAT(refusal(room(), R"([])"), StartsWith("f.jsonld: (root): invalid frame"));
  CHECK_THAT(refusal(room(), R"({"@id": "_:b0"})"), StartsWith("f.jsonld: (root): invalid frame"));
  opal::NamedDocument map = room();
  map.content["@graph"].push_back({{"@id", "w"}, {"@type", "Wal"}});
  CHECK_THAT(refusal(map, R"({"@context": "urn:opal:v1"})"),
             StartsWith(map.name + ": /@graph/") && Contains("unknown term: \"Wal\""));
}

TEST_CASE("what is too deep or too much is refused, and can be asked otherwise") {
  CHECK_THAT(refusal(chain(300, 1), R"({"@id": "urn:n0"})"), Contains("nested too deeply"));
  CHECK(refusal(chain(300, 1), R"({"@id": "urn:n0", "@embed": "@never"})") == "accepted");
  CHECK(refusal(chain(30, 2), R"({"@id": "urn:n0"})") == "accepted");
  opal::json_ld::FrameOptions small;
  small.bytes = 1u << 20;
  CHECK_THAT(refusal(chain(30, 2), R"({"@id": "urn:n0", "@embed": "@always"})", small), Contains("too much to embed"));
}

TEST_CASE("nodes that refer to each other end") {
  const opal::NamedDocument circle{json::parse(R"({"@graph": [{"@id": "urn:a", "urn:to": {"@id": "urn:b"}},
                                                             {"@id": "urn:b", "urn:to": {"@id": "urn:a"}}]})"),
                                   "circle"};
  for (const char* embed : {"@once", "@always", "@never"})
    CHECK(opal::matches_in(framed_map(circle, frame(std::string(R"({"@embed": ")") + embed + "\"}"))) >= 1);
}
