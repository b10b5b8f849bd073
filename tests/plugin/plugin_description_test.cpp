#include "tests/kit/refusal.hpp"
#include "tests/kit/temporary_folder.hpp"

#include <opal/plugin/plugin_description.hpp>

#include <catch2/catch.hpp>

#include <cstdlib>
#include <limits>

using nlohmann::json;
using opal::complete_options;
using opal::parse_plugin_description;
using opal::PluginDescription;
using opal::PluginError;
using opal::PluginKind;

namespace {

json good_document() {
  return json::parse(R"({
    "@context": "urn:opal:v1", "@type": "Plugin", "name": "lines", "version": "0.1.0",
    "types": [
      {"@id": "opal:LineDetector", "kind": "FeatureDetector", "description": "finds walls",
       "consumes": [], "produces": ["opal:Wall"],
       "options": [
         {"name": "min_points", "type": "integer", "default": 6, "minimum": 2, "maximum": 1000, "unit": "",
          "description": "points on a line"},
         {"name": "max_gap_m", "type": "number", "default": 1, "minimum": 0, "unit": "m", "description": "gap"},
         {"name": "merge", "type": "boolean", "default": true, "description": "joins collinear pieces"},
         {"name": "label", "type": "string", "default": "", "description": "free text"}]}]})");
}

PluginDescription parsed(const json& document) { return parse_plugin_description(document, "lines.jsonld"); }

std::string refusal(const json& document) {
  return opal::refused_with<PluginError>([&] { parsed(document); });
}

/// The good document with one value changed, or removed.
json changed(const std::string& pointer, const json& value) {
  json document = good_document();
  document[json::json_pointer(pointer)] = value;
  return document;
}
json without(const std::string& parent, const std::string& key) {
  json document = good_document();
  document[json::json_pointer(parent)].erase(key);
  return document;
}

std::string option_refusal(const json& options) {
  return opal::refused_with<PluginError>(
      [&] { complete_options("opal:LineDetector", parsed(good_document()).types.front().options, options); });
}

}  // namespace

TEST_CASE("a plugin description says what the plugin offers") {
  const PluginDescription description = parsed(good_document());
  CHECK(description.name == "lines");
  CHECK(description.version == "0.1.0");
  REQUIRE(description.types.size() == 1);
  const opal::DescribedType& type = description.types.front();
  CHECK(type.info.name == "opal:LineDetector");
  CHECK(type.info.consumes.empty());
  CHECK(type.info.produces == std::vector<std::string>{"opal:Wall"});
  CHECK(type.kind == PluginKind::feature_detector);
  REQUIRE(type.options.size() == 4);
  CHECK(type.options[0].default_value == 6);
  CHECK(type.options[0].maximum == 1000);
  CHECK(type.options[1].unit == "m");
  CHECK(type.options[1].maximum.is_null());
}

TEST_CASE("the context of a plugin description is Opal's, further prefixes may be added") {
  CHECK(refusal(changed("/@context", {"urn:opal:v1", {{"acme", "https://acme.example/"}}})) == "accepted");
  CHECK(refusal(changed("/@context", "https://schema.org")) ==
        "lines.jsonld: /@context: \"https://schema.org\", expected \"urn:opal:v1\", or an array that begins "
        "with it");
  CHECK(refusal(changed("/@context", {"urn:opal:v1", 3})) ==
        "lines.jsonld: /@context: [\"urn:opal:v1\",3], expected an object of prefixes after \"urn:opal:v1\"");
}

TEST_CASE("a plugin description with a missing or unknown key is refused at its place") {
  CHECK(refusal(without("", "version")) == "lines.jsonld: /: the key \"version\" is missing");
  CHECK(refusal(without("/types/0", "kind")) == "lines.jsonld: /types/0: the key \"kind\" is missing");
  CHECK(refusal(without("/types/0/options/1", "default")) ==
        "lines.jsonld: /types/0/options/1: the key \"default\" is missing");
  CHECK(refusal(changed("/types/0/options/1/minimun", 0)) ==
        "lines.jsonld: /types/0/options/1: unknown key \"minimun\", expected one of: name, type, default, "
        "description, minimum, maximum, unit");
}

