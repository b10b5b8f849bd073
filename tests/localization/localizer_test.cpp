// The pipeline as a whole, in a small room where the right decision is known.
#include "tests/localization/driven_robot.hpp"

#include <opal/sensing/free_space.hpp>

#include <catch2/catch.hpp>

#include <ctime>
#include <set>

using namespace opal;
using namespace opal::synthetic;
using nlohmann::ordered_json;

TEST_CASE("a robot that drives about is found, and every estimate is written with all that is held possible") {
  Driven robot;
  robot.drive_on(12);
  const auto keyframes = robot.heard.of("keyframe");
  REQUIRE(keyframes.size() == 12);
  CHECK(keyframes.back()["features"] == 5);  // four corners and a column
  const Pose2& here = robot.localizer.local_map().T_local_base();
  CHECK(keyframes.back().at("T_local_base") == ordered_json{here.x(), here.y(), here.heading_rad()});
  CHECK(keyframes.back()["local_features"] == robot.localizer.local_map().features().size());
  const auto estimates = robot.heard.of("estimate");
  REQUIRE(estimates.size() == 12);
  const ordered_json& last = estimates.back();
  const std::vector<Hypothesis> alive = robot.localizer.hypotheses();
  REQUIRE(last["hypotheses"].size() == alive.size());
  for (std::size_t k = 0; k < alive.size(); ++k)
    CHECK(last["hypotheses"][k]["log_likelihood"].get<double>() == Approx(alive[k].log_likelihood));
  CHECK(robot.localizer.scores_of(alive.front().id).size() == 1);
  CHECK(last["T_map_base"][0].get<double>() == Approx(3 + 0.25 * 11).margin(0.05));
  CHECK(last["T_map_base"][1].get<double>() == Approx(4.5).margin(0.05));
}

TEST_CASE("each hypothesis is written where it begins and where it ends") {
  Driven robot;
  robot.drive_on(12);
  std::set<int> begun;
  for (const ordered_json& event : robot.heard.of("spawned")) {
    CHECK(event["T_map_base"].size() == 3);
    begun.insert(event["hypothesis"].get<int>());
  }
  const auto ended = robot.heard.of("pruned");
  REQUIRE_FALSE(ended.empty());
  for (const ordered_json& event : ended) {
    CHECK(begun.contains(event["hypothesis"].get<int>()));
    REQUIRE(event.contains("T_map_base"));
    CHECK(event["T_map_base"].size() == 3);
    CHECK_FALSE(event["reason"].get<std::string>().empty());
  }
}

TEST_CASE("each update writes what it cost, stage by stage") {
  Driven robot;
  robot.drive_on(3);
  const auto costs = robot.heard.of("cost");
  REQUIRE(costs.size() == 3);
  for (const ordered_json& cost : costs) {
    REQUIRE(cost.contains("cpu_ms"));
    double sum_ms = 0;
    for (const char* stage :
         {"sensor", "detect", "local_map", "track", "generate", "search", "retrospect", "grow", "status"})
      sum_ms += cost["cpu_ms"].at(stage).get<double>();
    CHECK(cost["cpu_ms"].at("total").get<double>() == Approx(sum_ms).margin(0.01));
  }
}

TEST_CASE("all updates together are said to cost no more than they did") {
  Driven robot;
  const std::clock_t before = std::clock();
  robot.drive_on(20);
  const double spent_ms = 1e3 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
  double said_ms = 0;
  for (const ordered_json& cost : robot.heard.of("cost")) said_ms += cost["cpu_ms"].at("total").get<double>();
  CHECK(said_ms > 0);
  CHECK(said_ms <= spent_ms + 0.1);
}

TEST_CASE("a status is written when it changes, and not before it changes again") {
  Pose2 truth;
  Driven robot(std::make_shared<ToldScorer>([&](const Hypothesis& hypothesis, const Observation& seen) {
    const Pose2 T_map_base = seen.T_map_base(hypothesis.T_map_local);
    return Score{distance_m(T_map_base, truth) < 1 ? 5. : -5., {}, {}};
  }));
  std::vector<std::string> changes;
  for (int k = 0; k < 30; ++k) {
    truth = Pose2(2 + 0.2 * k, 4.5, 0.1);
    const auto estimate = robot.drive_to(truth);
    const std::string now = name_of(estimate.value().status);
    if (changes.empty() || changes.back() != now) changes.push_back(now);
  }
  std::vector<std::string> written;
  for (const ordered_json& event : robot.heard.of("status")) written.push_back(event["status"].get<std::string>());
  CHECK(written == changes);
  CHECK(written.size() > 1);
  CHECK(written.back() == "localized");
}

