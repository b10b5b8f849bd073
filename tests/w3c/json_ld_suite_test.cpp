// Runs the W3C JSON-LD 1.1 test suite (https://w3c.github.io/json-ld-api/tests/): expansion and flattening.
#include "json_comparison.hpp"

#include <opal/json_ld.hpp>
#include <opal/strict_json.hpp>

#include <catch2/catch.hpp>

#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <set>
#include <string>

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using opal::json_ld::JsonLdError;
using opal::json_ld::Options;

const fs::path kSuite = fs::path(OPAL_SOURCE_DIR) / "../shared/data/w3c-json-ld";
const std::string kBase = "https://w3c.github.io/json-ld-api/tests/";

enum class Outcome { kPassed, kFailed, kRefused, kNotOurs };

struct Tally {
  std::map<Outcome, int> core, others;
  std::string failures;
};

/// Every document of the suite by its IRI, as a server would hand it out.
std::map<std::string, Json> documents_by_iri(const std::string& folder) {
  std::map<std::string, Json> documents;
  for (const auto& entry : fs::recursive_directory_iterator(kSuite / folder))
    if (entry.path().extension() == ".jsonld")
      documents[kBase + fs::relative(entry.path(), kSuite).string()] = opal::read_json(entry.path().string());
  return documents;
}

bool is_of_json_ld_1_0(const Json& test) {
  const Json options = test.value("option", Json::object());
  return options.value("specVersion", "") == "json-ld-1.0" ||
         options.value("processingMode", "") == "json-ld-1.0";
}

/// What the test asks for, beside the contexts, which all tests share.
void set_options(Options& options, const Json& test) {
  const Json given = test.value("option", Json::object());
  options.base = given.value("base", kBase + test["input"].get<std::string>());
  options.expand_context = nullptr;
  if (given.contains("expandContext"))
    options.expand_context = options.contexts.at(kBase + given["expandContext"].get<std::string>());
}

using Algorithm = std::function<Json(const Json&, const Options&)>;

Outcome run(const Json& test, Options& options, const Algorithm& algorithm, std::string& explanation) {
  if (is_of_json_ld_1_0(test)) return Outcome::kNotOurs;
  set_options(options, test);
  const std::string wanted_code = test.value("expectErrorCode", "");
  Json found;
  try {
    found = algorithm(opal::read_json((kSuite / test["input"].get<std::string>()).string()), options);
  } catch (const JsonLdError& error) {
    explanation = std::string("    error: ") + error.what() + "\n";
    if (error.code() == wanted_code) return Outcome::kPassed;
    return error.code().rfind("unsupported", 0) == 0 ? Outcome::kRefused : Outcome::kFailed;
  }
  explanation = "    found: " + found.dump() + "\n";
  if (!wanted_code.empty()) return Outcome::kFailed;
  Json expected = opal::read_json((kSuite / test["expect"].get<std::string>()).string());
  // Compaction is not ours: a compacted expectation is brought back to what it says.
  if (test.contains("context")) expected = algorithm(expected, options);
  if (opal::test::same_document(expected, found)) return Outcome::kPassed;
  explanation = opal::test::difference(expected, found);
  return Outcome::kFailed;
}

Tally run_suite(const std::string& name, const Algorithm& algorithm) {
  Options options;
  options.contexts = documents_by_iri(name);
  const Json manifest = opal::read_json((kSuite / (name + "-manifest.jsonld")).string());
  const Json core_ids = opal::read_json((kSuite / ("core_" + name + "_ids.json")).string());
  const auto core = core_ids.get<std::set<std::string>>();
  Tally tally;
  for (const Json& test : manifest["sequence"]) {
    const std::string id = test["@id"].get<std::string>().substr(2);
    std::string explanation;
    const Outcome outcome = run(test, options, algorithm, explanation);
    const bool is_core = core.count(id) || test.contains("expectErrorCode");
    ++(is_core ? tally.core : tally.others)[outcome];
    if (outcome == Outcome::kFailed || (core.count(id) && outcome != Outcome::kPassed))
      tally.failures += "  " + id + " (" + test["name"].get<std::string>() + "), expected " +
                        test.value("expectErrorCode", "the document") + "\n" + explanation;
  }
  return tally;
}

