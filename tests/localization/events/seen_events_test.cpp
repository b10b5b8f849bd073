// What the event stream says of scans and of the local map.
#include "localization/events/run_journal.hpp"
#include "tests/localization/driven_robot.hpp"
#include "tests/localization/search/searching.hpp"

#include <opal/sensing/free_space.hpp>

#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::synthetic;

namespace {

/// A journal of a local map.
struct Watched {
  /// One keyframe. @param features  base_link frame.
  void see(const Features& features, const Pose2& T_odom_base) { see(sample_of({}, T_odom_base), features); }
  void see(const Sample& sample, const Features& features) {
    local_map.add(sample, features);
    const Observation observation{local_map, {}, features};
    journal.keyframe(sample, local_map.keyframes().back().id, observation);
  }
  std::size_t times_changed() const { return heard.of("local_features").size(); }

  std::shared_ptr<const MapView> map = view_of(room());
  Judges judges{map, {{"fit", fit_scorer(), ScorerRole::decides, 1}}};
  GlobalSearch search{map, {corners()}, judges.ensemble, {}};
  LocalMap local_map{{}, nullptr};
  Heard heard;
  RunJournal journal{heard, map, judges.ensemble, search};
};

Feature column(double x_m) { return {"opal:Column", Circle{{x_m, 1}, 0.2}}; }
Feature corner(double heading_rad) { return {"opal:Corner", OrientedPoint{{2, 1}, heading_rad, 1.5}}; }

}  // namespace

TEST_CASE("a keyframe is written with what was counted in it") {
  Watched robot;
  const Scan scan = scan_from(*robot.map, Pose2(3, 4.5, 0.1));
  Sample sample = sample_of(scan, Pose2());
  sample.views.push_back({1, scan, Pose2(-1, 0, 3)});
  robot.see(sample, {column(2), column(4)});
  const ordered_json written = robot.heard.of("keyframe").front();
  CHECK(written["points"] == 2 * scan.points.size());
  CHECK(written["features"] == 2);
  CHECK(written["local_features"] == 2);
  CHECK(written["scan_match"] == false);  // there is no matcher
  CHECK(written["scan"].size() > 20);
  CHECK(written["scan"].size() % 2 == 0);
}

TEST_CASE("of several lasers each outline of free space is written, and closed") {
  Watched robot;
  const Scan scan = scan_from(*robot.map, Pose2(3, 4.5, 0.1));
  Sample sample = sample_of(scan, Pose2(), T_base_laser);
  sample.views.push_back({1, {}, Pose2(-1, 0, 3)});  // it sees nothing, and has no outline
  sample.views.push_back({2, scan, Pose2(-1, 0, 3)});
  robot.see(sample, {});
  const std::vector<Point> front = free_space_outline(scan, T_base_laser),
                           rear = free_space_outline(scan, Pose2(-1, 0, 3));
  const ordered_json written = robot.heard.of("keyframe").front()["free_space"];
  REQUIRE(written.size() == 2 * (front.size() + 1 + rear.size() + 1));
  const auto point = [&](std::size_t k) {
    return Point(written[2 * k].get<double>(), written[2 * k + 1].get<double>());
  };
  CHECK((point(0) - front.front()).norm() < 0.002);
  CHECK(point(front.size()) == point(0));
  CHECK((point(front.size() + 1) - rear.front()).norm() < 0.002);
  CHECK(point(front.size() + 1 + rear.size()) == point(front.size() + 1));
}

TEST_CASE("a local feature is written with its shape, and with what the local map knows of it") {
  Watched robot;
  robot.see({column(2)}, Pose2());
  const ordered_json first = robot.heard.of("local_features").front();
  REQUIRE(first["changed"].size() == 1);
  CHECK(first["changed"][0]["id"] == 0);
  CHECK(first["changed"][0]["type"] == "opal:Column");
  CHECK(first["changed"][0]["stable"] == false);
  CHECK(first["changed"][0]["measurements"] == 1);
  REQUIRE(first["changed"][0].contains("circle"));
  CHECK(first["gone"].empty());
}

TEST_CASE("a feature that becomes stable is said to be so once, and written as stable") {
  Watched robot;
  for (int k = 0; k < 6; ++k) robot.see({column(2 - 0.2 * k)}, Pose2(0.2 * k, 0, 0));
  const auto stable = robot.heard.of("stable");
  REQUIRE(stable.size() == 1);
  CHECK(stable[0]["local_feature"] == 0);
  CHECK(stable[0]["type"] == "opal:Column");
  bool written = false;
  for (const ordered_json& event : robot.heard.of("local_features")) {
    const bool now = event["changed"][0]["stable"];
    CHECK(now == (event["keyframe"] >= stable[0]["keyframe"]));
    written = written || now;
  }
  CHECK(written);
}

TEST_CASE("local features that are forgotten are said to be gone, by their numbers, once") {
  Watched robot;
  robot.see({column(2), column(4), column(6)}, Pose2());
  robot.local_map.keep_only({LocalFeatureId(1)});
  robot.see({}, Pose2(0.3, 0, 0));
  robot.see({}, Pose2(0.6, 0, 0));
  const auto events = robot.heard.of("local_features");
  REQUIRE(events.size() == 2);
  CHECK(events[1]["changed"].empty());
  CHECK(events[1]["gone"] == ordered_json{0, 2});
}

TEST_CASE("a feature whose estimate moves or turns is written again, and one that stays is not") {
  const auto [before, now, is_written] =
      GENERATE(table<Feature, Feature, bool>({{column(2), column(2), false},
                                              {column(2), column(2.006), false},
                                              {column(2), column(2.1), true},
                                              {corner(0.5), corner(0.503), false},
                                              {corner(0.5), corner(0.6), true},
                                              {seen_wall({0, 2}, {3, 2}), seen_wall({0, 2}, {3, 2}), false},
                                              {seen_wall({0, 2}, {3, 2}), seen_wall({0, 2}, {3.2, 2}), true},
                                              {seen_wall({0, 2}, {3, 2}), seen_wall({-0.2, 2}, {3, 2}), true}}));
  Watched robot;
  robot.see({before}, Pose2());
  robot.see({before}, Pose2(0, 0, 0));
  robot.see({before}, Pose2(0, 0, 0));
  const std::size_t already = robot.times_changed();
  robot.see({now}, Pose2(0, 0, 0));
  CHECK(robot.times_changed() == already + (is_written ? 1 : 0));
}
