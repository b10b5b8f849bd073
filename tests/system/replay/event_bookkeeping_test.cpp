#include "event_recorder.hpp"
#include "recorded_site.hpp"

#include <catch2/catch.hpp>

#include <map>
#include <set>

using namespace opal;
using nlohmann::ordered_json;

// Laws that the event stream obeys: whoever keeps the books from the events alone has what the localizer has.

namespace {

using Pair = std::pair<LocalFeatureId, std::string>;  ///< local feature, mapped feature ("" for "not on the map")

/// Books kept from events alone.
struct Books {
  std::map<HypothesisId, std::set<Pair>> associations;  ///< by hypothesis that is alive
  std::map<LocalFeatureId, ordered_json> local_features;

  void take(const ordered_json& e) {
    const std::string kind = e["event"];
    if (kind == "spawned") {
      REQUIRE(associations.count(e["hypothesis"]) == 0);
      associations[e["hypothesis"]];
      add(e);
    } else if (kind == "associated") {
      REQUIRE(associations.count(e["hypothesis"]) == 1);
      add(e);
    } else if (kind == "dissociated") {
      auto& pairs = associations.at(e["hypothesis"]);
      for (LocalFeatureId local : e["local_features"])
        std::erase_if(pairs, [&](const Pair& p) { return p.first == local; });
    } else if (kind == "pruned") {
      REQUIRE(associations.erase(e["hypothesis"]) == 1);
    } else if (kind == "local_features") {
      for (const auto& changed : e["changed"]) local_features[changed["id"]] = changed;
      for (LocalFeatureId id : e["gone"]) REQUIRE(local_features.erase(id) == 1);
    }
  }

 private:
  void add(const ordered_json& e) {
    for (const auto& pair : e["pairs"])
      associations[e["hypothesis"]].emplace(pair[0].get<LocalFeatureId>(),
                                            pair[1].is_null() ? "" : pair[1].get<std::string>());
  }
};

std::set<HypothesisId> alive_in(const ordered_json& estimate) {
  std::set<HypothesisId> ids;
  for (const auto& row : estimate["hypotheses"]) ids.insert(row["hypothesis"].get<HypothesisId>());
  return ids;
}

LocalizerParts parts_of(const RecordedSite& site, const std::string& config) {
  LocalizerParts parts = site.parts();
  if (config == "branching") {
    parts.stages.growth.max_branches = 2;
    parts.stages.growth.branch_not_on_map = true;
    parts.stages.growth.register_by_associations = true;
    parts.stages.growth.similar_depth = 4;
    parts.stages.hypotheses.max_hypotheses = 60;
  }
  return parts;
}

}  // namespace

TEST_CASE("hypotheses, associations and local features can be followed from events alone") {
  const RecordedSite site("malaga-demo");
  const std::string config = GENERATE("single", "branching");
  CAPTURE(config);
  EventRecorder recorder;
  Localizer localizer(parts_of(site, config), &recorder);
  Books books;
  std::size_t read = 0;
  for (const Sample& sample : site.samples) {
    localizer.update(sample);
    for (; read < recorder.events.size(); ++read) {
      const ordered_json& e = recorder.events[read];
      CAPTURE(read, e["event"], e["keyframe"]);
      books.take(e);
      if (e["event"] != "estimate") continue;
      std::set<HypothesisId> known;
      for (const auto& [id, pairs] : books.associations) known.insert(id);
      REQUIRE(alive_in(e) == known);
    }
  }
  const SemanticMap& map = localizer.map().map();
  REQUIRE(books.associations.size() == localizer.hypotheses().size());
  for (const Hypothesis& hypothesis : localizer.hypotheses()) {
    std::set<Pair> pairs;
    for (const Association& pair : hypothesis.associations)
      pairs.emplace(pair.local_feature, pair.map_feature.exists() ? map.feature(pair.map_feature).id : "");
    CHECK(books.associations.at(hypothesis.id) == pairs);
  }
  REQUIRE(books.local_features.size() == localizer.local_map().features().size());
  for (const LocalFeature& local : localizer.local_map().features()) {
    const ordered_json& written = books.local_features.at(local.id);
    CHECK(written["stable"] == local.stable);
    CHECK(written["type"] == local.feature.type);
    if (const auto* segment = std::get_if<Segment>(&local.feature.geometry)) {
      CHECK(std::abs(written["segment"][0].get<double>() - segment->begin.x()) < 0.011);
      CHECK(std::abs(written["segment"][3].get<double>() - segment->end.y()) < 0.011);
    }
  }
}

TEST_CASE("the probabilities of all hypotheses and of none of them sum to one in every estimate") {
  const RecordedSite site("malaga-demo");
  EventRecorder recorder;
  Localizer localizer(site.parts(), &recorder);
  replay(localizer, site.samples);
  int estimates = 0;
  for (const ordered_json& e : recorder.events) {
    if (e["event"] != "estimate") continue;
    ++estimates;
    double sum = e["none"], best = 0;
    for (const auto& row : e["hypotheses"]) {
      sum += row["probability"].get<double>();
      best = std::max(best, row["probability"].get<double>());
    }
    CHECK(sum == Approx(1).margin(1e-9));
    CHECK(e["probability"].get<double>() >= best - 1e-12);
  }
  CHECK(estimates > 30);
}

TEST_CASE("an update's events begin with its keyframe, end with its cost, and share its stamp") {
  const RecordedSite site("malaga-demo");
  EventRecorder recorder;
  Localizer localizer(site.parts(), &recorder);
  replay(localizer, site.samples);
  bool inside = false;
  double stamp_s = 0;
  int keyframe = -1;
  for (const ordered_json& e : recorder.events) {
    CAPTURE(e["event"], e["keyframe"]);
    if (e["event"] == "keyframe") {
      REQUIRE_FALSE(inside);
      REQUIRE(e["keyframe"] == ++keyframe);
      stamp_s = e["stamp_s"];
      inside = true;
    }
    REQUIRE(inside);
    REQUIRE(e["stamp_s"] == stamp_s);
    if (e["event"] == "cost") inside = false;
  }
  REQUIRE_FALSE(inside);
}

TEST_CASE("whether somebody listens changes no answer") {
  const RecordedSite site("malaga-demo");
  EventRecorder recorder;
  Localizer watched(site.parts(), &recorder), alone(site.parts());
  const auto a = replay(watched, site.samples), b = replay(alone, site.samples);
  for (std::size_t k = 0; k < a.size(); ++k) {
    REQUIRE(distance_m(a[k].estimate.T_map_base, b[k].estimate.T_map_base) < 1e-9);
    REQUIRE(a[k].estimate.status == b[k].estimate.status);
  }
}

TEST_CASE("a hypothesis that falls behind ends with reasons that name what it contradicts") {
  const RecordedSite site("malaga-demo");
  EventRecorder recorder;
  for (const int from : {0, 6, 12}) {  // several places from which to start
    Localizer localizer(site.parts(), &recorder);
    replay(localizer, {site.samples.begin() + from, site.samples.end()});
  }
  int fallen = 0, named = 0;
  for (const ordered_json& e : recorder.events) {
    if (e["event"] != "pruned" || e.contains("merged_into")) continue;
    ++fallen;
    CHECK_FALSE(e["reason"].get<std::string>().empty());
    for (const auto& finding : e["findings"])
      if (finding.contains("map_feature")) {
        ++named;
        CHECK(finding["line"].size() == 4);
        break;
      }
  }
  REQUIRE(fallen > 20);
  CHECK(named > fallen / 2);
}