std::string to_text(std::map<Outcome, int> counts) {
  return std::to_string(counts[Outcome::kPassed]) + " passed, " + std::to_string(counts[Outcome::kFailed]) +
         " failed, " + std::to_string(counts[Outcome::kRefused]) + " refused as unsupported, " +
         std::to_string(counts[Outcome::kNotOurs]) + " of JSON-LD 1.0 not run";
}

void check_suite(const std::string& name, const Algorithm& algorithm) {
  if (!fs::exists(kSuite / (name + "-manifest.jsonld"))) {
    WARN("skipped: no W3C test suite at " << kSuite);
    return;
  }
  const Tally tally = run_suite(name, algorithm);
  std::cout << name << ", core and negative: " << to_text(tally.core) << "\n"
            << name << ", others: " << to_text(tally.others) << "\n";
  INFO("failed:\n" << tally.failures);
  CHECK(tally.failures.empty());
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

/// Runs every input of the suite that the algorithm accepts with and without some option.
void for_each_accepted(const std::string& name, const Algorithm& algorithm,
                       const std::function<void(const Json& input, Options&, const Json& found)>& check) {
  if (!fs::exists(kSuite / (name + "-manifest.jsonld"))) {
    WARN("skipped: no W3C test suite at " << kSuite);
    return;
  }
  Options options;
  options.contexts = documents_by_iri(name);
  const Json manifest = opal::read_json((kSuite / (name + "-manifest.jsonld")).string());
  for (const Json& test : manifest["sequence"]) {
    if (is_of_json_ld_1_0(test) || test.contains("expectErrorCode")) continue;
    INFO(name << " " << test["@id"] << " " << test["name"]);
    set_options(options, test);
    const Json& input = options.contexts.at(kBase + test["input"].get<std::string>());
    check(input, options, algorithm(input, options));
  }
}

void check_pointers_of_suite(const std::string& name, const Algorithm& algorithm) {
  for_each_accepted(name, algorithm, [&](const Json& input, Options& options, const Json& plain) {
    options.keep_pointers = true;
    Json found = algorithm(input, options);
    options.keep_pointers = false;
    check_pointers(found, input);
    strip_pointers(found);
    CHECK(found == plain);
  });
}

}  // namespace

TEST_CASE("expansion passes the W3C JSON-LD 1.1 suite") { check_suite("expand", opal::json_ld::expand); }

TEST_CASE("flattening passes the W3C JSON-LD 1.1 suite") { check_suite("flatten", opal::json_ld::flatten); }

TEST_CASE("kept pointers lead into the source and change nothing else") {
  check_pointers_of_suite("expand", opal::json_ld::expand);
  check_pointers_of_suite("flatten", opal::json_ld::flatten);
}

TEST_CASE("rejecting unknown terms refuses a document or changes nothing") {
  for_each_accepted("expand", opal::json_ld::expand,
                    [](const Json& input, Options& options, const Json& plain) {
                      options.reject_unknown_terms = true;
                      Json found = plain;
                      try {
                        found = opal::json_ld::expand(input, options);
                      } catch (const JsonLdError&) {  // as good
                      }
                      options.reject_unknown_terms = false;
                      CHECK(found == plain);
                    });
}

TEST_CASE("expanding what is expanded already changes nothing") {
  for_each_accepted("expand", opal::json_ld::expand, [](const Json&, Options& options, const Json& plain) {
    if (plain.dump().find("\"@id\":null") != std::string::npos)
      return;  // an @id like "@ignoreMe" leads to this
    options.expand_context = nullptr;
    options.base = "";
    CHECK(opal::test::same_document(opal::json_ld::expand(plain, options), plain));
  });
}

TEST_CASE("flattening what is flattened already changes nothing but labels") {
  for_each_accepted("flatten", opal::json_ld::flatten, [](const Json&, Options& options, const Json& plain) {
    options.base = "";
    CHECK(opal::test::same_document(opal::json_ld::flatten(plain, options), plain));
  });
}