TEST_CASE("a local feature that stays where it is is written when its views have grown by half") {
  Driven robot;
  for (int k = 0; k < 9; ++k) robot.drive_to(Pose2(3 + 0.15 * k, 4.5, 0));
  std::vector<int> written;
  for (const ordered_json& event : robot.heard.of("local_features"))
    for (const ordered_json& feature : event["changed"])
      if (feature["id"] == 0) written.push_back(feature["measurements"].get<int>());
  CHECK(written == std::vector{1, 2, 3, 5, 8});
}

TEST_CASE("a keyframe is written with what its beams passed through") {
  Driven robot;
  const Pose2 T_map_base(3, 4.5, 0.1);
  robot.drive_to(T_map_base);
  const std::vector<Point> outline = free_space_outline(scan_from(*robot.map, T_map_base), T_base_laser);
  const ordered_json written = robot.heard.of("keyframe").front()["free_space"];
  REQUIRE(written.size() == 2 * outline.size());
  for (std::size_t k = 0; k < outline.size(); ++k) {
    CHECK(written[2 * k].get<double>() == Approx(outline[k].x()).margin(0.001));
    CHECK(written[2 * k + 1].get<double>() == Approx(outline[k].y()).margin(0.001));
  }
}

TEST_CASE("after a reset all is written anew, and nothing of before is said to be gone") {
  Driven robot;
  robot.drive_on(4);
  robot.localizer.reset();
  CHECK(robot.localizer.hypotheses().empty());
  robot.heard.all.clear();
  robot.drive_on(1);
  const auto features = robot.heard.of("local_features");
  REQUIRE(features.size() == 1);
  CHECK(features[0]["gone"].empty());
  CHECK(features[0]["changed"].size() == robot.localizer.local_map().features().size());
  CHECK(robot.heard.of("status").size() == 1);
}

TEST_CASE("after a reset a localizer is as new, whatever was before") {
  const Pose2 stuck(4, 4.5, 0.1);
  const auto stand = [&](Driven& robot) {  // odometry does, the robot does not
    for (int k = 0; k < 8; ++k) robot.see_at(stuck * Pose2(0.3 * k, 0, 0.2 * k), stuck);
  };
  const auto drive = [](Driven& robot) { robot.drive_on(20); };
  const auto be_kidnapped = [](Driven& robot) {
    robot.drive_on(20);
    for (int k = 0; k < 3; ++k) robot.see_at(Pose2(2 + 0.25 * k, 1, 2.5), Pose2(8 + 0.25 * k, 4.5, 0.1));
  };
  const auto be_told = [](Driven& robot) { robot.localizer.hint({Pose2(8, 1, 2), 0.2, 0.1}); };
  const auto before = GENERATE_COPY(values<std::function<void(Driven&)>>({stand, drive, be_kidnapped, be_told}));
  Driven used, fresh;
  before(used);
  used.localizer.reset();
  CHECK(used.localizer.sensor_findings().empty());
  used.heard.all.clear();
  used.stamp_s = fresh.stamp_s;
  used.drive_on(20);
  fresh.drive_on(20);
  const std::vector<std::string> again = used.heard.said(), first = fresh.heard.said();
  REQUIRE(again.size() == first.size());
  for (std::size_t k = 0; k < first.size(); ++k) CHECK(again[k] == first[k]);
}

TEST_CASE("a sample says what somebody said before it") {
  const PoseHint there{Pose2(3.1, 4.4, 0.15), 0.2, 0.1};
  Driven asked, told;
  for (Driven* robot : {&asked, &told}) robot->drive_on(4);
  asked.localizer.reset();
  asked.localizer.hint(there);
  told.said = {.forget = true, .hint = there};
  for (Driven* robot : {&asked, &told}) {
    robot->heard.all.clear();
    robot->drive_on(4);
  }
  CHECK(told.heard.of("start").size() == 1);  // who calls reset writes it otherwise
  std::erase_if(told.heard.all, [](const auto& event) { return event["event"] == "start"; });
  CHECK(told.heard.said() == asked.heard.said());
  CHECK(told.localizer.local_map().keyframes().size() == 4);
  const auto began = told.heard.of("spawned");
  CHECK(std::ranges::any_of(began, [](const auto& event) { return event["origin"] == "hint"; }));
}

TEST_CASE("odometry that is no number, or lies beyond the world, is as if it had not come") {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  Driven disturbed, fresh;
  for (const Pose2& odometry : {Pose2(kNan, 0, 0), Pose2(0, 0, kNan), Pose2(1e300, 0, 0), Pose2(0, -1e300, 0)}) {
    CHECK_FALSE(disturbed.see_at(Pose2(3, 4.5, 0.1), odometry));
    disturbed.drive_on(3);
    fresh.stamp_s = disturbed.stamp_s - 1.5;
    fresh.drive_on(3);
  }
  disturbed.stamp_s = kNan;
  CHECK_FALSE(disturbed.drive_to(Pose2(8, 4.5, 0.1)));
  const std::vector<std::string> said = disturbed.heard.said(), expected = fresh.heard.said();
  REQUIRE(said.size() == expected.size());
  for (std::size_t k = 0; k < said.size(); ++k) CHECK(said[k] == expected[k]);
}

