// What each event holds, as docs/events.md says; of decisions that are given, not found.
#include "localization/events/run_journal.hpp"
#include "tests/localization/driven_robot.hpp"
#include "tests/localization/search/searching.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::synthetic;

namespace {

/// Has something to say against everything.
struct Critic : HypothesisScorer {
  Score score(const Hypothesis&, const Observation&, const MapView&, const ScorerMemory*) const override { return {}; }
  std::vector<Finding> explain(const Hypothesis&, const Observation&, const MapView&) const override {
    return {{"it is odd", {}, {}}, {"a wall is gone", MapFeatureNumber(1), {{1, 2}, {3, 4}}}};
  }
};

const ordered_json kFindings = ordered_json::parse(
    R"([{"scorer":"critic","words":"it is odd"},
        {"scorer":"critic","words":"a wall is gone","map_feature":"k1-shape","line":[1.0,2.0,3.0,4.0]}])");
const ordered_json kScores = ordered_json::parse(R"({"critic":{"walls":1.5,"ends":-0.5}})");
const ordered_json kPairs = ordered_json::parse(R"([[4,"k2-shape"],[5,null]])");

/// A journal at keyframe 3, and a hypothesis of which it writes.
struct Journal {
  Journal() {
    live.hypothesis.id = HypothesisId(7);
    live.hypothesis.T_map_local = Pose2(1, 2, 0.5);
    live.hypothesis.log_likelihood = 12.5;
    live.hypothesis.associations = pairs;
    live.scan_nat = -2;
    live.scores = {{-2, "", {{"walls", 1.5}, {"ends", -0.5}}}};
    begin({});
  }
  void begin(const Scan& scan) {
    Sample sample = sample_of(scan, Pose2());
    sample.stamp_s = 100.5;
    journal.keyframe(sample, KeyframeId(3), observation);
  }
  /// The newest event, but for what all events have.
  ordered_json said() const {
    ordered_json event = heard.all.back();
    CHECK(event["stamp_s"] == 100.5);
    CHECK(event["keyframe"] == 3);
    event.erase("stamp_s");
    event.erase("keyframe");
    return event;
  }
  std::vector<Association> pairs{{LocalFeatureId(4), MapFeatureNumber(2)}, {LocalFeatureId(5), {}}};
  std::shared_ptr<const MapView> map = view_of(room());
  Judges judges{map, {{"critic", std::make_shared<Critic>(), ScorerRole::decides, 1}}};
  GlobalSearch search{map, {corners()}, judges.ensemble, {}};
  LocalMap local_map{{}, nullptr};
  Observation observation{local_map, {}};
  Heard heard;
  RunJournal journal{heard, map, judges.ensemble, search};
  Live live;
};

}  // namespace

TEST_CASE("the beginning of a hypothesis is written with where it is, what it rests on, and what it comes from") {
  Journal told;
  told.journal.spawned(told.live, {Origin::branch, {}, HypothesisId(2)});
  CHECK(told.said() == ordered_json{{"event", "spawned"},
                                    {"hypothesis", 7},
                                    {"parent", 2},
                                    {"origin", "branch"},
                                    {"T_map_base", {1.0, 2.0, 0.5}},
                                    {"log_likelihood", 12.5},
                                    {"pairs", kPairs}});
  told.journal.spawned(told.live, {Origin::pattern, TemplateNumber(0), {}});
  CHECK(told.said()["template"] == "corner");
  CHECK_FALSE(told.said().contains("parent"));
}

TEST_CASE("the end of a hypothesis is written with all that it had gathered, and what speaks against it") {
  Journal told;
  told.journal.ended(told.live, {"far behind", {}});
  CHECK(told.said() == ordered_json{{"event", "pruned"},
                                    {"hypothesis", 7},
                                    {"reason", "far behind"},
                                    {"T_map_base", {1.0, 2.0, 0.5}},
                                    {"log_likelihood", 12.5},
                                    {"scan_nat", -2.0},
                                    {"scores", kScores},
                                    {"findings", kFindings}});
  told.journal.ended(told.live, {"same place", HypothesisId(1)});
  CHECK(told.said()["merged_into"] == 1);
  CHECK(told.said()["findings"].empty());  // nothing speaks against the place
}

TEST_CASE("what becomes of associations is written with the hypothesis, the features, and the reason") {
  Journal told;
  told.journal.associated(told.live, told.pairs);
  CHECK(told.said() == ordered_json{{"event", "associated"}, {"hypothesis", 7}, {"pairs", kPairs}});
  told.journal.dissociated(told.live, {LocalFeatureId(4), LocalFeatureId(5)}, "forgotten");
  CHECK(told.said() ==
        ordered_json{{"event", "dissociated"}, {"hypothesis", 7}, {"local_features", {4, 5}}, {"reason", "forgotten"}});
  told.journal.branch_rejected(told.live, told.pairs[0], "does not fit");
  CHECK(told.said() == ordered_json{{"event", "rejected"},
                                    {"hypothesis", 7},
                                    {"pairs", ordered_json::array({kPairs[0]})},
                                    {"reason", "does not fit"}});
}

