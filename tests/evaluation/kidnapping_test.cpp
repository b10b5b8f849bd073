#include "tests/kit/temporary_folder.hpp"

#include <opal/common/error.hpp>
#include "evaluation/kidnapping.hpp"
#include "evaluation/kidnapping_sequence.hpp"

#include <catch2/catch.hpp>

#include <numbers>
#include <sstream>

using namespace opal;

namespace {

/// A robot that drives along x at 1 m/s for 100 s.
GroundTruth straight_drive() {
  std::ostringstream rows;
  rows << "timestamp,x,y,theta,is_scan\n";
  for (int t = 0; t <= 100; ++t) rows << t << ',' << t << ",0,0,1\n";
  const TemporaryFile file("straight.gt.csv", rows.str());
  return GroundTruth::read(file.path());
}

/// A row at second `t` whose pose is off by some metres, and turned.
ResultRow row(double t, double off_m, Status status, double off_rad = 0) {
  return {"s", t, Pose2(t, off_m, off_rad), status, 1, 0};
}

std::vector<Sample> samples(double from_s, int count, const Pose2& T_odom_start) {
  std::vector<Sample> all;
  for (int k = 0; k < count; ++k) {
    Scan scan;
    scan.stamp_s = from_s + 0.2 * k;
    all.push_back(sample_of(scan, T_odom_start * Pose2(0.1 * k, 0, 0.01 * k)));
  }
  return all;
}

}  // namespace

TEST_CASE("a sequence tells nothing of the cut: odometry stands still, stamps go on, each part moves as it did") {
  const auto before = samples(10, 20, Pose2(3, -2, 1)), after = samples(500, 15, Pose2(-40, 7, -2.5));
  const KidnappingLog log = with_kidnapping(before, after);
  REQUIRE(log.samples.size() == 35);
  REQUIRE(log.cut == 20);
  const Pose2 over_the_cut = log.samples[19].T_odom_base.inverse() * log.samples[20].T_odom_base;
  CHECK(over_the_cut.position().norm() < 1e-9);
  CHECK(std::abs(over_the_cut.heading_rad()) < 1e-9);
  for (std::size_t k = 1; k < log.samples.size(); ++k)
    CHECK(log.samples[k].stamp_s - log.samples[k - 1].stamp_s == Approx(0.2));
  for (std::size_t k = 1; k < after.size(); ++k) {
    const Pose2 was = after[k - 1].T_odom_base.inverse() * after[k].T_odom_base;
    const Pose2 is = log.samples[19 + k].T_odom_base.inverse() * log.samples[20 + k].T_odom_base;
    CHECK(distance_m(was, is) < 1e-9);
    CHECK(angle_between_rad(was, is) < 1e-9);
    CHECK(log.recorded_s[20 + k] == after[k].stamp_s);
  }
  CHECK(with_kidnapping(before, {}).samples.size() == 20);
  CHECK(with_kidnapping({}, after).cut == 0);
}

TEST_CASE("sequences join places that are far apart, and the same seed draws the same ones") {
  const GroundTruth truth = straight_drive();
  const std::vector<Query> queries{{"q1", 0, 40}, {"q2", 30, 100}};
  KidnappingSequenceOptions options;
  options.count = 40;
  const auto sequences = draw_kidnapping_sequences("hall", queries, truth, options);
  REQUIRE(sequences.size() == 40);
  for (const KidnappingSequence& s : sequences) {
    CHECK(s.apart_m > options.least_apart_m);
    CHECK(s.apart_m == Approx(std::abs(s.after.start_s - s.before.end_s)));
    CHECK(s.before.end_s - s.before.start_s >= options.before_m);
    CHECK(s.after.end_s - s.after.start_s >= options.after_m - 1);
  }
  CHECK(sequences[0].id == "hall-sequence01");
  const auto again = draw_kidnapping_sequences("hall", queries, truth, options);
  CHECK(again[17].before.end_s == sequences[17].before.end_s);
  options.seed = 2;
  CHECK(draw_kidnapping_sequences("hall", queries, truth, options)[17].before.end_s != sequences[17].before.end_s);
  options.count = 0;
  CHECK(draw_kidnapping_sequences("hall", queries, truth, options).size() == queries.size());
}