TEST_CASE("a plugin description with a wrong value is refused with what was expected") {
  CHECK(refusal(json::array()) == "lines.jsonld: /: [], expected an object");
  CHECK(refusal(changed("/@type", "Map")) == "lines.jsonld: /@type: \"Map\", expected \"Plugin\"");
  CHECK(refusal(changed("/name", "two words")) == "lines.jsonld: /name: \"two words\", expected a word without spaces");
  CHECK(refusal(changed("/types", json::array())) == "lines.jsonld: /types: is empty, expected at least one type");
  CHECK(refusal(changed("/types/0/@id", "LineDetector")) ==
        "lines.jsonld: /types/0/@id: \"LineDetector\", expected a name with a prefix, such as "
        "\"acme:PostDetector\"");
  CHECK(refusal(changed("/types/0/kind", "Detector")) ==
        "lines.jsonld: /types/0/kind: \"Detector\", expected one of: FeatureDetector, PatternTemplate, "
        "HypothesisScorer, LogSource, MapImporter, ScanMatcher, MapStore");
  CHECK(refusal(changed("/types/0/produces", json::array())) ==
        "lines.jsonld: /types/0: a FeatureDetector must say in \"produces\" which feature types it finds");
  CHECK(refusal(changed("/types/0/options/0/type", "int")) ==
        "lines.jsonld: /types/0/options/0/type: \"int\", expected one of: boolean, integer, number, object, string");
}

TEST_CASE("names given twice in a plugin description are refused") {
  json twice = good_document();
  twice["types"].push_back(twice["types"][0]);
  CHECK(refusal(twice) == "lines.jsonld: /types/1/@id: is there twice");
  CHECK(refusal(changed("/types/0/options/1/name", "min_points")) ==
        "lines.jsonld: /types/0/options/1/name: is there twice");
}

TEST_CASE("defaults and bounds of a described option must fit each other") {
  CHECK(refusal(changed("/types/0/options/0/default", 1)) ==
        "lines.jsonld: /types/0/options/0/default: 1, expected an integer from 2 to 1000");
  CHECK(refusal(changed("/types/0/options/0/default", 2.5)) ==
        "lines.jsonld: /types/0/options/0/default: 2.5, expected an integer from 2 to 1000");
  CHECK(refusal(changed("/types/0/options/0/minimum", 2000)) ==
        "lines.jsonld: /types/0/options/0/maximum: 1000, expected at least the minimum, 2000");
  CHECK(refusal(changed("/types/0/options/0/minimum", 0.5)) ==
        "lines.jsonld: /types/0/options/0/minimum: 0.5, expected an integer");
  CHECK(refusal(changed("/types/0/options/2/minimum", 0)) ==
        "lines.jsonld: /types/0/options/2/minimum: only numbers and integers have bounds");
}

TEST_CASE("a long wrong value is shortened in the message") {
  const std::string message = refusal(changed("/types/0/kind", std::string(5000, 'x')));
  CHECK(message.size() < 300);
}

TEST_CASE("options are completed with the described defaults") {
  const auto described = parsed(good_document()).types.front().options;
  const json complete = complete_options("opal:LineDetector", described, {{"max_gap_m", 2}});
  CHECK(complete == json{{"min_points", 6}, {"max_gap_m", 2.0}, {"merge", true}, {"label", ""}});
  CHECK(complete["max_gap_m"].is_number_float());
  CHECK(complete_options("opal:LineDetector", described, nullptr).size() == 4);
}

