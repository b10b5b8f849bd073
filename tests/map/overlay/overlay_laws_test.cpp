// Laws that hold for every overlay: twice is once, order means nothing, and what is re-imported is changed alike.
#include "room.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>

namespace {

using namespace opal;
using namespace opal::test;
using Json = nlohmann::json;

std::string node_of_kiosk(int number) {
  const std::string id = "kiosk-" + std::to_string(number);
  // clang-format off
  return Json{{"@id", id}, {"@type", "acme:Kiosk"}, {"represented_by",
    {{"@type", "ObjectFeatureRepresentation"}, {"perceivable_by", "PlanarLidar2D"}, {"represented_by",
      {{"@id", id + "/rim"}, {"@type", "Circle"}, {"radius_m", 0.3},
       {"center", {{"@id", id + "/center"}, {"@type", "Point"}, {"x", number + 0.5}, {"y", 1.5}}}}}}}}.dump();
  // clang-format on
}

/// Changes of one thing each, so that none contradicts another.
std::vector<MapOverlay> random_overlays(std::mt19937& random) {
  const auto uniform = [&](double from, double to) { return std::uniform_real_distribution<double>(from, to)(random); };
  const auto any = [&](std::vector<Json> choices) {
    return choices[std::uniform_int_distribution<std::size_t>(0, choices.size() - 1)(random)];
  };
  std::vector<Json> changes;
  for (const char* point : {"corner-1", "corner-2", "corner-3", "corner-4", "kiosk-1/center"})
    changes.push_back(
        {{"target", point}, {any({"x", "y"}).get<std::string>(), uniform(-0.4, 0.4) + (point[0] == 'k' ? 3 : 6)}});
  for (const char* thing : {"face-1", "face-2", "wall-3", "wall-4", "c1", "kiosk-1"})
    changes.push_back(any({Json{{"target", thing}, {"existence", uniform(0, 1)}},
                           Json{{"target", thing}, {"not_perceivable_by", "PlanarLidar2D"}},
                           Json{{"target", thing}, {"perceivable_by", "Camera"}, {"position_sigma_m", uniform(0, 1)}},
                           Json{{"target", thing}, {"feature_type", "acme:Thing"}}}));
  changes.push_back({{"target", "k1"}, {any({"heading_rad", "opening_rad"}).get<std::string>(), uniform(0.1, 3)}});
  changes.push_back({{"target", "wall-1"}, {"object_type", any({"acme:Shelf", "Column"})}});
  changes.push_back({{"target", "gone"}, {"existence", 0}, {"if_missing", "report"}});
  std::shuffle(changes.begin(), changes.end(), random);
  std::vector<std::string> texts(3);
  for (const Json& change : changes) {
    if (uniform(0, 1) < 0.3) continue;
    std::string& text = texts[std::uniform_int_distribution<std::size_t>(0, 2)(random)];
    text += (text.empty() ? "" : ",") + change.dump();
  }
  std::vector<MapOverlay> overlays;
  for (std::size_t i = 0; i < texts.size(); ++i)
    overlays.push_back(overlay(texts[i], i == 1 ? node_of_kiosk(1) + "," + node_of_kiosk(2) : "",
                               "overlay-" + std::to_string(i) + ".jsonld"));
  return overlays;
}

/// The room as another export of the same building gives it: nodes and keys in another order.
std::shared_ptr<const SemanticMap> imported_again() {
  Json document = room()->to_json_ld();
  std::reverse(document["@graph"].begin(), document["@graph"].end());
  return SemanticMap::parse(document.dump(), "room.jsonld");
}

}  // namespace

TEST_CASE("applying twice is applying once, and order means nothing") {
  std::mt19937 random(7);
  for (int round = 0; round < 300; ++round) {
    std::vector<MapOverlay> overlays = random_overlays(random);
    const OverlaidMap once = overlaid_map(*room(), overlays);
    INFO("round " << round << "\n" << all_of(once.changes) << once.map->to_json_ld().dump());
    CHECK(overlaid_map(*once.map, overlays).map->to_json_ld() == once.map->to_json_ld());
    std::shuffle(overlays.begin(), overlays.end(), random);
    for (MapOverlay& overlay : overlays) std::shuffle(overlay.changes.begin(), overlay.changes.end(), random);
    const OverlaidMap other = overlaid_map(*room(), overlays);
    CHECK(other.map->to_json_ld() == once.map->to_json_ld());
    CHECK(other.changes == once.changes);
    CHECK(other.doubts == once.doubts);
  }
}

TEST_CASE("a building that is imported again is changed alike") {
  std::mt19937 random(8);
  for (int round = 0; round < 100; ++round) {
    const std::vector<MapOverlay> overlays = random_overlays(random);
    const OverlaidMap first = overlaid_map(*room(), overlays), again = overlaid_map(*imported_again(), overlays);
    CHECK(first.changes == again.changes);
    CHECK(first.doubts == again.doubts);
    CHECK(first.map->to_json_ld() == again.map->to_json_ld());
  }
}

TEST_CASE("an overlaid map that is written and read is the same map") {
  std::mt19937 random(9);
  for (int round = 0; round < 100; ++round) {
    const auto map = overlaid_map(*room(), random_overlays(random)).map;
    CHECK(SemanticMap::parse(map->to_json_ld().dump(), map->name())->to_json_ld() == map->to_json_ld());
  }
}

TEST_CASE("the imported map stays as it is") {
  const auto map = room();
  const std::string before = map->to_json_ld().dump();
  std::mt19937 random(10);
  for (int round = 0; round < 20; ++round) overlaid_map(*map, random_overlays(random));
  CHECK(map->to_json_ld().dump() == before);
}

TEST_CASE("no overlay, no change") {
  CHECK(overlaid_map(*room(), {}).map->to_json_ld() == room()->to_json_ld());
  CHECK(overlaid_map(*room(), {overlay("")}).map->to_json_ld() == room()->to_json_ld());
}
