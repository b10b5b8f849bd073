#include <opal/testing/plugin_contract.hpp>

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
