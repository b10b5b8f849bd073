#pragma once

#include "jsonld/json_ld.hpp"

#include <nlohmann/json.hpp>

#include <functional>
#include <map>
#include <string>

namespace opal::test {

/// What one test of the W3C suite gives: the input, the test with its options, and the options made of them.
struct W3cCase {
  std::string id;  ///< "expand #t0001"
  const nlohmann::json& test;
  const nlohmann::json& input;
  json_ld::Options& options;

  nlohmann::json option(const char* name) const;
  /// The document that an entry of the test names ("frame", "context"). @throws opal::Error if there is none.
  nlohmann::json document(const char* entry) const;
};

using W3cAlgorithm = std::function<nlohmann::json(const W3cCase&)>;
using W3cCheck = std::function<void(const W3cCase&)>;

/// False, with a message, where the suite is absent: it lies outside the repository.
bool has_w3c_suite(const std::string& name);
/// Calls the check with every test of a suite, in the order of its manifest.
void for_each_case(const std::string& name, const W3cCheck& check);

/// "" if the test passes; else the code of the error, or "another document".
std::string outcome(const W3cCase& test, const W3cAlgorithm& algorithm, std::string& explanation);

/// Asks for the rules of JSON-LD 1.0, which 1.1 gave up.
bool is_of_json_ld_1_0(const nlohmann::json& test);
bool expects_error(const nlohmann::json& test);

}  // namespace opal::test