TEST_CASE("a place too small for a kidnapping is an error that says so") {
  const GroundTruth truth = straight_drive();
  CHECK_THROWS_WITH(draw_kidnapping_sequences("closet", std::vector<Query>{{"q1", 0, 4}}, truth, {}),
                    Catch::Contains("closet") && Catch::Contains("5.0"));
  CHECK_THROWS_AS(draw_kidnapping_sequences("dark", std::vector<Query>{{"q1", 500, 600}}, truth, {}), ConfigError);
}

TEST_CASE("a kidnapping that is noticed at once and recovered from") {
  std::vector<ResultRow> rows;
  for (int t = 0; t < 10; ++t) rows.push_back(row(t, 0.1, Status::localized));
  for (int t = 50; t < 53; ++t) rows.push_back(row(t, 30, Status::lost));
  for (int t = 53; t < 56; ++t) rows.push_back(row(t, 0.2, Status::ambiguous));
  for (int t = 56; t < 80; ++t) rows.push_back(row(t, 0.2, Status::localized));
  const KidnappingVerdict v = judge_kidnapping(rows, 10, straight_drive());
  CHECK(v.localized_before);
  CHECK(v.recovered);
  CHECK(v.honest());
  CHECK(v.right_after_m.value() == Approx(3));
  CHECK(v.lost_after_m == 0);
  CHECK(v.localized_after_m.value() == Approx(6));
  CHECK(v.false_rows == 0);
  CHECK(v.driven_m == Approx(29));
}

TEST_CASE("calling the old place localized is not honest, however soon it ends") {
  std::vector<ResultRow> rows{row(9, 0.1, Status::localized), row(50, 30, Status::localized)};
  for (int t = 51; t < 80; ++t) rows.push_back(row(t, 0.2, Status::localized));
  const KidnappingVerdict v = judge_kidnapping(rows, 1, straight_drive());
  CHECK_FALSE(v.honest());
  CHECK(v.false_rows_at_once == 1);
  CHECK(v.false_m == Approx(1));
  CHECK(v.recovered);
}

TEST_CASE("too late, or not to the end, is not recovered") {
  std::vector<ResultRow> late{row(9, 0.1, Status::localized)}, lost_again = late, lucky = late;
  for (int t = 50; t < 90; ++t) late.push_back(row(t, t < 70 ? 20 : 0, Status::lost));
  for (int t = 50; t < 90; ++t) lost_again.push_back(row(t, t < 85 ? 0 : 5, Status::lost));
  for (int t = 50; t < 60; ++t) lucky.push_back(row(t, t < 59 ? 5 : 0, Status::lost));
  const GroundTruth truth = straight_drive();
  CHECK_FALSE(judge_kidnapping(late, 1, truth).recovered);
  CHECK(judge_kidnapping(late, 1, truth).right_after_m.value() == Approx(20));
  CHECK_FALSE(judge_kidnapping(lost_again, 1, truth).right_after_m);
  CHECK_FALSE(judge_kidnapping(lucky, 1, truth).right_after_m);
}

TEST_CASE("after a kidnapping, a pose at the right place that looks the other way is wrong") {
  std::vector<ResultRow> rows{row(9, 0.1, Status::localized)};
  for (int t = 50; t < 80; ++t) rows.push_back(row(t, 0.1, Status::localized, std::numbers::pi));
  const KidnappingVerdict v = judge_kidnapping(rows, 1, straight_drive());
  CHECK(v.localized_before);
  CHECK_FALSE(v.right_after_m);
  CHECK_FALSE(v.localized_after_m);
  CHECK_FALSE(v.recovered);
  CHECK(v.false_rows == 30);
}

TEST_CASE("no rows after the cut is no recovery, and no crash") {
  const KidnappingVerdict v = judge_kidnapping({}, 3, straight_drive());
  CHECK_FALSE(v.recovered);
  CHECK(v.rows == 0);
  std::ostringstream table;
  write_kidnappings(table, std::vector<KidnappingVerdict>{v});
  CHECK(table.str().find("\n,0.00,0.00,0,0,-1.00") != std::string::npos);
  CHECK(summary_of(std::vector<KidnappingVerdict>{}).find("0 kidnappings") == 0);
}
