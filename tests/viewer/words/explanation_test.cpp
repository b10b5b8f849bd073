#include "made_frames.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using Texts = std::vector<std::string>;

namespace {

const Pose2 kHere(4, -2, 0.5), kThere(12.1, 3.4, 0);

/// A best hypothesis that stands where the local map says, with a spawn and associations.
RunFrame first_frame() {
  RunFrame frame = with(frame_at(0, "searching", 0.5, 0.4), {hypothesis(7, kHere, 0.5, 2)});
  frame.changed = {{LocalFeatureId(0), "opal:Wall", true, 4, Segment{{7, -0.03}, {1, -0.03}}},
                   {LocalFeatureId(1), "opal:Column", true, 4, Circle{{2.1, -3}, 0.3}},
                   {LocalFeatureId(2), "opal:Column", false, 1, Circle{{8, -3}, 0.3}},
                   {LocalFeatureId(3), "opal:Column", true, 5, Circle{{5, -3}, 0.3}}};
  frame.spawns = {{HypothesisId(7), {}, "opal:LinePair", kHere, 2, {{LocalFeatureId(0), kWallFace}, {{}, kColumnB}}}};
  frame.growths = {{HypothesisId(7), {{LocalFeatureId(1), kColumnA}, {LocalFeatureId(3), {}}}}};
  return frame;
}

RunFrame later(double time_s, const std::string& status = "localized") {
  return with(frame_at(time_s, status, 0.98, 0.01), {hypothesis(7, kHere, 0.98, 30)});
}

RecordedEnd ended(int id, const std::string& reason) {
  RecordedEnd end;
  end.id = HypothesisId(id);
  end.reason = reason;
  end.T_map_base = kThere;
  return end;
}

}  // namespace

TEST_CASE("nothing is said before the first frame") {
  const RunHeader header = hall();
  CHECK(Explainer(header).explanation().empty());
}

TEST_CASE("the answer says since when, where, and how sure") {
  CHECK(
      sentences_of(SentenceKind::answer, {first_frame(), later(1.5), later(2.5), later(3.5)}) ==
      Texts{
          "localized since 1.5 s: at (4.00, -2.00), heading 28.6 deg, with probability 0.980 (hypothesis 7, 1 alive); "
          "\"none of these\" has 0.010"});
}

TEST_CASE("without a hypothesis the answer says so") {
  CHECK(sentences_of(SentenceKind::answer, {with(frame_at(0, "searching", 0, 1), {})}) ==
        Texts{"searching since 0.0 s: no hypothesis is alive; \"none of these\" has 1.000"});
}

TEST_CASE("objects that the best hypothesis rests on are named, the nearest first, with their distances now") {
  CHECK(sentences_of(SentenceKind::support, {first_frame()}) ==
        Texts{"rests on 2 associations with 2 objects: Wall wall-1 (0.03 m), Column A.008 (0.10 m)",
              "spawned at 0.0 s from opal:LinePair"});
  RunFrame moved = later(1);
  moved.hypotheses.front().T_map_base = Pose2(0, 0.13, 0) * kHere;
  CHECK(sentences_of(SentenceKind::support, {first_frame(), moved}).front() ==
        "rests on 2 associations with 2 objects: Wall wall-1 (0.10 m), Column A.008 (0.16 m)");
}

TEST_CASE("what is not on the map neither supports a hypothesis nor speaks against it: it is noted") {
  CHECK(sentences_of(SentenceKind::note, {first_frame(), later(1)}) ==
        Texts{"takes 1 local feature for not on the map: 3"});
}

TEST_CASE("objects have the names that people gave them, and their ids if a name is not the only one") {
  RunHeader header = hall();
  header.objects[0].name = "Hall, north";
  header.objects[1].name = "Column";
  header.objects[1].name_is_shared = true;
  Explainer explainer(header);
  explainer.take(first_frame());
  CHECK_THAT(explainer.explanation()[1].text,
             Catch::Contains("Wall \"Hall, north\" (0.03 m), Column \"Column\" (A.008) (0.10 m)"));
}

TEST_CASE("a place that is found and not proven yet is said to be so, and what it waits for") {
  RunFrame frame = with(frame_at(0, "searching", 1, 0), {hypothesis(7, kHere, 1, 9)});
  frame.why = "the best place has just changed";
  const Texts answer = sentences_of(SentenceKind::answer, {frame});
  REQUIRE(answer.size() == 2);
  CHECK_THAT(answer[0], Catch::StartsWith("searching (a place is found, but not proven yet) since 0.0 s: at (4.00"));
  CHECK(answer[1] == "not localized yet, it waits for more evidence: the best place has just changed");
  CHECK(sentences_of(SentenceKind::answer, {first_frame(), later(1)}).size() == 1);
}

