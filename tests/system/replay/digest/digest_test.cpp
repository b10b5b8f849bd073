#include "digested_drives.hpp"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <fstream>

using nlohmann::ordered_json;

// All that is said of some short drives, field by field, is as it was when somebody last looked at it. It tells that an
// answer changed, not which one is right.

namespace {

std::string golden_path(const std::string& drive) {
  return std::string(OPAL_SOURCE_DIR) + "/tests/system/replay/digest/golden/" + drive + ".json";
}

/// One field a line.
void write(const ordered_json& digest, const std::string& path) {
  std::ofstream file(path);
  const char* before = "{\n";
  for (const auto& [field, sums] : digest.items()) {
    file << before << ordered_json(field).dump() << ": " << sums.dump();
    before = ",\n";
  }
  file << "\n}\n";
}

/// The first ones.
std::string lines_of(const std::vector<std::string>& lines) {
  std::string text = std::to_string(lines.size()) + " fields differ";
  for (std::size_t k = 0; k < std::min<std::size_t>(lines.size(), 12); ++k) text += "\n  " + lines[k];
  return text;
}

}  // namespace

TEST_CASE("all that is said of a short drive is as in its golden file") {
  const DigestedDrive& drive = GENERATE(from_range(digested_drives()));
  CAPTURE(drive.name);
  const RunDigest found = drive.run();
  if (std::getenv("OPAL_UPDATE_GOLDEN")) {
    write(found.json(), golden_path(drive.name));
    WARN("golden file rewritten: " << golden_path(drive.name));
  }
  std::ifstream file(golden_path(drive.name));
  REQUIRE(file);
  const auto differences = found.differences_from(ordered_json::parse(file));
  INFO(lines_of(differences));
  CHECK(differences.empty());
}

TEST_CASE("a digest notices another number, another order, another text, and a field that comes or goes") {
  const auto of = [](const std::vector<ordered_json>& events) {
    RunDigest digest;
    for (const ordered_json& event : events) digest.take("e", event);
    return digest;
  };
  const std::vector<ordered_json> events{{{"x", {1.5, 2}}, {"why", "behind by 3.5 nat"}},
                                         {{"x", {3, 4}}, {"why", "gone"}}};
  const RunDigest digest = of(events);
  CHECK(digest.differences_from(digest.json()).empty());
  CHECK(digest.json()["e.why 'behind by # nat'"] == ordered_json{1, 3.5, 3.5});
  for (const std::vector<ordered_json>& other :
       std::vector<std::vector<ordered_json>>{{{{"x", {1.5, 2.01}}, {"why", "behind by 3.5 nat"}}, events[1]},
                                              {{{"x", {2, 1.5}}, {"why", "behind by 3.5 nat"}}, events[1]},
                                              {{{"x", {1.5, 2}}, {"why", "behind by 5.6 nat"}}, events[1]},
                                              {{{"x", {1.5, 2}}, {"why", "behind of 3.5 nat"}}, events[1]},
                                              {events[0]},
                                              {events[0], events[1], {{"y", false}}}})
    CHECK_FALSE(of(other).differences_from(digest.json()).empty());
}
