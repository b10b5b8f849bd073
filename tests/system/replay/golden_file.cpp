#include "golden_file.hpp"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <fstream>

nlohmann::ordered_json golden_file(const std::string& name, const std::string& found) {
  const std::string path = OPAL_SOURCE_DIR "/tests/system/replay/" + name;
  if (std::getenv("OPAL_UPDATE_GOLDEN")) {
    std::ofstream(path) << found;
    WARN("golden file rewritten: " << path);
  }
  std::ifstream file(path);
  REQUIRE(file);
  return nlohmann::ordered_json::parse(file);
}
