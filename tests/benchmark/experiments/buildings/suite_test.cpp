#include <catch2/catch.hpp>

#include "simulation/drives/building_suite.hpp"

#include <opal/common/error.hpp>

#include <set>

using namespace opal::simulation;

TEST_CASE("a suite has as many buildings as asked for, all of them different") {
  const auto suite = building_suite({});
  REQUIRE(suite.size() == 100);
  std::set<std::string> ids;
  for (const SuiteBuilding& building : suite) ids.insert(building.id);
  CHECK(ids.size() == 100);
  CHECK(ids.count("office-75-3") == 1);
}

TEST_CASE("a larger suite begins with a smaller one") {
  SuiteRequest few, many;
  few.buildings = 30;
  many.buildings = 60;
  const auto small = building_suite(few), large = building_suite(many);
  for (std::size_t k = 0; k < small.size(); ++k) CHECK(small[k].id == large[k].id);
}

TEST_CASE("difficulty makes buildings more alike, larger and fuller, and half of it is as usual") {
  const auto suite = building_suite({});
  for (const SuiteBuilding& building : suite) {
    CHECK(building.request.symmetry == building.difficulty);
    CHECK(building.clutter == 2 * building.difficulty);
  }
  SuiteRequest request;
  request.kinds = {"hall"};
  request.difficulties = {0, 0.5, 1};
  request.buildings = 3;
  const auto halls = building_suite(request);
  CHECK(halls[1].request.size_m2 == 1200);
  CHECK(halls[0].request.size_m2 < halls[1].request.size_m2);
  CHECK(halls[1].request.size_m2 < halls[2].request.size_m2);
}

TEST_CASE("what difficulty decides can be held fast") {
  SuiteRequest request;
  request.symmetry = 0.3;
  request.size_factor = 2;
  request.clutter = 0;
  for (const SuiteBuilding& building : building_suite(request)) {
    CHECK(building.request.symmetry == 0.3);
    CHECK(building.clutter == 0);
    for (const Challenge& challenge : challenges_in(building)) CHECK(challenge.clutter.level == 0);
  }
}

TEST_CASE("a suite that cannot be is refused with what there is") {
  SuiteRequest castle, impossible, none;
  castle.kinds = {"castle"};
  impossible.difficulties = {0.5, 1.5};
  none.difficulties = {};
  CHECK_THROWS_WITH(building_suite(castle), Catch::Contains("castle") && Catch::Contains("warehouse"));
  CHECK_THROWS_WITH(building_suite(impossible), Catch::Contains("1.5") && Catch::Contains("0 to 1"));
  CHECK_THROWS_AS(building_suite(none), opal::ConfigError);
}
