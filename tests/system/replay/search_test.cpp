#include "event_recorder.hpp"
#include "recorded_site.hpp"

#include <catch2/catch.hpp>

#include <functional>

using namespace opal;

namespace {

std::vector<nlohmann::ordered_json> searches_of(const RecordedSite& site,
                                                const std::function<void(LocalizerOptions&)>& change) {
  LocalizerParts parts = site.parts();
  change(parts.stages);
  EventRecorder recorder;
  Localizer localizer(std::move(parts), &recorder);
  replay(localizer, site.samples);
  std::erase_if(recorder.events, [](const auto& event) { return event["event"] != "searched"; });
  return recorder.events;
}

std::size_t places_of(const nlohmann::ordered_json& search) {
  std::size_t places = 0;
  for (const auto& pattern : search["patterns"]) places += pattern["candidates"].get<std::size_t>();
  return places;
}

}  // namespace

TEST_CASE("a search looks at no more places than it may, but for the three patterns that are expected least often") {
  const RecordedSite site("malaga-demo");
  std::size_t total = 0;
  for (const int most : {1, 50, 2000}) {
    std::size_t asked = 0;
    for (const auto& search : searches_of(site, [&](LocalizerOptions& stages) { stages.search.places = most; })) {
      INFO("at most " << most << " places, keyframe " << search["keyframe"] << ": " << search["patterns"]);
      if (search["patterns"].size() > 3) CHECK(places_of(search) <= static_cast<std::size_t>(most));
      asked += search["patterns"].size();
    }
    CHECK(asked > total);  // the more places it may look at, the more patterns it asks for
    total = asked;
  }
}

TEST_CASE("while a place is likely, fewer searches are made") {
  const RecordedSite site("malaga-demo");
  const std::size_t always =
      searches_of(site, [&](LocalizerOptions& stages) { stages.schedule.every_when_likely = 1; }).size();
  const std::size_t seldom =
      searches_of(site, [&](LocalizerOptions& stages) { stages.schedule.every_when_likely = 4; }).size();
  CHECK(seldom < always);
  CHECK(searches_of(site, [&](LocalizerOptions& stages) {
          stages.schedule.every_when_likely = 4;
          stages.schedule.likely_probability = 1;
        }).size() == always);
}

TEST_CASE("a search that is spread over scans makes way for no other, and the robot is found") {
  const RecordedSite site("malaga-demo");
  const auto spread = [](LocalizerOptions& stages) { stages.search.places_per_scan = 10; };
  const std::size_t at_once = searches_of(site, [](LocalizerOptions&) {}).size();
  CHECK(searches_of(site, spread).size() < at_once);
  CHECK(searches_of(site, [](LocalizerOptions& stages) { stages.search.places_per_scan = 0; }).size() ==
        at_once);  // a small building
  LocalizerParts parts = site.parts();
  spread(parts.stages);
  Localizer localizer(std::move(parts));
  const std::vector<ReplayedScan> scans = replay(localizer, site.samples);
  REQUIRE_FALSE(scans.empty());
  CHECK(scans.back().estimate.status == Status::localized);
}
