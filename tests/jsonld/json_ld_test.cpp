#include "jsonld/json_ld.hpp"
#include <opal/common/strict_json.hpp>

#include <catch2/catch.hpp>

#include <chrono>
#include <string>

namespace {

using Catch::Matchers::Contains;
using nlohmann::json;
using opal::json_ld::expand;
using opal::json_ld::flatten;
using opal::json_ld::JsonLdError;
using opal::json_ld::Options;

json parsed(const std::string& text) { return opal::parse_json(text, "test"); }

struct Refusal {
  std::string code, pointer, message;
};

/// How the document is refused; fails the test if it is not.
Refusal refusal(const json& document, const Options& options = {}) {
  try {
    const json result = flatten(document, options);
    FAIL("accepted: " << document.dump().substr(0, 500) << " as " << result.dump().substr(0, 500));
  } catch (const JsonLdError& error) {
    return {error.code(), error.pointer(), error.what()};
  }
  return {};
}

Options strict() {
  Options options;
  options.reject_unknown_terms = true;
  options.reject_unknown_prefixes = true;
  return options;
}

Options keeping() {
  Options options;
  options.keep_pointers = true;
  return options;
}

json nested(int levels, const std::string& key) {
  json value = "end";
  for (int i = 0; i < levels; ++i) value = json{{key, std::move(value)}};
  return value;
}

std::string term(int number) { return std::string("t").append(std::to_string(number)); }

}  // namespace

TEST_CASE("kept pointers tell where nodes and values stood") {
  const json document = parsed(R"({
    "@context": {"@vocab": "urn:v:", "ref": {"@type": "@id"}},
    "@id": "urn:a",
    "name": "A",
    "many": [{"@id": "urn:b", "size": [1, 2]}, {"@list": ["x"]}],
    "ref": "urn:b"})");
  const json node = expand(document, keeping())[0];
  CHECK(node["@pointer"] == "");
  CHECK(node["urn:v:name"][0] == parsed(R"({"@value": "A", "@pointer": "/name"})"));
  CHECK(node["urn:v:many"][0]["@pointer"] == "/many/0");
  CHECK(node["urn:v:many"][0]["urn:v:size"][1]["@pointer"] == "/many/0/size/1");
  CHECK(node["urn:v:many"][1]["@list"][0]["@pointer"] == "/many/1/@list/0");
  CHECK_FALSE(node["urn:v:many"][1].contains("@pointer"));
  CHECK(node["urn:v:ref"][0] == parsed(R"({"@id": "urn:b", "@pointer": "/ref"})"));
}

TEST_CASE("a flattened node bears the place that defines it, its references their own") {
  const json document = parsed(R"({
    "@context": {"@vocab": "urn:v:"},
    "@graph": [
      {"@id": "urn:a", "near": {"@id": "urn:b"}},
      {"@id": "urn:b", "size": 1},
      {"@id": "urn:b", "size": [1, 2]}]})");
  const json nodes = flatten(document, keeping());
  REQUIRE(nodes.size() == 2);
  CHECK(nodes[0]["urn:v:near"][0] == parsed(R"({"@id": "urn:b", "@pointer": "/@graph/0/near"})"));
  CHECK(nodes[1]["@pointer"] == "/@graph/1");
  CHECK(nodes[1]["urn:v:size"] == parsed(R"([{"@value": 1, "@pointer": "/@graph/1/size"},
                                             {"@value": 2, "@pointer": "/@graph/2/size/1"}])"));
}

TEST_CASE("a pointer in the source is no way to forge one") {
  const json document = parsed(R"({"@pointer": "/elsewhere", "urn:name": "a"})");
  CHECK(expand(document, keeping())[0]["@pointer"] == "");
  CHECK_FALSE(expand(document)[0].contains("@pointer"));
  CHECK(refusal(document, strict()).pointer == "/@pointer");
}

