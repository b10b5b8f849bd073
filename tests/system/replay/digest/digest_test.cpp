#include "digested_drives.hpp"

#include "tests/system/replay/golden_file.hpp"

#include <catch2/catch.hpp>

using nlohmann::ordered_json;

// All that is said of some short drives, field by field, is as it was when somebody last looked at it. It tells that an
// answer changed, not which one is right.

namespace {

std::string one_field_a_line(const ordered_json& digest) {
  std::string text, before = "{\n";
  for (const auto& [field, sums] : digest.items()) {
    text += before + ordered_json(field).dump() + ": " + sums.dump();
    before = ",\n";
  }
  return text + "\n}\n";
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
  const auto differences =
      found.differences_from(golden_file("digest/golden/" + drive.name + ".json", one_field_a_line(found.json())));
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
