// Reading overlay documents: strictly, and with messages that name the place.
#include "room.hpp"

#include "tests/kit/refusal.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

namespace {

using namespace opal::test;
using Catch::Contains;
using Catch::StartsWith;

std::string refused(const std::string& changes, const std::string& nodes = "") {
  return opal::refused_with<opal::MapError>([&] { overlay(changes, nodes); });
}

}  // namespace

TEST_CASE("an overlay is a document with changes") {
  const opal::MapOverlay read = opal::parse_overlay(R"({"@context": "urn:opal:v1", "@type": "MapOverlay", "name": "May",
    "because": "survey", "if_missing": "report", "changes": [
      {"@type": "MapChange", "target": "corner-2", "x": 8.1, "was": {"x": 8}},
      {"target": "face-1", "not_perceivable_by": "PlanarLidar2D", "because": "glass", "if_missing": "refuse"}]})",
                                                    "may.jsonld");
  CHECK(read.name == "May");
  REQUIRE(read.changes.size() == 2);
  CHECK(read.changes[0].target == "corner-2");
  CHECK(read.changes[0].numbers.at("x") == 8.1);
  CHECK(read.changes[0].was.at("x") == 8);
  CHECK(read.changes[0].because == "survey");
  CHECK(read.changes[0].report_if_missing);
  CHECK(read.changes[0].place == "may.jsonld: /changes/0");
  CHECK(read.changes[1].not_perceivable_by == std::vector<std::string>{"PlanarLidar2D"});
  CHECK(read.changes[1].because == "glass");
  CHECK_FALSE(read.changes[1].report_if_missing);
}

TEST_CASE("faults of an overlay document are errors that name the place") {
  CHECK_THAT(refused(R"({"target": "a"})"),
             StartsWith("room.overlay.jsonld: /@graph/0/changes/0: ") && Contains("changes nothing"));
  CHECK_THAT(refused(R"({"x": 1})"), Contains("has no target"));
  CHECK_THAT(refused(R"({"target": "a", "xx": 1})"), Contains("/changes/0/xx: unknown term"));
  CHECK_THAT(refused(R"({"target": "a", "x": "far"})"), Contains("expected a number"));
  CHECK_THAT(refused(R"({"target": "a", "begin": "b"})"),
             Contains("has begin, which means nothing there; expected target"));
  CHECK_THAT(refused(R"({"target": "a", "x": 1, "if_missing": "shrug"})"),
             Contains("expected \"refuse\" or \"report\""));
  CHECK_THAT(refused(R"({"target": "a", "x": 1, "was": {"y": 1}})"), Contains("expected only what the change sets"));
  CHECK_THAT(refused(R"({"target": "a", "x": 1, "@type": "Wall"})"), Contains("no MapChange"));
  CHECK_THAT(refused("", R"({"@type": "MapChange", "target": "a", "x": 1})"), Contains("belongs to no MapOverlay"));
  CHECK_THAT(refused("", R"({"@type": "MapOverlay"})"), Contains("a second MapOverlay"));
  CHECK_THAT(refused("", R"({"@type": "SemanticMap", "name": "a"})"), Contains("a SemanticMap, expected objects"));
  CHECK_THAT(
      refused("", R"({"@id": "p", "@type": "FeaturePattern", "template": "opal:ColumnPair", "features": ["a"]})"),
      Contains("a FeaturePattern, expected objects"));
  CHECK_THROWS_WITH(opal::parse_overlay(R"({"@context": "urn:opal:v1", "@id": "w", "@type": "Wall"})", "w.jsonld"),
                    Contains("w.jsonld: the document holds no MapOverlay"));
  CHECK_THROWS_AS(opal::parse_overlay("{", "w.jsonld"), opal::MapError);
  CHECK_THROWS_AS(opal::read_overlay("/nowhere.jsonld"), opal::MapError);
}

TEST_CASE("an overlay is no map") {
  CHECK_THROWS_WITH(opal::SemanticMap::parse(R"({"@context": "urn:opal:v1", "@type": "MapOverlay"})", "o.jsonld"),
                    Contains("a MapOverlay, expected a map"));
}
