#include "tests/kit/temporary_folder.hpp"

#include <opal/common/error.hpp>
#include "evaluation/site.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace opal;

const std::string kInfo =
    R"({"site": "hall", "laser": {"n_beams": 181, "angle_min_deg": -90.0, "angle_increment_deg": 1.0,
  "no_return_at_or_above_m": 80.0, "offset_x_m": 0.78, "offset_y_m": -0.1, "offset_theta": 0.5}})";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

/// What the message of the error is after the file's name.
template <class Read>
std::string complaint(const Read& read, const std::string& content) {
  const TemporaryFile file("refused.json", content);
  try {
    read(file.path());
  } catch (const Error& error) {
    const std::string message = error.what();
    CHECK(message.substr(0, file.path().size()) == file.path());
    return message.substr(file.path().size());
  }
  return "accepted";
}

}  // namespace

TEST_CASE("a site's laser is read in radians and metres") {
  const TemporaryFile file("info.json", kInfo);
  const LaserModel laser = read_site_laser(file.path());
  CHECK(laser.beams == 181);
  CHECK(laser.angle_min_rad == Approx(-std::numbers::pi / 2));
  CHECK(laser.angle_increment_rad == Approx(std::numbers::pi / 180));
  CHECK(laser.no_return_m == 80);
  CHECK(laser.range_max_m == 30);
  CHECK(laser.T_base_laser.x() == 0.78);
  CHECK(laser.T_base_laser.y() == -0.1);
  CHECK(laser.T_base_laser.heading_rad() == 0.5);
}

TEST_CASE("a laser that sees less far than 30 m is used up to where it sees") {
  const TemporaryFile file("near.json", replaced(kInfo, "80.0", "8.0"));
  CHECK(read_site_laser(file.path()).range_max_m == 8);
  const TemporaryFile stated("stated.json", replaced(kInfo, "80.0", "80.0, \"range_max_m\": 5.6"));
  CHECK(read_site_laser(stated.path()).range_max_m == 5.6);
  CHECK(read_site_laser(stated.path()).no_return_m == 80);
}

TEST_CASE("a wrong description of a laser is refused with its place") {
  const auto told = [](const std::string& from, const std::string& to) {
    return complaint(read_site_laser, replaced(kInfo, from, to));
  };
  CHECK(told("\"n_beams\": 181, ", "") == ": /laser/n_beams: missing, expected an integer");
  CHECK(told("181", "0") == ": /laser/n_beams: 0, expected an integer in [1, 100000]");
  CHECK(told("181", "181.5") == ": /laser/n_beams: 181.5, expected an integer in [1, 100000]");
  CHECK(told("181", "99999999999") == ": /laser/n_beams: 99999999999, expected an integer in [1, 100000]");
  CHECK(told("-90.0", "\"-90\"") == ": /laser/angle_min_deg: \"-90\", expected degrees in [-360, 360]");
  CHECK(told("1.0,", "0,") == ": /laser/angle_increment_deg: 0, expected degrees in (0, 90]");
  CHECK(told("80.0", "null") == ": /laser/no_return_at_or_above_m: null, expected metres, more than 0.05");
  CHECK(told("80.0", "80.0, \"range_max_m\": 0") == ": /laser/range_max_m: 0, expected metres, more than 0.05");
  CHECK(told("\"laser\"", "\"sonar\"") == ": /laser: missing, expected an object");
  CHECK(complaint(read_site_laser, "[1, 2]") == ": (root): [1,2], expected an object");
  CHECK_THAT(complaint(read_site_laser, "{\"laser\": "), Catch::Contains("line 1"));
  CHECK_THROWS_AS(read_site_laser("/no/such/file.json"), Error);
}

TEST_CASE("queries are read in order") {
  const TemporaryFile file("queries.json", R"({"site": "hall", "queries": [
    {"id": "b", "start_time": 3, "end_time": 4.5, "distance_m": 1}, {"id": "a", "start_time": -1.0, "end_time": -1.0}]})");
  const auto queries = read_queries(file.path());
  REQUIRE(queries.size() == 2);
  CHECK(queries[0].id == "b");
  CHECK(queries[0].start_s == 3);
  CHECK(queries[0].end_s == 4.5);
  CHECK(queries[1].id == "a");
}

TEST_CASE("wrong queries are refused with their place") {
  const auto told = [](const std::string& queries) {
    return complaint(read_queries, "{\"queries\": " + queries + "}");
  };
  CHECK(told("[{\"id\": \"a\", \"start_time\": 1}]") ==
        ": /queries/0/end_time: missing, expected seconds, not before start_time");
  CHECK(told("[{\"id\": \"a\", \"start_time\": 2, \"end_time\": 1}]") ==
        ": /queries/0/end_time: 1, expected seconds, not before start_time");
  CHECK(told("[{\"id\": \"\"}]") == ": /queries/0/id: \"\", expected a string that is not empty");
  CHECK(told("[{\"id\": \"a\", \"start_time\": 1, \"end_time\": 1}, {\"id\": \"a\"}]") ==
        ": /queries/1/id: \"a\", expected an id that no other query has");
  CHECK(told("{}") == ": /queries: {}, expected an array");
  CHECK(told("[7]") == ": /queries/0: 7, expected an object");
}
