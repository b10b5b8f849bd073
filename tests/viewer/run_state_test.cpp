#include "viewer/reading/run_state.hpp"
#include "recorded_run.hpp"

#include <catch2/catch.hpp>

#include <set>

using namespace opal;
using namespace opal::synthetic;

namespace {

/// Everything that a state holds, as text.
std::string described(const RunState& state) {
  std::ostringstream out;
  const auto life = [&](const TracedHypothesis& h) {
    out << h.id << ' ' << h.parent << ' ' << h.spawned_s << ' ' << h.T_map_base.x() << ' ' << h.log_likelihood << ' '
        << h.probability << ' ' << h.highest_probability << '@' << h.highest_s;
    for (const Association& pair : h.pairs) out << ' ' << pair.local_feature << "->" << pair.map_feature;
    out << '\n';
  };
  out << state.time_line() << ' ' << state.frames() << '\n';
  for (const auto& [id, h] : state.alive()) life(h);
  for (const EndedHypothesis& ended : state.ended()) {
    out << "ended " << ended.end_s << ' ' << ended.end.reason << ' ';
    life(ended.life);
  }
  for (const auto& [id, f] : state.local_features())
    out << 'f' << id << ' ' << f.stable << f.measurements << ' ' << anchor_of(f.geometry).transpose() << '\n';
  out << state.trajectory().size() << ' ' << state.truth().size();
  return out.str();
}

constexpr HypothesisId kThird{3};

/// @param map_feature  -1: not on the map.
Association pair_of(int local_feature, int map_feature) {
  return {LocalFeatureId(local_feature), MapFeatureNumber(map_feature)};
}

}  // namespace

TEST_CASE("the state after a frame is that of its time line alone, from its first frame on") {
  const ReadRun run = frames_of({90, 40, 4, 3});
  RunState going_on;
  for (std::size_t k = 0; k < run.frames.size(); ++k) {
    going_on.apply(run.frames[k]);
    if (k % 7 != 0) continue;
    RunState anew;
    for (std::size_t j = k / 30 * 30; j <= k; ++j) anew.apply(run.frames[j]);
    REQUIRE(described(going_on) == described(anew));
  }
}

TEST_CASE("who is alive is who the estimate lists, and nobody is both alive and ended") {
  RunState state;
  for (const RunFrame& frame : frames_of({200, 60, 4}).frames) {
    state.apply(frame);
    std::set<HypothesisId> listed, alive;
    for (const RecordedHypothesis& row : frame.hypotheses) listed.insert(row.id);
    for (const auto& [id, hypothesis] : state.alive()) alive.insert(id);
    REQUIRE(alive == listed);
    for (const EndedHypothesis& ended : state.ended()) REQUIRE_FALSE(alive.contains(ended.life.id));
    REQUIRE(state.best());
  }
  CHECK(state.trajectory().size() == 200);
}

TEST_CASE("a hypothesis has the associations that it was spawned with and grew, without those it lost") {
  RunState state;
  RunFrame frame;
  frame.starts = "run";
  frame.spawns = {{kThird, {}, "opal:Row", {}, 1, {pair_of(1, 5), pair_of(2, -1)}}};
  frame.hypotheses = {{kThird, {}, 1, 0, 0.5, {}}};
  state.apply(frame);
  frame = {};
  frame.hypotheses = {{kThird, {}, 1, 0, 0.5, {}}};
  frame.losses = {{kThird, {LocalFeatureId(1)}, "gone"}};
  frame.growths = {{kThird, {pair_of(4, 7), pair_of(2, 6)}}};
  state.apply(frame);
  const auto& pairs = state.alive().at(kThird).pairs;
  REQUIRE(pairs.size() == 2);
  for (const auto& [k, expected] : {std::pair{0, pair_of(4, 7)}, std::pair{1, pair_of(2, 6)}}) {
    CHECK(pairs[k].local_feature == expected.local_feature);
    CHECK(pairs[k].map_feature == expected.map_feature);
  }
}

TEST_CASE("a long time line is remembered in bounded memory; what was likely once stays") {
  RunState state;
  RunFrame frame;
  frame.starts = "run";
  for (int id = 0; id < 12'000; ++id) {
    frame.spawns = {{HypothesisId(id), {}, "", {}, 0, {}}};
    frame.hypotheses = {{HypothesisId(id), {}, 0, 0, id == 100 ? 0.9 : 1e-4 * (id % 7), {}}};
    frame.ends.clear();
    if (id > 0) frame.ends = {{HypothesisId(id - 1), "worse", {}, {}, 0, 0, {}, {}}};
    state.apply(frame);
    frame.starts.reset();
  }
  CHECK(state.ended().size() <= RunState::kMostEnded);
  const auto& ended = state.ended();
  CHECK(std::any_of(ended.begin(), ended.end(), [](const auto& e) { return e.life.id == HypothesisId(100); }));
  CHECK(ended.back().life.id == HypothesisId(11'998));
}
