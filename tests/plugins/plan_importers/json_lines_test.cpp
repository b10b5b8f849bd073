// Features one by one, plans of pixels, and doors that contradict the unit.
#include "import_source.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using nlohmann::json;

namespace {

MapImport import_lines(const std::string& text, const json& options = json::object(),
                       const std::string& name = "plan.geojsonl") {
  return import_text("geojson_importer", "opal:GeoJsonImporter", name, text, options);
}

json line_of(const std::string& kind, const json& coordinates) {
  return {{"type", "Feature"},
          {"properties", {{"indoor", kind}}},
          {"geometry", {{"type", "LineString"}, {"coordinates", coordinates}}}};
}

/// A room of walls with corners at whole numbers, and three doors in its lower wall.
json room(double width, double height, double door) {
  json features = json::array({line_of("wall", {{0, 0}, {width, 0}, {width, height}, {0, height}, {0, 0}})});
  for (const double at : {0.2, 0.4, 0.6}) {
    const double x = at * width;
    features.push_back(line_of("door", {{x, 0}, {x + door, 0}}));
  }
  return {{"type", "FeatureCollection"}, {"features", features}};
}

constexpr const char* kPixels = "as those of an image are: then y runs downwards, and the plan is mirrored";

}  // namespace

TEST_CASE("features come one a line, or behind record separators, and give the map of their collection") {
  const json plan = room(10, 8, 1);
  const auto whole = all<Segment>(*import_lines(plan.dump(), {}, "plan.geojson").map);
  std::string lines, records, pretty;
  for (const json& feature : plan.at("features")) {
    lines += feature.dump() + "\r\n";
    records += "\x1E" + feature.dump() + "\n";
    pretty += "\x1E" + feature.dump(2) + "\n";
  }
  for (const std::string& text : {lines, "\n\n" + lines, "\xEF\xBB\xBF" + lines, records, pretty}) {
    const MapImport imported = import_lines(text);
    CHECK(all<Segment>(*imported.map).size() == whole.size());
    CHECK(says(imported, "features one by one, "));
    CHECK_FALSE(says(imported, "doubtful: lines"));
  }
  PluginRegistry registry;
  registry.load(OPAL_PLUGIN_DIR "/geojson_importer.so");
  for (const char* name : {"a.geojsonl", "a.ndjson", "a.jsonl", "a.geojsons", "a.json", "a.geojson"}) {
    const TemporaryFile file(name, lines);
    CHECK(registry.make<MapImporter>("opal:GeoJsonImporter", json::object())->recognizes(file.path()));
  }
  const TemporaryFile log("log.jsonl", "{\"level\": \"info\"}\n{\"level\": \"info\"}\n");
  CHECK_FALSE(registry.make<MapImporter>("opal:GeoJsonImporter", json::object())->recognizes(log.path()));
}

TEST_CASE("a line that is no JSON is told with its number, and the rest comes in") {
  const json plan = room(10, 8, 1);
  std::string text;
  for (const json& feature : plan.at("features")) text += feature.dump() + "\n";
  const MapImport cut = import_lines(text.substr(0, text.size() - 20));
  CHECK(says(cut, "doubtful: lines that are no JSON, so that what they hold is missing: 1, the first is line 4"));
  CHECK(cut.elements.size() == 4);
  CHECK(says(cut, "damaged, and nothing is made of them: 1 features"));
}

TEST_CASE("coordinates like those of an image make the direction of y doubtful, and an option turns it") {
  const json image = room(640, 480, 40);
  const MapImport plan = import_lines(image.dump());
  CHECK(says(plan, kPixels));
  CHECK(has_face(*plan.map, {0, 480}, {0, 0}));
  const MapImport turned = import_lines(image.dump(), {{"y_down", true}, {"unit", "0.025"}});
  CHECK_FALSE(says(turned, kPixels));
  CHECK(has_face(*turned.map, {0, -12}, {0, 0}));
  CHECK(says(turned, "coordinates in units of 0.025 m, as the option unit says"));
  CHECK_FALSE(says(import_lines(room(640.5, 480, 40).dump()), kPixels));
  CHECK_FALSE(says(import_lines(room(40, 30, 1).dump()), kPixels));
  CHECK_FALSE(says(import_lines(image.dump(), {{"unit", "mm"}}), kPixels));
}

TEST_CASE("doors of a plan in metres that are no doors' width make the unit doubtful") {
  CHECK(
      says(import_lines(room(33, 26, 3).dump()), "doubtful: doors are 3.00 m wide (median of 3), expected 0.6 to 2 m"));
  CHECK(says(import_lines(room(33, 26, 3).dump()), "; in ft they would be 0.91 m (--set unit=ft)"));
  CHECK_FALSE(says(import_lines(room(33, 26, 1).dump()), "doubtful: doors"));
  CHECK_FALSE(says(import_lines(room(33, 26, 3).dump(), {{"unit", "ft"}}), "doubtful: doors"));
}

TEST_CASE("positions too far apart for degrees and too near for metres are refused as such") {
  const std::string town = room(0.08, 0.06, 0.01).dump();
  CHECK_THROWS_WITH(import_lines(town),
                    Catch::Contains("in degrees more than a building (0.05 degrees), in metres less"));
  CHECK_NOTHROW(import_lines(town, {{"unit", "m"}}));
}
