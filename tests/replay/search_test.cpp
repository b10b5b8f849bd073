#include "event_recorder.hpp"
#include "recorded_site.hpp"

#include <catch2/catch.hpp>

using namespace opal;

namespace {

std::vector<nlohmann::ordered_json> searches_of(const RecordedSite& site, const nlohmann::json& options) {
  LocalizerParts parts = site.parts();
  parts.association.merge_patch(options);
  EventRecorder recorder;
  Localizer localizer(std::move(parts), &recorder);
  replay(localizer, site.samples);
  std::erase_if(recorder.events, [](const auto& event) { return event["event"] != "searched"; });
  return recorder.events;
}

}  // namespace

TEST_CASE("a search asks for the patterns that are expected least often, and for no more places than it may") {
  const RecordedSite site("malaga-demo");
  for (const int most : {20, 200, 2000}) {
    std::size_t limited = 0;
    for (const auto& search : searches_of(site, {{"seed_places", most}})) {
      INFO("at most " << most << " places, keyframe " << search["keyframe"]);
      std::size_t places = 0;
      for (const auto& pattern : search["patterns"]) places += pattern["candidates"].get<std::size_t>();
      if (search["patterns"].size() > 3) CHECK(places <= static_cast<std::size_t>(most));
      limited += search["patterns"].size() == 3;
    }
    if (most == 20) CHECK(limited > 0);
  }
}

TEST_CASE("while a place is likely, fewer searches are made") {
  const RecordedSite site("malaga-demo");
  const std::size_t always = searches_of(site, {{"seed_every_when_likely", 1}}).size();
  const std::size_t seldom = searches_of(site, {{"seed_every_when_likely", 4}}).size();
  CHECK(seldom < always);
  CHECK(searches_of(site, {{"seed_every_when_likely", 4}, {"likely_probability", 1}}).size() == always);
}