TEST_CASE("what maps to no IRI is refused where asked") {
  const auto refused = [](const std::string& text) { return refusal(parsed(text), strict()); };
  const Refusal key = refused(R"({"@context": {"size": "urn:size"}, "@graph": [{"size": 1}, {"sise": 1}]})");
  CHECK(key.code == "unknown term");
  CHECK(key.pointer == "/@graph/1/sise");
  CHECK_THAT(key.message, Contains("/@graph/1/sise: unknown term: \"sise\""));

  CHECK(refused(R"({"@type": ["urn:a", "Wal"]})").pointer == "/@type/1");
  CHECK(refused(R"({"@context": {"state": {"@id": "urn:s", "@type": "@vocab"}}, "state": "opn"})").pointer == "/state");
  CHECK(refused(R"({"urn:a": {"@reverse": {"b": {"@id": "urn:c"}}}})").pointer == "/urn:a/@reverse/b");
  CHECK(refused(R"({"urn:a": {"@grph": []}})").pointer == "/urn:a/@grph");
  CHECK(refused(R"({"@context": {"@protect": true}})").pointer == "/@context/@protect");
  CHECK(refused(R"({"urn:a": {"@vocab": "urn:v:"}})").code == "misplaced keyword");
  CHECK(refused(R"({"@graph": ["urn:a"]})").code == "free-floating value");
  CHECK(refused(R"({"@id": "@here", "urn:a": 1})").pointer == "/@id");
}

TEST_CASE("a language without a text is refused, as a node has none") {
  CHECK(refusal(parsed(R"({"urn:p": {"@id": "urn:a", "@language": "en"}})")).pointer == "/urn:p");
  CHECK(refusal(parsed(R"({"urn:p": {"@type": "urn:t", "@direction": "rtl"}})")).code == "invalid value object");
}

TEST_CASE("a prefix that nobody defined is refused where asked") {
  const auto refused = [](const std::string& text) { return refusal(parsed(text), strict()); };
  CHECK(refused(R"({"@context": {"opal": "urn:opal:"}, "@type": "opl:Wall"})").code == "unknown prefix");
  CHECK(refused(R"({"opl:size": 1})").pointer == "/opl:size");
  CHECK_NOTHROW(
      flatten(parsed(R"({"@context": {"opal": "urn:opal:"}, "@type": ["opal:Wall", "urn:x:y", "http://x/y", "_:t"],
                                   "opal:size": 1, "https://example.org/p": 2, "urn:p": 3})"),
              strict()));
}

TEST_CASE("a term mapped to null on purpose is dropped, not refused") {
  const json document =
      parsed(R"({"@context": {"@vocab": "urn:v:", "comment": null}, "comment": "for people", "size": 1})");
  CHECK(expand(document, strict()) == parsed(R"([{"urn:v:size": [{"@value": 1}]}])"));
}

TEST_CASE("contexts come from the table and from nowhere else") {
  const json document = parsed(R"({"@context": "urn:c", "size": 1})");
  const Refusal unknown = refusal(document);
  CHECK(unknown.code == "loading remote context failed");
  CHECK(unknown.pointer == "/@context");
  CHECK_THAT(unknown.message, Contains("<urn:c>"));

  Options options;
  options.contexts["urn:c"] = parsed(R"({"@context": {"size": "urn:size"}})");
  CHECK(expand(document, options) == parsed(R"([{"urn:size": [{"@value": 1}]}])"));
  options.base = "http://example.org/maps/a.jsonld";
  options.contexts["http://example.org/maps/c"] = options.contexts["urn:c"];
  CHECK(expand(parsed(R"({"@context": "c", "size": 1})"), options) == parsed(R"([{"urn:size": [{"@value": 1}]}])"));
}

TEST_CASE("an error inside a context of the table names it") {
  Options options;
  options.contexts["urn:c"] = parsed(R"({"@context": {"size": {"@id": 7}}})");
  CHECK(refusal(parsed(R"({"@context": ["urn:c"]})"), options).pointer == "urn:c#/@context/size");
}

