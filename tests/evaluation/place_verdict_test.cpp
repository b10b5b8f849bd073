#include "evaluation/place_verdict.hpp"

#include <catch2/catch.hpp>

#include <numbers>

using namespace opal;
using Catch::Contains;
using Catch::StartsWith;

namespace {

/// A robot that drives along x at 1 m/s for a minute, in three queries.
const std::vector<Query> kThree{{"q1", 0, 20}, {"q2", 20, 40}, {"q3", 40, 60}};

GroundTruth a_minute() {
  std::vector<StampedPose> poses;
  for (int t = 0; t <= 60; ++t) poses.push_back({double(t), Pose2(t, 0, 0)});
  return GroundTruth(std::move(poses));
}

/// q1 is right from its third metre on, q2 looks the other way, q3 never says that it is localized.
PlaceVerdict judged_minute() {
  std::vector<opal::ResultRow> rows;
  for (int t = 0; t <= 20; ++t)
    rows.push_back({"q1", double(t), Pose2(t < 3 ? 50 : t, 0, 0), t < 5 ? Status::searching : Status::localized});
  for (int t = 20; t <= 40; ++t) rows.push_back({"q2", double(t), Pose2(t, 0, std::numbers::pi), Status::localized});
  for (int t = 40; t <= 60; ++t) rows.push_back({"q3", double(t), Pose2(t, 0.7, 0), Status::ambiguous});
  return judge_place(rows, kThree, a_minute());
}

}  // namespace

TEST_CASE("a place's verdict says first whether it worked, then what was wrongly called localized, then who failed") {
  const std::string text = summary_of(judged_minute());
  CHECK_THAT(text, StartsWith("success in 2 of 3 queries (strict: 1), after 1.5 m (median)\n"
                              "localized in 1 of 3 queries, after 5.0 m (median)\n"
                              "wrongly localized: 21 of 37 localized rows, in 1 query\n"
                              "no success: q2\n"));
}

TEST_CASE("a query without any row has failed, and medians of nothing are null") {
  const PlaceVerdict verdict = judge_place({}, kThree, a_minute());
  CHECK(verdict.failed == std::vector<std::string>{"q1", "q2", "q3"});
  CHECK(to_json(verdict)["median_success_m"].is_null());
  CHECK_THAT(summary_of(verdict), Contains("success in 0 of 3 queries (strict: 0)\n"));
}

TEST_CASE("verdicts of several places add up") {
  PlaceVerdict all = judged_minute();
  all.add(judged_minute());
  CHECK(all.queries == 6);
  CHECK(all.success() == 4);
  CHECK(all.false_rows == 42);
  CHECK(all.failed.size() == 2);
}