TEST_CASE("a wrong option is refused by name, with what was found and what is expected") {
  CHECK(option_refusal({{"min_point", 6}}) ==
        "opal:LineDetector: option min_point: unknown, expected one of: min_points, max_gap_m, merge, label");
  CHECK(option_refusal({{"min_points", 1}}) ==
        "opal:LineDetector: option min_points: 1, expected an integer from 2 to 1000");
  CHECK(option_refusal({{"min_points", "6"}}) ==
        "opal:LineDetector: option min_points: \"6\", expected an integer from 2 to 1000");
  CHECK(option_refusal({{"max_gap_m", -1}}) == "opal:LineDetector: option max_gap_m: -1, expected a number >= 0 [m]");
  CHECK(option_refusal({{"max_gap_m", std::numeric_limits<double>::infinity()}}) ==
        "opal:LineDetector: option max_gap_m: null, expected a number >= 0 [m]");
  CHECK(option_refusal({{"merge", 1}}) == "opal:LineDetector: option merge: 1, expected true or false");
  CHECK(option_refusal(json::array()) == "opal:LineDetector: options: [], expected an object");
}

TEST_CASE("a plugin description file that is missing or no JSON is refused by name") {
  CHECK_THROWS_WITH(opal::read_plugin_description("/nowhere/lines.jsonld"),
                    "/nowhere/lines.jsonld: cannot be read; every plugin has its description beside it "
                    "(docs/write_a_plugin.md)");
}

TEST_CASE("a key that is there twice in a plugin description is refused") {
  const opal::TemporaryFile file("twice.jsonld", R"({"name": "a", "name": "b"})");
  CHECK_THROWS_WITH(opal::read_plugin_description(file.path()),
                    Catch::StartsWith(file.path()) && Catch::Contains("name"));
}

TEST_CASE("an object option holds texts, and an option whose default is null may stay without a value") {
  json document = good_document();
  document["types"][0]["options"].push_back(
      {{"name", "classes"}, {"type", "object"}, {"default", json::object()}, {"description", "classes"}});
  document["types"][0]["options"].push_back(
      {{"name", "z_m"}, {"type", "number"}, {"default", nullptr}, {"unit", "m"}, {"description", "height"}});
  const auto described = parsed(document).types.front().options;
  const json complete = complete_options("t", described, {{"classes", {{"IfcStair", "leave_out"}}}});
  CHECK(complete["classes"] == json{{"IfcStair", "leave_out"}});
  CHECK(complete["z_m"].is_null());
  CHECK(complete_options("t", described, {{"z_m", 3}})["z_m"] == 3.0);
  CHECK_THROWS_WITH(complete_options("t", described, {{"classes", {{"IfcStair", 3}}}}),
                    "t: option classes: {\"IfcStair\":3}, expected an object of texts");
  CHECK_THROWS_WITH(complete_options("t", described, {{"z_m", "3"}}),
                    "t: option z_m: \"3\", expected a number, or null [m]");
}

TEST_CASE("options are read from words as their description says") {
  json document = good_document();
  document["types"][0]["options"].push_back(
      {{"name", "layers"}, {"type", "object"}, {"default", json::object()}, {"description", "layers"}});
  const auto described = parsed(document).types.front().options;
  CHECK(opal::parse_options("t", described, {"min_points=7", "label=7", "merge=false", "layers.A=1.x=opal:Wall"}) ==
        json{{"min_points", 7}, {"label", "7"}, {"merge", false}, {"layers", {{"A=1.x", "opal:Wall"}}}});
  CHECK_THROWS_WITH(opal::parse_options("t", described, {"merge"}), "t: \"merge\", expected NAME=VALUE");
  CHECK_THROWS_WITH(opal::parse_options("t", described, {"min_points=many"}),
                    "t: option min_points: \"many\", expected an integer from 2 to 1000");
  CHECK_THROWS_WITH(opal::parse_options("t", described, {"label.x=3"}),
                    "t: option label: has no entries, expected label=VALUE");
}