TEST_CASE("contexts that name each other end in an error") {
  Options options;
  options.contexts["urn:a"] = parsed(R"({"@context": "urn:a"})");
  options.contexts["urn:b"] = parsed(R"({"@context": ["urn:c", "urn:c"]})");
  options.contexts["urn:c"] = parsed(R"({"@context": ["urn:b", "urn:b"]})");
  options.contexts["urn:d"] = parsed(R"({"@context": {"@import": "urn:d"}})");
  CHECK(refusal(parsed(R"({"@context": "urn:a"})"), options).code == "context overflow");
  CHECK(refusal(parsed(R"({"@context": "urn:b"})"), options).code == "context overflow");
  CHECK(refusal(parsed(R"({"@context": "urn:d"})"), options).code == "invalid context entry");
}

TEST_CASE("contexts that branch at every level end in an error, soon") {
  Options options;
  for (int level = 0; level < 30; ++level) {
    const std::string next = "urn:" + std::to_string(level + 1);
    options.contexts["urn:" + std::to_string(level)] = {{"@context", {next, next}}};
  }
  options.contexts["urn:30"] = {{"@context", json::object()}};
  CHECK(refusal({{"@context", "urn:0"}}, options).code == "context overflow");
}

TEST_CASE("a scoped context may lead back to itself") {
  Options options = strict();
  options.contexts["urn:c"] = parsed(R"({"@context": {"part": {"@id": "urn:part", "@context": "urn:c"}}})");
  const json document = parsed(R"({"@context": "urn:c", "part": {"part": {"part": {"part": 1}}}})");
  CHECK(expand(document, options)[0]["urn:part"][0]["urn:part"][0].contains("urn:part"));
}

TEST_CASE("what is no context is refused") {
  for (const char* context : {"1", "true", "[[]]", "[1]", "\"\""}) {
    INFO(context);
    const std::string code = refusal(parsed(std::string(R"({"@context": )") + context + "}")).code;
    CHECK((code == "invalid local context" || code == "loading remote context failed"));
  }
  Options options;
  for (const char* document : {"null", "1", "[]", "{}", "\"x\""}) {
    INFO(document);
    options.contexts["urn:c"] = parsed(document);
    CHECK(refusal(parsed(R"({"@context": "urn:c"})"), options).code == "invalid remote context");
  }
}

TEST_CASE("deep documents are refused without overflowing the stack") {
  for (const char* key : {"urn:a", "@graph", "@reverse", "@set", "@included", "@list"}) {
    INFO(key);
    json wrapped{{"urn:p", nested(20000, key)}};
    CHECK_THROWS_AS(expand(wrapped), JsonLdError);
  }
  json arrays = 1;
  for (int i = 0; i < 20000; ++i) arrays = json::array({std::move(arrays)});
  const json deep{{"urn:p", std::move(arrays)}};
  CHECK(refusal(deep).code == "nested too deeply");
  CHECK_NOTHROW(flatten(nested(120, "urn:a")));
}

TEST_CASE("deep contexts are refused without overflowing the stack") {
  json context{{"t", "urn:t"}};
  for (int i = 0; i < 2000; ++i) context = json{{"t", {{"@id", "urn:t"}, {"@context", std::move(context)}}}};
  CHECK_THROWS_AS(expand({{"@context", std::move(context)}}), JsonLdError);
  json chain = json::object();
  for (int i = 0; i < 100000; ++i) chain[term(i)] = term(i + 1).append(":x");
  const json long_chain{{"@context", std::move(chain)}};
  CHECK(refusal(long_chain).code == "context overflow");
}

TEST_CASE("huge keys and values are ordinary") {
  const std::string large(1u << 20, 'x');
  const json document{{"@context", {{"@vocab", "urn:v:"}}}, {large, large}, {"@id", "urn:" + large}};
  CHECK(flatten(document)[0]["urn:v:" + large][0]["@value"] == large);
  CHECK_THROWS_AS(flatten({{large, 1}}, strict()), JsonLdError);
  CHECK_NOTHROW(flatten({{"@context", {{large, "urn:x"}, {"urn:" + large + "/", nullptr}}}, {large, 1}}));
}