TEST_CASE("odometry is corrected by its scale before all else") {
  const Driven robot;
  LocalizerParts parts = robot.parts(fit_scorer(), {});
  parts.odometry.distance = 2;
  Localizer localizer(std::move(parts));
  for (int k = 0; k < 5; ++k) {
    Scan scan = scan_from(*robot.map, Pose2(3 + 0.4 * k, 4.5, 0));
    scan.stamp_s = 100 + 0.5 * k;
    localizer.update(sample_of(std::move(scan), Pose2(0.2 * k, 0, 0), T_base_laser));
  }
  CHECK(localizer.local_map().T_local_base().x() == Approx(1.6));
}

TEST_CASE("features of a laser are placed by its mount") {
  Driven robot;
  const Pose2 T_map_base(3, 4.5, 0.1);
  robot.drive_to(T_map_base);
  const auto& found = robot.localizer.local_map().features();
  REQUIRE(found.size() == detected_from(*robot.map, T_map_base).size());
  const Geometry column = transformed(T_map_base, found[0].feature.geometry);
  CHECK((anchor_of(column) - Point(3, 2.2)).norm() < 1e-6);
}

TEST_CASE("scorers are told the laser of every feature, and the beam and the evidence cell of every return") {
  int told = 0;
  bool all_known = true;
  Driven robot(std::make_shared<ToldScorer>([&](const Hypothesis&, const Observation& seen) {
    told += seen.features.empty() ? 0 : 1;
    all_known = all_known && seen.feature_scans == std::vector<int>(seen.features.size(), 0);
    for (const ObservedScan& scan : seen.scans)
      all_known =
          all_known && scan.beams.size() == scan.points.size() && scan.evidence_cells.size() == scan.points.size();
    return Score{1, {}, {}};
  }));
  robot.drive_on(4);
  CHECK(told > 0);
  CHECK(all_known);
}

TEST_CASE("a scan counts by how far the robot drove and turned since the one before") {
  LocalizerOptions options;
  options.tracking.evidence_memory = 1;
  options.tempering = {1.2, 1.5, 0.05};
  const auto [step, weight] = GENERATE(table<Pose2, double>(
      {{Pose2(0.3, 0, 0), 0.25}, {Pose2(0, 0, 0.3), 0.2}, {Pose2(0.3, 0, -0.3), 0.45}, {Pose2(0.9, 0, 0.6), 1}}));
  Driven robot(constant_scorer(2), options);
  robot.drive_to(Pose2(4, 4.5, 0));
  REQUIRE_FALSE(robot.localizer.hypotheses().empty());
  const HypothesisId best = robot.localizer.hypotheses().front().id;
  const double before = robot.nat_of(best);
  robot.drive_to(Pose2(4, 4.5, 0) * step);
  CHECK(robot.nat_of(best) - before == Approx(2 * weight));
}

TEST_CASE("odometry that stands while the robot drives is found out, and where the robot was then is forgotten") {
  Driven robot;
  robot.drive_on(6);
  const Pose2 stuck(3 + 0.25 * 5, 4.5, 0.1);
  for (int k = 0; k < 8; ++k) robot.see_at(stuck * Pose2(0.3 * k, 0, 0.2 * k), stuck);
  const auto& findings = robot.localizer.sensor_findings();
  REQUIRE(std::any_of(findings.begin(), findings.end(), [](const SensorFinding& finding) {
    return finding.subject == SensorFinding::Subject::standing_odometry;
  }));
  for (const ordered_json& event : robot.heard.of("estimate"))
    if (event.contains("sensor")) CHECK_THAT(event["sensor"].dump(), Catch::Contains("odometry"));
  CHECK_FALSE(robot.heard.of("estimate").front().contains("sensor"));
  const auto moved = robot.see_at(stuck * Pose2(2.5, 0, 1.6), stuck * Pose2(0.3, 0, 0));
  REQUIRE(moved);
  CHECK(moved->status != Status::localized);
  CHECK(robot.localizer.local_map().keyframes().size() == 1);
}

TEST_CASE("who keeps only its pattern keeps of all local features what the best hypothesis began with") {
  Driven robot;
  robot.localizer.keep_pattern();  // there is none, and nothing changes
  robot.drive_on(8);
  std::set<int> began_with;
  const int best = robot.localizer.hypotheses().front().id.number();
  for (const ordered_json& event : robot.heard.of("spawned"))
    if (event["hypothesis"] == best)
      for (const ordered_json& pair : event["pairs"]) began_with.insert(pair[0].get<int>());
  REQUIRE(began_with.size() == 1);
  REQUIRE(robot.localizer.local_map().features().size() == 5);
  robot.localizer.keep_pattern();
  REQUIRE(robot.localizer.local_map().features().size() == 1);
  CHECK(began_with.contains(robot.localizer.local_map().features().front().id.number()));
}
