#include "evaluation/query_verdict.hpp"

#include <catch2/catch.hpp>

#include <numbers>

using namespace opal;

namespace {

constexpr double kDegree_rad = std::numbers::pi / 180;

/// A robot that drives along x at 1 m/s for 20 s.
GroundTruth straight_truth() {
  std::vector<StampedPose> poses;
  for (int t = 0; t <= 20; ++t) poses.push_back({double(t), Pose2(t, 0, 0)});
  return GroundTruth(std::move(poses));
}

/// One row a second, all off by as much.
std::vector<ResultRow> rows_off(double off_m, double off_rad) {
  std::vector<ResultRow> rows;
  for (int t = 0; t <= 20; ++t) rows.push_back({"q", double(t), Pose2(t, off_m, off_rad), Status::localized, 1, 0});
  return rows;
}

QueryVerdict verdict_of(const std::vector<ResultRow>& rows) {
  return judge_query(rows, {"q", 0, 20}, straight_truth());
}

}  // namespace

TEST_CASE("a query succeeds by position and heading: 1 m and 10 degrees, strictly 0.5 m and 5 degrees") {
  struct Case {
    double off_m, off_deg;
    bool success, strict;
  };
  for (const Case& c : {Case{0.4, 4, true, true}, Case{0.4, 6, true, false}, Case{0.6, 4, true, false},
                        Case{0.9, 9, true, false}, Case{0.1, 11, false, false}, Case{1.1, 0, false, false}}) {
    CAPTURE(c.off_m, c.off_deg);
    for (const double side : {-1.0, 1.0}) {
      const QueryVerdict verdict = verdict_of(rows_off(c.off_m, side * c.off_deg * kDegree_rad));
      CHECK(verdict.success == c.success);
      CHECK(verdict.strict == c.strict);
    }
  }
}

TEST_CASE("a pose that looks the other way is a false positive at the right place") {
  const QueryVerdict verdict = verdict_of(rows_off(0, std::numbers::pi));
  CHECK(verdict.false_rows == 21);
  CHECK_FALSE(verdict.honest());
  CHECK_FALSE(verdict.localized_after_m);
}

TEST_CASE("a query is right from the first row after the last wrong heading") {
  std::vector<ResultRow> rows = rows_off(0, 0);
  rows[7].T_map_laser = Pose2(7, 0, 0.5);
  const QueryVerdict verdict = verdict_of(rows);
  CHECK(verdict.success);
  CHECK(verdict.right_after_m.value() == Approx(8));
}
