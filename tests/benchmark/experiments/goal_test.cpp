#include "tests/kit/shipped_plugins.hpp"

#include "benchmark/experiments/goals/goal_report.hpp"
#include "benchmark/experiments/kit/in_parallel.hpp"
#include "benchmark/experiments/kit/published.hpp"

#include "simulation/buildings/building.hpp"

#include <catch2/catch.hpp>

#include <set>
#include <sstream>

using namespace opal;
using namespace opal::experiments;
using Catch::Contains;

namespace {

GoalExperiment in_the_room() {
  GoalExperiment experiment{SemanticMap::read(OPAL_SOURCE_DIR "/maps/example_room.jsonld"),
                            {},
                            {},
                            OPAL_SOURCE_DIR "/configs/behaviours.jsonld"};
  experiment.world.people = 1;
  experiment.world.robot_radius_m = 0.25;
  experiment.loop.motion.radius_m = 0.25;
  experiment.loop.most_s = 600;
  return experiment;
}

std::vector<GoalRun> driven(int jobs) {
  const GoalExperiment experiment = in_the_room();
  const Contender contender{"default", read_deployment(OPAL_SOURCE_DIR "/configs/default.jsonld"), "disambiguate"};
  const std::vector<GoalTask> tasks{{"A1", {"opal:ColumnPair"}, 2, Pose2(2, 2, 1), {6, 4}},
                                    {"A2", {"opal:ColumnPair"}, 2, Pose2(6, 4, 0), {2, 2}}};
  std::vector<GoalRun> runs(tasks.size());
  in_parallel(runs.size(), jobs,
              [&](std::size_t k) { runs[k] = run_task(experiment, shipped_plugins(), contender, tasks[k], 1); });
  return runs;
}

std::string csv_of(const std::vector<GoalRun>& runs) {
  std::ostringstream out;
  write_runs(out, runs);
  return out.str();
}

}  // namespace

TEST_CASE(
    "the tasks are those of table 4.1, each on floor that is free in the empty building, and no two worlds "
    "are one") {
  simulation::BuildingRequest request;
  request.kind = "gemini";
  simulation::SimulationOptions empty;
  empty.clutter.level = 0;
  empty.people = 0;
  const simulation::Simulation simulation(simulation::generate_building(request).map, empty, 1);
  std::set<std::uint64_t> worlds;
  std::vector<std::string> ids;
  for (const GoalTask& task : thesis4_tasks()) {
    CAPTURE(task.id);
    ids.push_back(task.id);
    CHECK(simulation.floor().holds(task.start.position()));
    CHECK(simulation.floor().way(task.start.position(), task.goal));
    for (std::uint64_t seed = 1; seed <= 20; ++seed) worlds.insert(world_seed(task, seed));
  }
  CHECK(ids == table_4_1_columns());
  CHECK(worlds.size() == 12 * 20);
}

TEST_CASE("a drive is the same on one thread and on two, and is written down as it was") {
  const std::vector<GoalRun> one = driven(1), two = driven(2);
  CHECK(csv_of(one) == csv_of(two));
  for (const GoalRun& run : one) {
    CAPTURE(run.task);
    CHECK(run.reached);
    CHECK(run.collisions == 0);
    CHECK(run.moments.size() == static_cast<std::size_t>(run.scans));
    CHECK(run.right_after_s <= run.localized_after_s);
    CHECK(run.places_after_inspection >= 1);
    CHECK(run.moments.back().under_way);
    CHECK_FALSE(run.moments.front().under_way);
    CHECK(run.moments.back().driven_m == Approx(run.driven_m).margin(0.2));
    CHECK_FALSE(run.starts.empty());
  }
}

TEST_CASE("a drive that does not arrive takes for ever") {
  GoalRun arrives, gives_up;
  arrives.contender = gives_up.contender = "somebody";
  arrives.task = gives_up.task = "A1";
  arrives.reached = true;
  arrives.time_s = 30;
  gives_up.time_s = 900;
  CHECK_THAT(text_of(goal_table(std::vector<GoalRun>{arrives, arrives, gives_up})),
             Contains("2/3") && Contains("0:30") && Contains("below the published one in 1 of 1"));
  const auto mostly_not = goal_summary(std::vector<GoalRun>{arrives, gives_up, gives_up});
  CHECK(mostly_not["somebody"]["A1"]["total_s"]["median"].is_null());
  CHECK(mostly_not["somebody"]["A1"]["published_total_s"] == 37);
}

TEST_CASE("times are written as the thesis does") {
  CHECK(minutes(82) == "1:22");
  CHECK(minutes(59.6) == "1:00");
  CHECK(minutes(kNever) == "na");
}
