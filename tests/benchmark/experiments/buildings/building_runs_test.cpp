#include "tests/kit/shipped_plugins.hpp"

#include <catch2/catch.hpp>

#include "benchmark/experiments/buildings/buildings_page.hpp"
#include "benchmark/experiments/kit/in_parallel.hpp"

#include <opal/deployment/deployment.hpp>

using namespace opal::experiments;

namespace {

/// Small buildings and short drives.
BuildingsExperiment experiment(int jobs, bool backwards) {
  opal::simulation::SuiteRequest request;
  request.buildings = 4;
  request.difficulties = {0.5};
  request.size_factor = 0.25;
  BuildingsOptions options;
  options.contenders = {{"default", opal::read_deployment(OPAL_SOURCE_DIR "/configs/default.jsonld"), ""}};
  options.challenges = {"A1", "C12"};
  options.duration_s = 3;
  const auto suite = building_suite(request);
  BuildingsExperiment done;
  done.buildings.resize(suite.size());
  in_parallel(suite.size(), jobs, [&](std::size_t k) {
    const std::size_t which = backwards ? suite.size() - 1 - k : k;
    done.buildings[which] = run_building(suite[which], shipped_plugins(), options);
  });
  done.groups = groups_of(done.buildings);
  done.command = done.run_command = "opal experiment buildings";
  return done;
}

void remove_cpu(nlohmann::ordered_json& json) {
  for (auto item = json.begin(); item != json.end();)
    if (json.is_object() && item.key().starts_with("cpu_")) {
      item = json.erase(item);
    } else {
      if (item->is_structured()) remove_cpu(*item);
      ++item;
    }
}

ChallengeRun run_of(std::vector<JudgedMoment> moments) {
  ChallengeRun run;
  run.challenge = "B1";
  run.moments = std::move(moments);
  judge(run);
  return run;
}

JudgedMoment moment(double time_s, double error_m, bool localized) {
  JudgedMoment said;
  said.time_s = time_s;
  said.estimate = opal::Pose2(error_m, 0, 0);
  said.has_pose = true;
  said.status = localized ? opal::Status::localized : opal::Status::ambiguous;
  return said;
}

}  // namespace

TEST_CASE("results do not depend on threads and order, and come again") {
  auto alone = to_json(experiment(1, false)), together = to_json(experiment(2, true));
  remove_cpu(alone);
  remove_cpu(together);
  CHECK(alone == together);
  CHECK(alone["buildings"].size() == 4);
  CHECK(alone["buildings"][0]["runs"].size() == 2);
}

TEST_CASE("a run is called what it was") {
  CHECK(outcome_of(run_of({moment(0, 5, false), moment(1, 0.1, true)})) == Outcome::localized);
  CHECK(outcome_of(run_of({moment(0, 5, false), moment(1, 0.1, false)})) == Outcome::unsure);
  CHECK(outcome_of(run_of({moment(0, 0.1, false), moment(1, 7, false)})) == Outcome::unknown);
  CHECK(outcome_of(run_of({moment(0, 7, true), moment(1, 0.1, true)})) == Outcome::wrong);
  CHECK(wrong_after_s(run_of({moment(0, 0, true), moment(2, 7, true)})) == 2);
  CHECK(localized_after_s(run_of({moment(0, 0, false), moment(3, 0, true)})) == 3);
}

TEST_CASE("groups count every run in its kind, its difficulty, both, and all") {
  const BuildingsExperiment done = experiment(2, false);
  REQUIRE(done.groups.front().name() == "all");
  CHECK(done.groups.front().runs == 8);
  CHECK(done.groups.size() == 1 + 4 + 1 + 4);
  for (const BuildingGroup& group : done.groups) CHECK(group.success.within.low <= group.success.share);
  const std::string table = markdown_of(buildings_table(done));
  CHECK_THAT(table, Catch::Contains("warehouse, difficulty 0.50"));
}

TEST_CASE("the page shows every building, and how to run again what failed") {
  BuildingsExperiment done = experiment(2, false);
  done.buildings[1].runs[0] = run_of({moment(0, 7, true), moment(1, 7, true)});
  const std::string page = buildings_page(done);
  for (const BuildingRuns& building : done.buildings)
    CHECK_THAT(page, Catch::Contains("<g id=\"" + building.building.id + "\" class=\"building\""));
  CHECK_THAT(page, Catch::Contains("--building " + done.buildings[1].building.id + " --challenge B1"));
  CHECK_THAT(page, Catch::Contains("class=\"claim\""));
}