TEST_CASE("a search is written with what was looked up, and with the places that it refused") {
  Journal told;
  VerifiedCandidate refused{{Pose2(4, 5, 1), Origin::pattern, TemplateNumber(0), told.pairs}, -3.5};
  told.journal.candidate_rejected(refused, "worse");
  const std::vector<CandidateGenerator::LookedUp> looked_up{{TemplateNumber(0), {LocalFeatureId(4)}, 6}};
  told.journal.searched(looked_up, 8);
  const ordered_json patterns{{{"template", "corner"}, {"local_features", {4}}, {"candidates", 6}}};
  const ordered_json rejected{{{"origin", "pattern"},
                               {"template", "corner"},
                               {"T_map_base", {4.0, 5.0, 1.0}},
                               {"pairs", kPairs},
                               {"nat", -3.5},
                               {"reason", "worse"}}};
  CHECK(told.said() ==
        ordered_json{{"event", "searched"}, {"patterns", patterns}, {"proposed", 8}, {"rejected", rejected}});
  told.journal.searched({}, 0);
  CHECK(told.said()["rejected"].empty());
  told.journal.candidate_rejected(refused, "worse");
  told.begin({});
  told.journal.searched({}, 0);
  CHECK(told.said()["rejected"].empty());  // it was of the update before
}

TEST_CASE("an answer is written with its reason, its place, and every hypothesis") {
  Journal told;
  PoseEstimate estimate;
  estimate.status = Status::ambiguous;
  estimate.T_map_base = Pose2(1, 2, 0.5);
  estimate.has_pose = true;
  estimate.probability = 0.75;
  estimate.best = HypothesisId(7);
  estimate.place = {"b", "s", Pose2(3, 4, 0.25)};
  told.journal.sensor(
      {{SensorFinding::Subject::mirroring, SensorFinding::Verdict::fine, 1, 1, 0, "all is well"},
       {SensorFinding::Subject::mount_heading, SensorFinding::Verdict::doubtful, 1, 1, 0, "it is turned"}});
  told.journal.estimate(estimate, {told.live}, {{0.625}, 0.125, "who knows"});
  REQUIRE(told.heard.of("estimate").size() == 1);
  const ordered_json written = told.heard.of("estimate").front();
  const ordered_json row{{"hypothesis", 7},  {"T_map_base", {1.0, 2.0, 0.5}}, {"log_likelihood", 12.5},
                         {"scan_nat", -2.0}, {"probability", 0.625},          {"scores", kScores}};
  CHECK(written == ordered_json{{"event", "estimate"},
                                {"stamp_s", 100.5},
                                {"keyframe", 3},
                                {"status", "ambiguous"},
                                {"probability", 0.75},
                                {"none", 0.125},
                                {"why", "who knows"},
                                {"hypothesis", 7},
                                {"T_map_base", {1.0, 2.0, 0.5}},
                                {"place", {{"building", "b"}, {"storey", "s"}, {"T_storey_base", {3.0, 4.0, 0.25}}}},
                                {"hypotheses", ordered_json::array({row})},
                                {"findings", kFindings},
                                {"sensor", ordered_json::array({"it is turned"})}});
  CHECK(told.said() ==
        ordered_json{{"event", "status"}, {"status", "ambiguous"}, {"probability", 0.75}, {"hypothesis", 7}});
}

TEST_CASE("findings about the sensor are written until others come, or the localizer is reset") {
  Journal told;
  const auto sensor_of_next = [&] {
    told.journal.estimate({}, {}, {});
    const ordered_json written = told.heard.of("estimate").back();
    return written.contains("sensor") ? written["sensor"].size() : 0;
  };
  const SensorFinding finding{SensorFinding::Subject::mirroring, SensorFinding::Verdict::contradicted, -1, 1, 0, "!"};
  told.journal.sensor({finding});
  CHECK(sensor_of_next() == 1);
  CHECK(sensor_of_next() == 1);
  told.journal.sensor({finding, finding});
  CHECK(sensor_of_next() == 2);
  told.journal.reset();
  CHECK(sensor_of_next() == 0);
  CHECK(told.heard.of("status").size() == 2);  // and the status is written again
}

TEST_CASE("each stage is written with its own time, in milliseconds") {
  Journal told;
  told.journal.cost({.001, .002, .003, .004, .005, .006, .007, .008, .009}, .045);
  CHECK(told.said()["cpu_ms"] == ordered_json{{"sensor", 1.0},
                                              {"detect", 2.0},
                                              {"local_map", 3.0},
                                              {"track", 4.0},
                                              {"generate", 5.0},
                                              {"search", 6.0},
                                              {"retrospect", 7.0},
                                              {"grow", 8.0},
                                              {"status", 9.0},
                                              {"total", 45.0}});
}
