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
  return options.value("specVersion", "") == "json-ld-1.0" || options.value("processingMode", "") == "json-ld-1.0";
}

Options options_of(const Json& test, const std::map<std::string, Json>& documents) {
  const Json given = test.value("option", Json::object());
  Options options;
  options.base = given.value("base", kBase + test["input"].get<std::string>());
  options.contexts = documents;
  if (given.contains("expandContext"))
    options.expand_context = documents.at(kBase + given["expandContext"].get<std::string>());
  return options;
}

using Algorithm = std::function<Json(const Json&, const Options&)>;

Outcome run(const Json& test, const std::map<std::string, Json>& documents, const Algorithm& algorithm,
            std::string& explanation) {
  if (is_of_json_ld_1_0(test)) return Outcome::kNotOurs;
  const std::string wanted_code = test.value("expectErrorCode", "");
  Json found;
  try {
    found = algorithm(opal::read_json((kSuite / test["input"].get<std::string>()).string()), options_of(test, documents));
  } catch (const JsonLdError& error) {
    explanation = std::string("    error: ") + error.what() + "\n";
    if (error.code() == wanted_code) return Outcome::kPassed;
    return error.code().rfind("unsupported", 0) == 0 ? Outcome::kRefused : Outcome::kFailed;
  }
  explanation = "    found: " + found.dump() + "\n";
  if (!wanted_code.empty()) return Outcome::kFailed;
  const Json expected = opal::read_json((kSuite / test["expect"].get<std::string>()).string());
  if (opal::test::same_document(expected, found)) return Outcome::kPassed;
  explanation = opal::test::difference(expected, found);
  return Outcome::kFailed;
}

Tally run_suite(const std::string& name, const Algorithm& algorithm) {
  const auto documents = documents_by_iri(name);
  const Json manifest = opal::read_json((kSuite / (name + "-manifest.jsonld")).string());
  const Json core_ids = opal::read_json((kSuite / ("core_" + name + "_ids.json")).string());
  const auto core = core_ids.get<std::set<std::string>>();
  Tally tally;
  for (const Json& test : manifest["sequence"]) {
    const std::string id = test["@id"].get<std::string>().substr(2);
    std::string explanation;
    const Outcome outcome = run(test, documents, algorithm, explanation);
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

}  // namespace

TEST_CASE("expansion passes the W3C JSON-LD 1.1 suite") { check_suite("expand", opal::json_ld::expand); }

TEST_CASE("flattening passes the W3C JSON-LD 1.1 suite") { check_suite("flatten", opal::json_ld::flatten); }
