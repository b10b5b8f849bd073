#include "sentence_checks.hpp"
#include "tests/system/replay/event_recorder.hpp"
#include "tests/system/replay/recorded_site.hpp"

#include "viewer/reading/frame_builder.hpp"

#include "localization/events/run_events.hpp"
#include "map_tools/test_maps/map_damage.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>

using namespace opal;
using nlohmann::ordered_json;

// Whatever is said about a recorded run is in its event stream: recomputed here from the events alone.

namespace {

/// The events of a recorded place; the second configuration branches and has half a map, so that all kinds of events
/// come.
const std::vector<ordered_json>& events_of(const std::string& name, bool branching) {
  static std::map<std::pair<std::string, bool>, std::vector<ordered_json>> known;
  auto& events = known[{name, branching}];
  if (!events.empty()) return events;
  const RecordedSite site(name);
  LocalizerParts parts = site.parts();
  if (branching) {
    MapDamage damage;
    damage.plan_m = 1.5;
    damage.drop = 0.5;
    parts.map = std::make_shared<MapView>(damaged_map(parts.map->map(), damage), parts.lasers.front().id);
    parts.stages.growth.max_branches = 2;
    parts.stages.growth.branch_not_on_map = true;
    parts.stages.hypotheses.max_hypotheses = 60;
  }
  EventRecorder recorder;
  recorder.write(run_event({"log", "config", "map"}, parts.lasers.front()));
  recorder.write(map_event(*parts.map));
  Localizer localizer(parts, &recorder);
  recorder.write(start_event("run"));
  replay(localizer, site.samples);
  return events = std::move(recorder.events);
}

/// Another order of what has no order.
void shuffle(RunFrame& frame, std::mt19937& random) {
  const auto mix = [&](auto& list) { std::shuffle(list.begin(), list.end(), random); };
  mix(frame.changed);
  mix(frame.gone);
  mix(frame.spawns);
  mix(frame.growths);
  mix(frame.losses);
  mix(frame.rejections);
  mix(frame.ends);
  mix(frame.hypotheses);
  for (auto& hypothesis : frame.hypotheses) mix(hypothesis.scores);
  for (auto& spawn : frame.spawns) mix(spawn.pairs);
  if (!frame.search) return;
  mix(frame.search->patterns);
  mix(frame.search->rejected);
}

}  // namespace

TEST_CASE("every name, time and number that is said about a recorded run is in its events") {
  const std::string site = GENERATE("malaga-demo", "malaga");
  const bool branching = GENERATE(false, true);
  CAPTURE(site, branching);
  FrameBuilder builder;
  StreamBooks books;
  std::optional<Explainer> explainer;
  std::map<SentenceKind, int> said;
  for (const ordered_json& event : events_of(site, branching)) {
    books.take(event);
    const auto frame = builder.add(event);
    if (!frame) continue;
    if (!explainer) explainer.emplace(*builder.header());
    explainer->take(*frame);
    const auto sentences = explainer->explanation();
    CHECK(sentences.size() <= 12);
    for (const Sentence& sentence : sentences) {
      check_sentence(sentence, books);
      ++said[sentence.kind];
    }
  }
  for (SentenceKind kind : {SentenceKind::answer, SentenceKind::support, SentenceKind::against,
                            SentenceKind::alternative, SentenceKind::fell, SentenceKind::note})
    CHECK((!branching || site != "malaga" || said[kind] > 0));
}

TEST_CASE("the order of events that have none changes no word") {
  const bool branching = GENERATE(false, true);
  FrameBuilder builder;
  std::optional<Explainer> one, other;
  std::mt19937 random(7);
  for (const ordered_json& event : events_of("malaga-demo", branching)) {
    auto frame = builder.add(event);
    if (!frame) continue;
    if (!one) one.emplace(*builder.header()), other.emplace(*builder.header());
    one->take(*frame);
    shuffle(*frame, random);
    other->take(*frame);
    REQUIRE(words_of(one->explanation()) == words_of(other->explanation()));
  }
}
