#include <opal/common/strict_json.hpp>
#include <opal/plugin/testing/plugin_contract.hpp>
#include "jsonld/json_ld.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>

namespace fs = std::filesystem;

TEST_CASE("every plugin of this tree keeps the contracts") {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(OPAL_PLUGIN_DIR))
    if (entry.path().extension() == ".so") files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  REQUIRE_FALSE(files.empty());
  for (const std::string& file : files) {
    DYNAMIC_SECTION(fs::path(file).filename().string()) {
      for (const std::string& violation : opal::testing::plugin_violations(file)) FAIL_CHECK(violation);
    }
  }
}

TEST_CASE("every plugin description of this tree is JSON-LD of Opal's vocabulary alone") {
  opal::json_ld::Options options;
  options.contexts["urn:opal:v1"] = opal::read_json(OPAL_SOURCE_DIR "/maps/context/opal.jsonld");
  options.reject_unknown_terms = true;
  for (const auto& entry : fs::directory_iterator(OPAL_PLUGIN_DIR)) {
    if (entry.path().extension() != ".jsonld") continue;
    CAPTURE(entry.path());
    CHECK_NOTHROW(opal::json_ld::expand(opal::read_json(entry.path()), options));
  }
}
