#include "benchmark/ab/documents/cell_plan.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

#include <set>

using namespace opal::ab;

namespace {

CellPlan made_plan() {
  Experiment experiment;
  experiment.arms.resize(3);
  for (const char* name : {"a", "b", "c"}) experiment.arms[std::size_t(*name - 'a')].name = name;
  experiment.scenarios.resize(3);
  experiment.scenarios[0] = {"hall", RecordedPlace{}, "", {1}};
  experiment.scenarios[1] = {"office", SimulatedDrives{}, "", {1, 2, 3, 4}};
  experiment.scenarios[2] = {"damaged", RecordedPlace{}, "drop=0.3", {1, 2}};
  return {experiment, {{"q1", "q2", "q3", "q4", "q5", "q6"}, {"q01", "q02"}, {"q1", "q2", "q3"}}};
}

}  // namespace

TEST_CASE("cells are numbered by scenario, seed, query and arm, and each has its own name") {
  const CellPlan plan = made_plan();
  REQUIRE(plan.tasks() == 6 + 4 * 2 + 2 * 3);
  REQUIRE(plan.cells() == 3 * plan.tasks());
  std::set<std::string> names;
  for (std::size_t k = 0; k < plan.cells(); ++k) names.insert(plan.name(plan.cell(k)));
  CHECK(names.size() == plan.cells());
  CHECK(plan.name(plan.cell(0)) == "hall/q1/1/a");
  CHECK(plan.name(plan.cell(18)) == "office/q01/1/a");
  CHECK(plan.name(plan.cell(plan.cells() - 1)) == "damaged/q3/2/c");
}

TEST_CASE("shards are disjoint and together everything") {
  for (const std::size_t of : {1u, 3u, 20u, 33u})
    for (std::size_t k = 1, next = 0; k <= of; ++k) {
      const Shard shard{k, of};
      REQUIRE(shard.first(20) == next);
      next = shard.end(20);
      if (k == of) REQUIRE(next == 20);
    }
}

TEST_CASE("blocks stay within one world and within what is asked for") {
  const CellPlan plan = made_plan();
  for (std::size_t first = 0, end = 0; first < plan.tasks(); first = end) {
    end = plan.end_of_block(first, plan.tasks());
    REQUIRE(end > first);
    for (std::size_t task = first; task < end; ++task) CHECK(plan.task(task).same_world(plan.task(first)));
  }
  CHECK(plan.end_of_block(0, 2) == 2);
}

TEST_CASE("a shard that is none is refused") {
  CHECK(read_shard("3/10").name() == "3-of-10");
  for (const char* text : {"", "3", "0/3", "4/3", "a/3", "1/3x", "1/", "/", "-1/3"})
    CHECK_THROWS_AS(read_shard(text), opal::ConfigError);
}