TEST_CASE("where the sensor is not as described, more evidence is not waited for") {
  RunFrame frame = with(frame_at(0, "searching", 1, 0), {hypothesis(7, kHere, 1, 9)});
  frame.why = "the laser looks -1.5 degrees, and is described at 179.9";
  frame.sensor = {frame.why};
  const Texts answer = sentences_of(SentenceKind::answer, {frame});
  REQUIRE(answer.size() == 2);
  CHECK(answer[1] == "the sensor is not as described, so nothing is called localized: " + frame.why);
}

TEST_CASE("an association that ended is not what it rests on, a new one of the same local feature is") {
  RunFrame frame = later(1);
  frame.losses = {{HypothesisId(7), {LocalFeatureId(0), LocalFeatureId(1)}, "it no longer fits"}};
  frame.growths = {{HypothesisId(7), {{LocalFeatureId(1), kColumnB}}}};
  CHECK(sentences_of(SentenceKind::support, {first_frame(), frame}).front() ==
        "rests on 1 association with 1 object: acme:Column B (5.90 m)");
}

TEST_CASE("what is known of a spawn only is said if it is recorded") {
  CHECK(sentences_of(SentenceKind::support, {later(0)}).empty());
  RunFrame branch = later(0);
  branch.spawns = {{HypothesisId(7), HypothesisId(3), "", kHere, 2, {}}};
  CHECK(sentences_of(SentenceKind::support, {branch}) == Texts{"branched from hypothesis 3 at 0.0 s"});
}

TEST_CASE("findings are repeated word for word, the weightiest ones") {
  RunFrame frame = later(1);
  frame.findings = {{"acme:X", "beam 221 passes 1.8 m through wall wall-1", kWallFace, {}},
                    {"acme:Y", "50 % <b>odd</b>", {}, {}},
                    {"acme:Z", "third", {}, {}},
                    {"acme:Z", "fourth", {}, {}}};
  CHECK(sentences_of(SentenceKind::against, {first_frame(), frame}) ==
        Texts{"beam 221 passes 1.8 m through wall wall-1; 50 % <b>odd</b>; and 2 more findings"});
  frame.findings.clear();
  CHECK(sentences_of(SentenceKind::against, {first_frame(), frame}).empty());
  frame.hypotheses.front().scan_nat = -0.5;
  CHECK(sentences_of(SentenceKind::against, {first_frame(), frame}) == Texts{"the newest scan scores -0.50 nat"});
}

TEST_CASE("alternatives at other places are compared with the best one by what the scorers recorded for both") {
  RunFrame frame =
      with(frame_at(0, "ambiguous", 0.7, 0.05),
           {hypothesis(7, kHere, 0.7, 15.3, {{"opal:Beams", "hit", 0.88}, {"opal:Beams", "through", 0.02}}),
            hypothesis(8, kThere, 0.12, 12.1, {{"opal:Beams", "hit", 0.44}, {"opal:Beams", "through", 0.31}}),
            hypothesis(9, Pose2(4.1, -2, 0.5), 0.1, 12, {}), hypothesis(10, kThere, 0.001, 3, {})});
  CHECK(
      sentences_of(SentenceKind::alternative, {frame}) ==
      Texts{
          "hypothesis 8 at (12.10, 3.40), heading 0.0 deg has probability 0.120: beams on mapped surfaces 44 %, of the "
          "best one 88 %; beams through mapped surfaces 31 %, of the best one 2 %; gathered 12.10 nat, the best one "
          "15.30 nat"});
}

TEST_CASE("terms of scorers that are not known are given by name and value, whichever is larger") {
  RunFrame frame =
      with(frame_at(0, "ambiguous", 0.7, 0.05),
           {hypothesis(7, kHere, 0.7, 15, {{"acme:X", "fit", 1}, {"acme:X", "same", 2}, {"acme:X", "only", 2}}),
            hypothesis(8, kThere, 0.2, 12, {{"acme:X", "fit", 4}, {"acme:X", "same", 2}})});
  CHECK(sentences_of(SentenceKind::alternative, {frame}).front() ==
        "hypothesis 8 at (12.10, 3.40), heading 0.0 deg has probability 0.200: acme:X fit 4.00, of the best one 1.00; "
        "gathered 12.00 nat, the best one 15.00 nat");
}

TEST_CASE("two alternatives are named and the rest are counted") {
  std::vector<RecordedHypothesis> all{hypothesis(0, kHere, 0.5, 9)};
  for (int k = 1; k < 6; ++k) all.push_back(hypothesis(k, Pose2(5.0 * k, 50, 0), 0.1, 5));
  const Texts alternatives = sentences_of(SentenceKind::alternative, {with(frame_at(0, "ambiguous", 0.5, 0), all)});
  REQUIRE(alternatives.size() == 3);
  CHECK(alternatives.back() == "3 more alternatives with at least 0.010");
}