TEST_CASE("many values of one property do not cost the square of their number") {
  json objects = json::array();
  for (int i = 0; i < 20000; ++i)
    objects.push_back({{"@id", "urn:o:" + std::to_string(i % 10000)}, {"urn:size", i % 3}});
  const auto start = std::chrono::steady_clock::now();
  const json nodes = flatten({{"@id", "urn:map"}, {"urn:objects", std::move(objects)}});
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(10));
  CHECK(nodes.size() == 10001);
  CHECK(nodes[0]["@id"] == "urn:map");
  CHECK(nodes[0]["urn:objects"].size() == 10000);
}

TEST_CASE("blank nodes get the same labels each time, whatever they were called") {
  const json document = parsed(R"({"urn:z": [{"urn:p": 1}, {"@id": "_:x", "urn:p": 2}], "urn:a": {"@id": "_:x"}})");
  const json nodes = flatten(document);
  CHECK(nodes == flatten(document));
  REQUIRE(nodes.size() == 3);
  CHECK(nodes[0]["@id"] == "_:b0");
  CHECK(nodes[0]["urn:a"][0]["@id"] == nodes[0]["urn:z"][1]["@id"]);
  CHECK(nodes[0]["urn:z"][0]["@id"] != nodes[0]["urn:z"][1]["@id"]);
}

TEST_CASE("lists keep their order and their repetitions") {
  const json document = parsed(R"({"@context": {"points": {"@id": "urn:points", "@container": "@list"}},
                                   "@id": "urn:a", "points": [[3, 1], [3, 1], [2]]})");
  const json list = flatten(document)[0]["urn:points"][0]["@list"];
  REQUIRE(list.size() == 3);
  CHECK(list[0] == list[1]);
  CHECK(list[0]["@list"][0]["@value"] == 3);
}

TEST_CASE("a graph whose name looks like a keyword is compacted as one without a name") {
  const auto document = [](const char* id) {
    return json{{"@context", {{"g", {{"@id", "urn:g"}, {"@container", {"@graph", "@id"}}}}}},
                {"g", {{"@none", {{"@id", id}, {"@graph", {{{"@id", "urn:x"}, {"urn:p", 1}}}}}}}}};
  };
  const auto compacted = [&](const char* id) {
    return opal::json_ld::compact(document(id), document(id)["@context"]).at("g");
  };
  CHECK(compacted("urn:n").contains("urn:n"));
  CHECK(compacted("@like").contains("@none"));
}

TEST_CASE("an id that a term's container or type gives a frame matches as one that is written out") {
  const json document = {
      {"@graph", {{{"@id", "urn:a"}, {"urn:p", {{"@id", "urn:b"}}}}, {{"@id", "urn:b"}, {"urn:q", 1}}}}};
  const auto framed = [&](const json& term, const json& value) {
    json definition = term;
    definition["@id"] = "urn:p";
    return opal::json_ld::frame(document, {{"@context", {{"p", definition}}}, {"p", value}}, {}, {}).dump();
  };
  CHECK(framed({{"@type", "@id"}}, "urn:b").find("urn:q") != std::string::npos);
  CHECK(framed({{"@type", "@id"}}, "urn:c").find("urn:q") == std::string::npos);
  CHECK(framed({{"@container", "@id"}}, {{"urn:b", json::object()}}).find("urn:q") != std::string::npos);
}

TEST_CASE("documents that are no objects expand to nothing") {
  for (const char* text : {"null", "1", "\"a\"", "[]", "[[], null, true]", "{}"}) {
    INFO(text);
    CHECK(expand(parsed(text)) == json::array());
    CHECK(flatten(parsed(text)) == json::array());
  }
}
