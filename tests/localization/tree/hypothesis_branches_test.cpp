#include "tests/localization/tree/hypotheses_on_a_line.hpp"

using namespace opal;
using namespace opal::synthetic;

namespace {

/// Says of a hypothesis' last association what it remembers of it.
struct AssociationMemory : CountingScorer {
  Score score(const Hypothesis& hypothesis, const Observation&, const MapView&, const ScorerMemory*) const override {
    auto seen = std::make_shared<CountMemory>();
    seen->count = hypothesis.associations.empty() ? 0 : 100 + hypothesis.associations.back().map_feature.number();
    return {0, {}, {}, std::move(seen)};
  }
  void fade(ScorerMemory&, double) const override {}
};

}  // namespace

TEST_CASE("a feature with two mapped ones near it makes two hypotheses: one goes on, the other begins") {
  Line line(branching(2), {column(0.8, 0), column(1.2, 0), column(9, 9)});
  line.spawn({0});
  line.see({column(1.02, 0)}, Pose2());
  line.grow();
  REQUIRE(line.set.alive().size() == 2);
  std::set<MapFeatureNumber> paired;
  for (const Live& live : line.set.alive()) {
    REQUIRE(live.hypothesis.associations.size() == 1);
    paired.insert(live.hypothesis.associations.front().map_feature);
    CHECK(line.set.tree().branch(live.leaf).size() == 1);
  }
  CHECK(paired == std::set{MapFeatureNumber(0), MapFeatureNumber(1)});
  CHECK(line.listener.parents.at(HypothesisId(1)) == HypothesisId(0));
  check_heard(line.listener, line.set.alive());
}

TEST_CASE("hypotheses that branched remember for themselves from then on") {
  LocalizerOptions options = branching(2);
  options.growth.register_by_associations = true;  // else they are at one place, and one again
  Line line(options, {corner(0.7, 0), corner(1.3, 0)}, std::make_shared<AssociationMemory>());
  line.spawn({0});
  line.see({corner(1.02, 0)}, Pose2());
  line.grow();
  REQUIRE(line.set.alive().size() == 2);
  const Hypothesis &a = line.set.alive()[0].hypothesis, &b = line.set.alive()[1].hypothesis;
  CHECK(a.memories.of(1) == b.memories.of(1));
  const double before = count_of(a, 1);
  line.track();
  REQUIRE(line.set.alive().size() == 2);
  for (const Live& live : line.set.alive())
    CHECK(count_of(live.hypothesis, 1) == before + 100 + live.hypothesis.associations.back().map_feature.number());
}

TEST_CASE("branches that stay at one place are one hypothesis again with the next scan") {
  Line line(branching(2), {column(0.8, 0), column(1.2, 0)});
  line.spawn({0});
  line.see({column(1.02, 0)}, Pose2());
  line.grow();
  REQUIRE(line.set.alive().size() == 2);
  line.track();
  CHECK(line.set.alive().size() == 1);
  check_heard(line.listener, line.set.alive());
}

TEST_CASE("a feature with nothing mapped near it is not on the map, and is said once") {
  Line line({}, {column(50, 0)});
  line.spawn({0});
  line.see({column(1, 0)}, Pose2());
  line.grow();
  line.grow();
  REQUIRE(line.set.alive().size() == 1);
  REQUIRE(line.set.alive().front().hypothesis.associations.size() == 1);
  CHECK_FALSE(line.set.alive().front().hypothesis.associations.front().map_feature.exists());
  CHECK(line.listener.pairs_heard.at(HypothesisId(0)) == 1);
}

TEST_CASE("tracking lets scorers' memories fade before it adds to them") {
  Line line({}, {column(0, 50)}, std::make_shared<CountingScorer>());
  line.spawn({0});
  CHECK(count_of(line.set.alive().front().hypothesis, 1) == 1);
  line.track(0.5);
  CHECK(count_of(line.set.alive().front().hypothesis, 1) == Approx(0.75 * 1 + 0.5));
}

TEST_CASE("associations move a hypothesis where they fix its pose, and nowhere else") {
  LocalizerOptions options = branching(2);
  options.growth.register_by_associations = true;
  const auto place_after = [&](const Feature& mapped, const Feature& seen) {
    Line line(options, {mapped});
    line.spawn({0});
    line.see({seen}, Pose2());
    line.grow();
    return line.set.alive().at(0).hypothesis.T_map_local.x();
  };
  CHECK(place_after(corner(1.3, 0), corner(1, 0)) == Approx(0.3));
  CHECK(place_after(column(1.3, 0), column(1, 0)) == 0);  // it may be turned about the column
}

TEST_CASE("what the local map has forgotten, hypotheses forget") {
  Line line({}, {column(1, 0)});
  line.spawn({0});
  line.see({column(1, 0)}, Pose2());
  line.grow();
  line.set.forget(line.local_map);
  CHECK(line.set.alive().front().hypothesis.associations.size() == 1);
  line.local_map.keep_only({});
  line.set.forget(line.local_map);
  CHECK(line.set.alive().front().hypothesis.associations.empty());
  CHECK(line.listener.dissociations == 1);
}

TEST_CASE("a branch of too many features that are not on the map ends") {
  LocalizerOptions options = branching(1, true);
  options.growth.max_consecutive_not_on_map = 2;
  Line line(options, {column(50, 0)});
  line.spawn({0});
  line.see({column(1, 0), column(2, 0), column(3, 0)}, Pose2());
  line.grow();
  CHECK(line.set.alive().empty());
  CHECK(line.set.tree().size() == 0);
  check_heard(line.listener, line.set.alive());
}

TEST_CASE("too many features that are not on the map end a hypothesis that never branches, too") {
  LocalizerOptions options;
  options.growth.max_consecutive_not_on_map = 2;
  Line line(options, {column(50, 0)});
  line.spawn({0});
  line.see({column(1, 0), column(2, 0), column(3, 0)}, Pose2());
  line.grow();
  line.track();
  CHECK(line.set.alive().empty());
}