TEST_CASE("an alternative that fell is told with place, time, reason and finding") {
  RunFrame before = first_frame(), now = later(14.2);
  before.hypotheses.push_back(hypothesis(12, kThere, 0.3, 1));
  now.ends = {ended(12, "worse than the best by more than 17 nat")};
  now.ends.front().findings = {{"opal:Beams", "beam 221 passes 1.8 m through wall wall-1", kWallFace, {}},
                               {"opal:Beams", "second", {}, {}}};
  CHECK(sentences_of(SentenceKind::fell, {before, now, later(20)}) ==
        Texts{"hypothesis 12 at (12.10, 3.40) fell at 14.2 s: worse than the best by more than 17 nat; beam 221 passes "
              "1.8 m "
              "through wall wall-1; and 1 more finding; it had 0.300 at 0.0 s"});
}

TEST_CASE("who merged with another hypothesis, or never mattered, has not fallen") {
  RunFrame before = first_frame(), now = later(1);
  before.hypotheses.push_back(hypothesis(12, kThere, 0.3, 1));
  before.hypotheses.push_back(hypothesis(13, kThere, 0.003, 1));
  now.ends = {ended(12, "same place as hypothesis 7"), ended(13, "worse")};
  now.ends.front().merged_into = HypothesisId(7);
  CHECK(sentences_of(SentenceKind::fell, {before, now}).empty());
}

TEST_CASE("former best ones are told first, the latest of them first") {
  std::vector<RunFrame> frames;
  for (int leader : {1, 2})
    frames.push_back(with(frame_at(leader - 1, "ambiguous", 0.3, 0.1),
                          {hypothesis(leader, kThere, 0.3, 3), hypothesis(3 - leader, kHere, 0.1, 2),
                           hypothesis(5, kThere, 0.25, 1), hypothesis(7, kHere, 0.1, 1)}));
  frames.push_back(later(9));
  frames.back().ends = {ended(5, "c"), ended(1, "a"), ended(2, "b")};
  const Texts fell = sentences_of(SentenceKind::fell, frames);
  REQUIRE(fell.size() == 2);
  CHECK(fell[0] ==
        "hypothesis 2 at (12.10, 3.40) fell at 9.0 s: b; it had 0.300 at 1.0 s and was the best until 1.0 s");
  CHECK(fell[1] ==
        "hypothesis 1 at (12.10, 3.40) fell at 9.0 s: a; it had 0.300 at 0.0 s and was the best until 0.0 s");
}

TEST_CASE("while it searches, it tells what it looked for and why nothing came of it") {
  RunFrame frame = with(frame_at(0, "searching", 0.05, 0.93), {hypothesis(7, kHere, 0.05, 1)});
  frame.scan.assign(12, Point(1, 1));
  frame.changed = {{LocalFeatureId(0), "opal:Wall", true, 4, Segment{{7, 0}, {1, 0}}},
                   {LocalFeatureId(1), "opal:Wall", false, 1, Segment{{7, 0}, {1, 0}}}};
  CHECK(sentences_of(SentenceKind::note, {frame}) ==
        Texts{"\"none of these\" is more probable than the best hypothesis", "no search is recorded so far",
              "the scan has 12 points (thinned), the local map 2 features, 1 of them stable"});
  frame.search.emplace();
  frame.search->patterns = {{"opal:LinePair", {LocalFeatureId(0), LocalFeatureId(1)}, 20},
                            {"opal:CornerPose", {LocalFeatureId(1)}, 4},
                            {"opal:LinePair", {LocalFeatureId(1), LocalFeatureId(2)}, 1}};
  frame.search->proposed = 80;
  frame.search->rejected = {{"opal:LinePair", kHere, {}, -3, "worse"},
                            {"opal:LinePair", kThere, {}, 2.1, "veto by acme:X"}};
  CHECK(
      sentences_of(SentenceKind::note, {frame, with(frame_at(2, "lost", 0.9, 0.1), frame.hypotheses)}).front() ==
      "last search, at 0.0 s: looked up 3 patterns (opal:CornerPose: 1, with 4 candidates; opal:LinePair: 2, with 21 "
      "candidates), 80 places proposed, 2 rejected, the best of these at (12.10, 3.40) with 2.10 nat: veto by acme:X");
  CHECK(sentences_of(SentenceKind::note, {frame, later(2)}).empty());
}

TEST_CASE("the recorded truth is told if it is known") {
  RunFrame frame = later(0);
  frame.truth = Pose2(4, -1.5, 0.5);
  CHECK(sentences_of(SentenceKind::note, {frame}) == Texts{"the recorded truth is 0.50 m and 0.0 deg away"});
}

TEST_CASE("a new time line begins with nothing known") {
  RunFrame anew = later(0);
  anew.hypotheses.front() = hypothesis(9, kHere, 0.98, 30);
  anew.best = HypothesisId(9);
  anew.starts = "second";
  const RunHeader header = hall();
  Explainer after(header), alone(header);
  for (const RunFrame& frame : {first_frame(), later(3), anew}) after.take(frame);
  alone.take(anew);
  CHECK(words_of(after.explanation()) == words_of(alone.explanation()));
}
