// Maps that are written as Opal writes them are read by a reader of their own. Here it is held against the general one,
// over a small map and all small changes to it.
#include <opal/common/error.hpp>
#include <opal/map/semantic_map.hpp>

#include <catch2/catch.hpp>

#include <fstream>
#include <iterator>

using namespace opal;
using nlohmann::json;

namespace {

/// Two sensors, shared points, a named representation, notes, a type of others, a storeyless placement, and words that
/// Opal makes no use of.
json small_map() {
  return json::parse(R"({"@context": ["urn:opal:v1", {"acme": "https://acme.example/"}], "@graph": [
    {"@type": "SemanticMap", "name": "small", "smear_m": 0.1},
    {"@id": "west", "@type": "MapPlacement", "x": 1, "y": 2, "heading_rad": 0.5, "scale_x": 1, "scale_y": -1},
    {"@id": "lidar", "@type": "Sensor"},
    {"@id": "note-1", "@type": "acme:Remark", "acme:text": "painted"},
    {"@id": "w1", "@type": "Wall", "name": "north", "source_class": "IfcWall", "storey": "ground", "thickness_m": 0.2,
     "axis": [0, 0.1, 4, 0.1], "merged_ids": ["w1b"], "represented_by": [
      {"@id": "w1/lidar", "@type": "ObjectFeatureRepresentation", "perceivable_by": {"@id": "lidar"},
       "represented_by": {"@id": "w1/face", "@type": "LineSegment",
        "begin": {"@id": "p1", "@type": "Point", "x": 0, "y": 0}, "end": {"@type": "Point", "x": 4, "y": 0},
        "existence": 0.9, "position_sigma_m": 0.3}},
      {"@type": "ObjectFeatureRepresentation", "perceivable_by": "camera", "feature_type": "acme:Skirting",
       "represented_by": {"@id": "w1/face"}}]},
    {"@id": "w2", "@type": "Wall", "represented_by": {"@type": "ObjectFeatureRepresentation",
      "perceivable_by": {"@id": "lidar"}, "existence": 0.5, "represented_by": [
       {"@id": "k1", "@type": "Corner", "point": {"@id": "p1"}, "heading_rad": 0.8, "opening_rad": 1.57},
       {"@id": "w2/face", "@type": "LineSegment", "begin": {"@id": "p1"},
        "end": {"@id": "p2", "@type": "Point", "x": 0, "y": -3}}]}},
    {"@id": "c1", "@type": "acme:Post", "width_m": 0.4, "represented_by": {"@type": "ObjectFeatureRepresentation",
      "perceivable_by": {"@id": "lidar"}, "represented_by": {"@id": "c1/rim", "@type": "Circle",
       "center": {"@id": "c1/axis", "@type": "Point", "x": 2, "y": -2}, "radius_m": 0.2, "position_sigma_m": 0.02}}},
    {"@id": "b1", "@type": "Column", "represented_by": {"@type": "ObjectFeatureRepresentation",
      "perceivable_by": {"@id": "lidar"}, "feature_type": "acme:Beacon",
      "represented_by": {"@id": "b1/light", "@type": "Point", "x": 3, "y": -1}}},
    {"@id": "d1", "@type": "Door"}]})");
}

/// The same document in words that need the general reader.
json for_general_reader(json document) {
  document["@context"].insert(document["@context"].begin(), nullptr);
  return document;
}

/// The map, or what is wrong with it.
std::string outcome(const std::string& text) {
  try {
    return SemanticMap::parse(text, "small")->to_json_ld().dump(1);
  } catch (const Error& error) {
    return error.what();
  }
}

std::string padded(const json& document) { return document.dump() + std::string(65u << 20, ' '); }

std::vector<json::json_pointer> places_in(const json& value, const json::json_pointer& at = json::json_pointer()) {
  std::vector<json::json_pointer> places;
  const auto add = [&](const json& part, const json::json_pointer& here) {
    places.push_back(here);
    for (json::json_pointer& deeper : places_in(part, here)) places.push_back(std::move(deeper));
  };
  if (value.is_object())
    for (const auto& [key, part] : value.items()) add(part, at / key);
  if (value.is_array())
    for (std::size_t k = 0; k < value.size(); ++k) add(value[k], at / k);
  return places;
}

}  // namespace

TEST_CASE("a plain document gives the map that the general reader makes of it") {
  const std::string plain = outcome(small_map().dump());
  CHECK(plain == outcome(for_general_reader(small_map()).dump()));
  CHECK_THAT(plain, Catch::Contains("\"w1/face\"") && Catch::Contains("acme:Skirting") && Catch::Contains("painted"));
}

TEST_CASE("only what is plainly written may be larger than the general reader has memory for") {
  CHECK(outcome(padded(small_map())) == outcome(small_map().dump()));
  CHECK_THAT(outcome(padded(for_general_reader(small_map()))), Catch::Contains("bytes, expected at most 67108864"));
}

TEST_CASE("whatever is changed in a plain document, both readers say the same") {
  const std::vector<json> instead{nullptr,
                                  -1,
                                  2e6,
                                  "",
                                  "p1",
                                  "w1",
                                  "acme:z",
                                  "@id",
                                  "_:b",
                                  "Wall",
                                  "Point",
                                  json::array(),
                                  json::array({"Wall", "Element"}),
                                  {{"@id", "p1"}},
                                  {{"@value", 1}}};
  const json document = small_map();
  for (const json::json_pointer& place : places_in(document["@graph"])) {
    std::vector<json> changed(instead.size(), document);
    for (std::size_t k = 0; k < instead.size(); ++k) changed[k]["@graph"][place] = instead[k];
    const json before = document["@graph"][place];
    changed.push_back(document);
    json& parent = changed.back()["@graph"][place.parent_pointer()];
    if (parent.is_object()) parent.erase(place.back());
    if (parent.is_array()) parent.push_back(before);  // once more
    for (const json& each : changed) {
      CAPTURE(place.to_string(), each["@graph"].dump());
      CHECK(outcome(each.dump()) == outcome(for_general_reader(each).dump()));
    }
  }
}

TEST_CASE("what is said of a sensor that perceives something is said of the same sensor to both readers") {
  json document = small_map();
  document["@graph"][2] = {{"@id", "lidar"}, {"thickness_m", 0.1}};
  CHECK_THAT(outcome(document.dump()), Catch::Contains("thickness_m, which means nothing there"));
  CHECK(outcome(document.dump()) == outcome(for_general_reader(document).dump()));
}

TEST_CASE("the order of the nodes is the same to both readers") {
  json document = small_map();
  std::reverse(document["@graph"].begin(), document["@graph"].end());
  CHECK(outcome(document.dump()) == outcome(small_map().dump()));
}
