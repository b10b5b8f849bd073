#include "tests/kit/temporary_folder.hpp"

#include "benchmark/experiments/challenges/baseline.hpp"
#include "benchmark/experiments/challenges/challenge_report.hpp"
#include "benchmark/experiments/kit/published.hpp"

#include <catch2/catch.hpp>

#include <sstream>

using namespace opal;
using namespace opal::experiments;
using Catch::Contains;

namespace {

/// A robot that drives 1 m per moment, and what is said of it: how far off, and whether that is called localized.
ChallengeRun synthetic(const std::vector<std::pair<double, bool>>& said) {
  ChallengeRun run;
  run.contender = "somebody";
  run.challenge = "B1";
  run.seed = 1;
  for (const auto& [off_m, localized] : said) {
    JudgedMoment moment;
    moment.time_s = moment.driven_m = static_cast<double>(run.moments.size());
    moment.truth = Pose2(moment.driven_m, 0, 0);
    moment.estimate = Pose2(moment.driven_m, off_m, 0);
    moment.has_pose = true;
    moment.status = localized ? Status::localized : Status::ambiguous;
    moment.hypotheses = 10 - static_cast<int>(run.moments.size());
    run.moments.push_back(moment);
  }
  judge(run);
  return run;
}

simulation::Recording recording_of(int scans) {
  simulation::Recording recording;
  recording.laser.T_base_laser = Pose2(0.2, 0, 0);
  for (int k = 0; k < scans; ++k) {
    simulation::RecordedScan scan;
    scan.scan.stamp_s = 0.2 * k;
    scan.T_map_base = Pose2(k, 0, 0);
    recording.scans.push_back(scan);
  }
  return recording;
}

}  // namespace

TEST_CASE("success is to come within 1 m and to stay there") {
  const ChallengeRun good = synthetic({{5, false}, {0.5, false}, {0.2, true}, {0.1, true}});
  CHECK(good.success);
  CHECK(good.right_after_m == 1);
  CHECK(good.localized_after_m == 2);
  CHECK(good.error_m.value() == Approx((0.5 + 0.2 + 0.1) / 3));
  CHECK(good.hypotheses_before == 10);
  CHECK(good.hypotheses_after == 7);
  CHECK(good.false_rows == 0);
  const ChallengeRun lost = synthetic({{0.1, true}, {0.1, true}, {3, true}});
  CHECK(!lost.success);
  CHECK_FALSE(lost.right_after_m);
  CHECK(lost.localized_rows == 3);
  CHECK(lost.false_rows == 1);
}

TEST_CASE("a robot that believes to look the other way is wrong, however near it is") {
  ChallengeRun run;
  for (int k = 0; k < 3; ++k) {
    JudgedMoment moment;
    moment.has_pose = true;
    moment.status = Status::localized;
    moment.estimate = Pose2(0, 0, 3.1);
    run.moments.push_back(moment);
  }
  judge(run);
  CHECK(!run.success);
  CHECK(run.false_rows == 3);
}

TEST_CASE("the table has what was published beside what was measured") {
  const std::vector<ChallengeRun> runs{synthetic({{0.1, true}}), synthetic({{3, true}})};
  const std::string text = text_of(challenge_table(runs));
  CHECK_THAT(text, Contains("1/2"));
  CHECK_THAT(text, Contains("AMCL, as published") && Contains("2/5"));
  const nlohmann::ordered_json summary = challenge_summary(runs);
  CHECK(summary["somebody"]["B1"]["successful"]["runs"] == 1);
  CHECK(summary["somebody"]["all"]["falsely so"]["runs"] == 1);
}

TEST_CASE("what AMCL is said to have done in all is what it did in each") {
  const std::vector<ThesisTable::Block> published = table_3_3();
  int successful = 0;
  for (const std::string& cell : published[1].rows[0].cells) successful += std::stoi(cell);
  CHECK(published[1].all == std::to_string(successful) + " of 70");
  for (const ThesisTable::Block& block : published)
    for (const ThesisTable::Row& row : block.rows) CHECK(row.cells.size() == table_3_3_columns().size());
  const ThesisTable::Block closed_loop = table_4_1();
  for (const ThesisTable::Row& row : closed_loop.rows) CHECK(row.cells.size() == table_4_1_columns().size());
}

TEST_CASE("a baseline's answer is judged by the robot's pose, and where it says nothing it has none") {
  const TemporaryFile file(
      "rows.csv", "timestamp,x,y,theta,localized,hypotheses,cpu_ms\n0,0.2,0.5,0,0,50000,90\n0.4,2.2,0,0,1,200,3\n");
  const std::vector<JudgedMoment> moments = read_baseline(file.path(), recording_of(3));
  REQUIRE(moments.size() == 3);
  CHECK(moments[0].error_m() == Approx(0.5));
  CHECK(moments[0].hypotheses == 50000);
  CHECK(!moments[1].has_pose);
  CHECK(moments[2].localized());
  CHECK(moments[2].error_m() == Approx(0).margin(1e-12));
  CHECK(moments[2].driven_m == 2);
}

TEST_CASE("a baseline's table that is none is refused by file and line") {
  const std::string header = "timestamp,x,y,theta,localized,hypotheses,cpu_ms\n";
  const auto reading = [](const std::string& text) {
    const TemporaryFile file("rows.csv", text);
    return read_baseline(file.path(), recording_of(1));
  };
  CHECK_THROWS_WITH(reading("a,b\n"), Contains("line 1") && Contains("expected timestamp"));
  CHECK_THROWS_WITH(reading(header + "0,1,2,3,1,1,1\n0.2,1,two,3,1,1,1\n"), Contains("line 3") && Contains("'two'"));
  CHECK_THROWS_WITH(reading(header + "0,1,2,3\n"), Contains("4 columns"));
}

TEST_CASE("a baseline that is not there, or fails, is named") {
  const TemporaryFolder folder;
  const simulation::ChallengeDrive driven{recording_of(1), std::nullopt};
  CHECK_THROWS_WITH(run_baseline({"/nowhere/filter", "filter"}, driven, folder.path_of("a"), "map.yaml", 1),
                    Contains("/nowhere/filter"));
  CHECK_THROWS_WITH(run_baseline({"/bin/false", "false"}, driven, folder.path_of("a"), "map.yaml", 1),
                    Contains("/bin/false"));
}
