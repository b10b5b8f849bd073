#include "w3c_suite.hpp"

#include "json_comparison.hpp"

#include <opal/common/strict_json.hpp>

#include <catch2/catch.hpp>

#include <filesystem>

namespace opal::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using json_ld::JsonLdError;

const fs::path kSuite = fs::path(OPAL_SOURCE_DIR) / "../shared/data/w3c-json-ld";
const std::string kBase = "https://w3c.github.io/json-ld-api/tests/";

/// Every document of the suite by its IRI, as a server would hand it out; one is no JSON, and no test uses it.
std::map<std::string, Json> documents_by_iri(const std::string& folder) {
  std::map<std::string, Json> documents;
  for (const auto& entry : fs::recursive_directory_iterator(kSuite / folder)) {
    if (entry.path().extension() != ".jsonld" || entry.path().filename() == "eo02-frame.jsonld") continue;
    documents[kBase + fs::relative(entry.path(), kSuite).string()] = read_json(entry.path().string());
  }
  return documents;
}

/// What the test asks for, beside the contexts, which all tests share.
void set_options(json_ld::Options& options, const Json& test) {
  const Json given = test.value("option", Json::object());
  options.base = given.value("base", kBase + test["input"].get<std::string>());
  options.expand_context = nullptr;
  if (given.contains("expandContext"))
    options.expand_context = options.contexts.at(kBase + given["expandContext"].get<std::string>());
}

}  // namespace

Json W3cCase::option(const char* name) const { return test.value("option", Json::object()).value(name, Json()); }

Json W3cCase::document(const char* entry) const {
  return read_json((kSuite / test.at(entry).get<std::string>()).string());
}

bool has_w3c_suite(const std::string& name) {
  const bool found = fs::exists(kSuite / (name + "-manifest.jsonld"));
  if (!found) WARN("skipped: no W3C test suite at " << kSuite);
  return found;
}

void for_each_case(const std::string& name, const W3cCheck& check) {
  json_ld::Options options;
  options.contexts = documents_by_iri(name);
  const Json manifest = read_json((kSuite / (name + "-manifest.jsonld")).string());
  for (const Json& test : manifest["sequence"]) {
    set_options(options, test);
    const Json& input = options.contexts.at(kBase + test["input"].get<std::string>());
    check({name + " " + test["@id"].get<std::string>(), test, input, options});
  }
}

bool is_of_json_ld_1_0(const Json& test) {
  const Json options = test.value("option", Json::object());
  return options.value("specVersion", "") == "json-ld-1.0" || options.value("processingMode", "") == "json-ld-1.0";
}

bool expects_error(const Json& test) { return test.contains("expectErrorCode"); }

std::string outcome(const W3cCase& test, const W3cAlgorithm& algorithm, std::string& explanation) {
  const std::string wanted_code = test.test.value("expectErrorCode", "");
  try {
    const Json found = algorithm(test);
    explanation = "    found: " + found.dump().substr(0, 2000) + "\n";
    if (!wanted_code.empty()) return "another document";
    const Json expected = test.document("expect");
    if (same_document(expected, found)) return "";
    explanation = difference(expected, found);
    return "another document";
  } catch (const JsonLdError& error) {
    explanation = std::string("    error: ") + error.what() + "\n";
    return error.code() == wanted_code ? "" : error.code();
  }
}

}  // namespace opal::test
