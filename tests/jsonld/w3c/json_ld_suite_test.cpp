// Runs the W3C JSON-LD 1.1 test suites (https://w3c.github.io/json-ld-api/tests/): every test of them. What does not
// pass stands in docs/json_ld.md, with what happens instead.
#include "json_comparison.hpp"
#include "w3c_suite.hpp"

#include "jsonld/json_ld.hpp"

#include <catch2/catch.hpp>

#include <fstream>
#include <iostream>
#include <map>
#include <string>

namespace {

using Json = nlohmann::json;
using namespace opal::test;
using opal::json_ld::JsonLdError;
using opal::json_ld::Options;

/// The rows "| `expand #t0026` | name | outcome |" of the documentation that speak of a suite.
std::map<std::string, std::string> documented(const std::string& suite) {
  std::ifstream page(OPAL_SOURCE_DIR "/docs/json_ld.md");
  REQUIRE(page);
  std::map<std::string, std::string> rows;
  const std::string start = "| `" + suite + " ";
  for (std::string line; std::getline(page, line);) {
    if (line.rfind(start, 0) != 0) continue;
    const std::size_t id_end = line.find('`', 3), last = line.rfind(" |"), cell = line.rfind("| ", last);
    std::string told = line.substr(cell + 2, last - cell - 2);
    if (told.size() > 1 && told[0] == '`') told = told.substr(1, told.size() - 2);
    rows[line.substr(3, id_end - 3)] = told;
  }
  return rows;
}

void check_suite(const std::string& name, const W3cAlgorithm& algorithm) {
  if (!has_w3c_suite(name)) return;
  std::map<std::string, std::string> failing;
  std::string explanations;
  int tests = 0;
  for_each_case(name, [&](const W3cCase& test) {
    std::string explanation;
    const std::string result = outcome(test, algorithm, explanation);
    ++tests;
    if (result.empty()) return;
    failing[test.id] = result;
    explanations += "  " + test.id + " (" + test.test["name"].get<std::string>() + "): " + result + ", expected " +
                    test.test.value("expectErrorCode", "the document") + "\n" + explanation;
  });
  std::cout << name << ": " << tests - static_cast<int>(failing.size()) << " of " << tests << " tests pass\n";
  INFO("not passed:\n" << explanations);
  CHECK(failing == documented(name));
}

Json expanded(const W3cCase& test) { return opal::json_ld::expand(test.input, test.options); }

Json flattened(const W3cCase& test) {
  Json nodes = opal::json_ld::flatten(test.input, test.options);
  if (!test.test.contains("context")) return nodes;
  Options options = test.options;
  options.compact_arrays = test.option("compactArrays") != false;
  return opal::json_ld::compact(nodes, test.document("context"), options);
}

Json framed(const W3cCase& test) {
  const bool first_edition = test.option("processingMode") == "json-ld-1.0";
  opal::json_ld::FrameOptions options;
  options.omit_graph = test.option("omitGraph").is_boolean() ? test.option("omitGraph").get<bool>() : !first_edition;
  options.prune_blank_nodes = !first_edition;
  return opal::json_ld::frame(test.input, test.document("frame"), test.options, options);
}

void strip_pointers(Json& value) {
  if (value.is_object()) value.erase("@pointer");
  if (value.is_structured())
    for (Json& entry : value) strip_pointers(entry);
}

void check_pointers(const Json& expanded, const Json& source) {
  if (expanded.is_object() && expanded.contains("@pointer"))
    CHECK(source.contains(Json::json_pointer(expanded["@pointer"].get<std::string>())));
  if (expanded.is_structured())
    for (const Json& entry : expanded) check_pointers(entry, source);
}

/// Calls the check with every input of the suite that the algorithm accepts, and with what it made of it.
void for_each_accepted(const std::string& name, const W3cAlgorithm& algorithm,
                       const std::function<void(const W3cCase&, const Json& found)>& check) {
  if (!has_w3c_suite(name)) return;
  for_each_case(name, [&](const W3cCase& test) {
    if (is_of_json_ld_1_0(test.test) || expects_error(test.test)) return;
    INFO(test.id << " " << test.test["name"]);
    check(test, algorithm(test));
  });
}

void check_pointers_of_suite(const std::string& name, const W3cAlgorithm& algorithm) {
  for_each_accepted(name, algorithm, [&](const W3cCase& test, const Json& plain) {
    test.options.keep_pointers = true;
    Json found = algorithm(test);
    test.options.keep_pointers = false;
    check_pointers(found, test.input);
    strip_pointers(found);
    CHECK(found == plain);
  });
}

}  // namespace

TEST_CASE("expansion passes the W3C JSON-LD 1.1 suite") { check_suite("expand", expanded); }

TEST_CASE("flattening passes the W3C JSON-LD 1.1 suite") { check_suite("flatten", flattened); }

TEST_CASE("framing passes the W3C JSON-LD 1.1 suite") { check_suite("frame", framed); }

TEST_CASE("kept pointers lead into the source and change nothing else") {
  check_pointers_of_suite("expand", expanded);
  check_pointers_of_suite("flatten",
                          [](const W3cCase& test) { return opal::json_ld::flatten(test.input, test.options); });
}

TEST_CASE("rejecting unknown terms refuses a document or changes nothing") {
  for_each_accepted("expand", expanded, [](const W3cCase& test, const Json& plain) {
    test.options.reject_unknown_terms = true;
    Json found = plain;
    try {
      found = expanded(test);
    } catch (const JsonLdError&) {  // as good
    }
    test.options.reject_unknown_terms = false;
    CHECK(found == plain);
  });
}

TEST_CASE("expanding what is expanded already changes nothing") {
  for_each_accepted("expand", expanded, [](const W3cCase& test, const Json& plain) {
    if (plain.dump().find("\"@id\":null") != std::string::npos) return;  // an @id like "@ignoreMe" leads to this
    test.options.expand_context = nullptr;
    test.options.base = "";
    CHECK(same_document(opal::json_ld::expand(plain, test.options), plain));
  });
}

TEST_CASE("flattening what is flattened already changes nothing but labels") {
  for_each_accepted("flatten", expanded, [](const W3cCase& test, const Json&) {
    const Json plain = opal::json_ld::flatten(test.input, test.options);
    test.options.base = "";
    CHECK(same_document(opal::json_ld::flatten(plain, test.options), plain));
  });
}

TEST_CASE("compacting and expanding again changes nothing") {
  for_each_accepted("expand", expanded, [](const W3cCase& test, const Json& plain) {
    const Json context = test.input.is_object() ? test.input.value("@context", Json::object()) : Json::object();
    test.options.expand_context = nullptr;
    if (plain.dump().find("\"@id\":null") != std::string::npos) return;
    if (!same_document(opal::json_ld::expand(plain, test.options), plain)) return;  // "@base": null left names relative
    Json compacted;
    try {
      compacted = opal::json_ld::compact(plain, context, test.options);
    } catch (const JsonLdError& error) {
      CHECK(error.code() == "IRI confused with prefix");
      return;
    }
    INFO("compacted: " << compacted.dump());
    const Json again = opal::json_ld::expand(compacted, test.options);
    INFO(difference(plain, again));
    CHECK(same_document(again, plain));
  });
}
