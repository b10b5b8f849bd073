#include <opal/common/error.hpp>
#include <opal/map/semantic_map.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>

using namespace opal;
using Json = nlohmann::ordered_json;

namespace {

/// Maps with everything that a map can hold: shared points, two sensors, named representations, odd names.
class RandomMap {
 public:
  explicit RandomMap(unsigned seed) : random_(seed) {}

  std::shared_ptr<const SemanticMap> make() {
    for (int i = 0; i < 12; ++i) points_.push_back({"p" + std::to_string(i), {uniform(-50, 50), uniform(-50, 50)}});
    for (int i = count(1, 8); i > 0; --i) add_object();
    std::vector<MapPattern> patterns;
    for (int i = count(0, 4); i > 0 && !features_.empty(); --i)
      patterns.push_back(pattern(static_cast<int>(patterns.size())));
    MapOrigin origin;
    if (count(0, 1) == 0) origin.smear_m = uniform(0, 0.5);
    for (int i = count(0, 2); i > 0; --i)
      origin.placements.push_back({name("place"), Pose2(uniform(-50, 50), uniform(-50, 50), uniform(-3, 3)),
                                   Point(uniform(0.5, 2), uniform(-2, -0.5))});
    return SemanticMap::make(name("map"), objects_, features_, patterns, origin);
  }

 private:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  int count(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  std::string pick(const std::vector<std::string>& choices) {
    return choices[count(0, static_cast<int>(choices.size()) - 1)];
  }
  std::string name(const std::string& what) {
    return pick({"", "urn:x:", "https://example.org/b#", "3cUk\"z/", "W\xc3\xa4nde ",
                 "opal:", "acme:", "other:", "a b\n", "#", "../", "?"}) +
           what + std::to_string(next_++);
  }

  void add_object() {
    objects_.push_back({name("object"), pick({"opal:Wall", "opal:Column", "acme:Kiosk", "bot:Element", "opal:Corner",
                                              "https://example.org/types#Door"})});
    for (int i = count(0, 4); i > 0; --i) add_features();
  }

  /// One geometry, for one sensor or for two.
  void add_features() {
    MapFeature feature;
    feature.id = name("feature");
    feature.object = MapObjectNumber(objects_.size() - 1);
    feature.sensor = pick({"PlanarLidar2D", "urn:x:camera", ""});
    shape(feature);
    if (count(0, 2) == 0) feature.type = pick({"acme:Skirting", "opal:Wall", "https://example.org/types#Post"});
    if (count(0, 1) == 0) feature.position_sigma_m = uniform(0, 0.5);
    if (count(0, 1) == 0) feature.existence = uniform(0, 1);
    if (count(0, 2) == 0) feature.representation = name("representation");
    features_.push_back(feature);
    if (count(0, 4) > 0) return;
    feature.sensor = "SecondSensor";
    feature.representation = "";
    features_.push_back(feature);
  }

  void shape(MapFeature& feature) {
    const int a = count(0, 11), b = (a + count(1, 11)) % 12;
    const int kind = count(0, 3);
    if (kind == 0) {
      feature.geometry = Point(uniform(-50, 50), uniform(-50, 50));
      return;
    }
    feature.points = {points_[a].first};
    const Point at = points_[a].second;
    if (kind == 1) feature.geometry = OrientedPoint{at, uniform(-3, 3), uniform(0.1, 6)};
    if (kind == 2) feature.geometry = Circle{at, uniform(0.01, 2)};
    if (kind == 3) {
      feature.geometry = Segment{at, points_[b].second};
      feature.points.push_back(points_[b].first);
    }
  }

  MapPattern pattern(int number) {
    MapPattern made{name("pattern"), pick({"opal:ColumnPair", "acme:Row"}), {}};
    const int first = count(0, static_cast<int>(features_.size()) - 1);
    for (std::size_t i = 0; i < features_.size(); ++i)
      if (features_[i].sensor == features_[first].sensor && (static_cast<int>(i) == first || count(0, 2) == 0))
        made.features.emplace_back(i);
    std::shuffle(made.features.begin(), made.features.end(), random_);
    for (int i = count(0, 3); i > 0; --i) made.dimensions.push_back(uniform(-9, 9));
    if (number > 0 && count(0, 1) == 0) made.subpatterns = {last_pattern_};
    last_pattern_ = made.id;
    return made;
  }

  std::mt19937 random_;
  int next_ = 0;
  std::vector<std::pair<std::string, Point>> points_;
  std::vector<MapObject> objects_;
  std::vector<MapFeature> features_;
  std::string last_pattern_;
};

std::string numbers_of(const Geometry& geometry) {
  const auto text = [](std::initializer_list<double> numbers) {
    return nlohmann::json(std::vector<double>(numbers)).dump();
  };
  if (const auto* p = std::get_if<Point>(&geometry)) return "point" + text({p->x(), p->y()});
  if (const auto* c = std::get_if<OrientedPoint>(&geometry))
    return "corner" + text({c->position.x(), c->position.y(), c->heading_rad, c->opening_rad});
  if (const auto* s = std::get_if<Segment>(&geometry))
    return "segment" + text({s->begin.x(), s->begin.y(), s->end.x(), s->end.y()});
  const auto& circle = std::get<Circle>(geometry);
  return "circle" + text({circle.center.x(), circle.center.y(), circle.radius_m});
}

/// Everything that a map holds, bit by bit, without the writer that is under test.
std::vector<std::string> contents_of(const SemanticMap& map) {
  std::vector<std::string> lines{map.name(), map.unused().dump(), nlohmann::json(map.prefixes()).dump()};
  for (const MapObject& object : map.objects())
    lines.push_back(nlohmann::json{object.id, object.type, object.features}.dump());
  for (const MapFeature& f : map.features())
    lines.push_back(nlohmann::json{f.id, f.object, f.type, f.sensor, f.position_sigma_m, f.existence, f.points,
                                   f.representation, numbers_of(f.geometry)}
                        .dump());
  for (const MapPattern& p : map.patterns())
    lines.push_back(nlohmann::json{p.id, p.pattern_template, p.features, p.subpatterns, p.dimensions}.dump());
  lines.push_back(nlohmann::json(map.origin().smear_m).dump());
  for (const MapPlacement& p : map.origin().placements)
    lines.push_back(nlohmann::json{p.id, p.T_map_source.x(), p.T_map_source.y(), p.T_map_source.heading_rad(),
                                   p.scale.x(), p.scale.y()}
                        .dump());
  return lines;
}

/// The same document with every nested node that has an id moved to the top, references left behind.
void hoist(Json& value, Json& top, bool is_top) {
  if (value.is_array())
    for (Json& element : value) hoist(element, top, is_top);
  if (!value.is_object() || value.contains("@value")) return;
  for (auto& [key, member] : value.items()) hoist(member, top, false);
  if (is_top || !value.contains("@id") || value.size() == 1) return;
  const Json reference = {{"@id", value["@id"]}};
  top.push_back(std::move(value));
  value = reference;
}

Json flattened(const Json& document) {
  Json flat = document, hoisted = Json::array();
  hoist(flat["@graph"], hoisted, true);
  for (Json& node : hoisted) flat["@graph"].push_back(std::move(node));
  return flat;
}

/// The same document with keys, sets of values and nodes in another order; lists keep theirs.
Json reordered(const Json& value, std::mt19937& random) {
  if (value.is_array()) {
    Json shuffled = value;
    for (Json& element : shuffled) element = reordered(element, random);
    std::shuffle(shuffled.begin(), shuffled.end(), random);
    return shuffled;
  }
  if (!value.is_object()) return value;
  std::vector<std::string> keys;
  for (const auto& [key, member] : value.items()) keys.push_back(key);
  std::shuffle(keys.begin(), keys.end(), random);
  Json shuffled = Json::object();
  for (const std::string& key : keys) {
    const bool ordered = key == "features" || key == "subpatterns" || key == "dimensions" || key == "@list";
    shuffled[key] = ordered ? value[key] : reordered(value[key], random);
  }
  return shuffled;
}

}  // namespace

TEST_CASE("a map that is written and read is the same map") {
  const auto seed = GENERATE(range(0u, 300u));
  CAPTURE(seed);
  const auto map = RandomMap(seed).make();
  const std::string text = map->to_json_ld().dump(1);
  CAPTURE(text);
  CHECK(contents_of(*SemanticMap::parse(text, map->name())) == contents_of(*map));
}

TEST_CASE("flattened and reordered documents give the same map") {
  const auto seed = GENERATE(range(1000u, 1200u));
  CAPTURE(seed);
  std::mt19937 random(seed);
  const auto map = RandomMap(seed).make();
  const Json nested = map->to_json_ld(), flat = flattened(nested);
  CHECK(contents_of(*SemanticMap::parse(flat.dump(), map->name())) == contents_of(*map));
  CHECK(contents_of(*SemanticMap::parse(reordered(nested, random).dump(), map->name())) == contents_of(*map));
  CHECK(contents_of(*SemanticMap::parse(reordered(flat, random).dump(), map->name())) == contents_of(*map));
}

TEST_CASE("the order in which a map is made of its parts does not matter") {
  const auto seed = GENERATE(range(2000u, 2050u));
  CAPTURE(seed);
  const auto map = RandomMap(seed).make();
  std::vector<MapObject> objects(map->objects().rbegin(), map->objects().rend());
  std::vector<MapFeature> features(map->features().rbegin(), map->features().rend());
  for (MapObject& object : objects) object.features.clear();
  for (MapFeature& feature : features) feature.object = MapObjectNumber(objects.size() - 1 - feature.object.number());
  std::vector<MapPattern> patterns = map->patterns();
  for (MapPattern& pattern : patterns)
    for (MapFeatureNumber& feature : pattern.features)
      feature = MapFeatureNumber(features.size() - 1 - feature.number());
  CHECK(contents_of(*SemanticMap::make(map->name(), objects, features, patterns, map->origin())) == contents_of(*map));
}

TEST_CASE("a damaged document gives a map or an error, nothing else") {
  const std::string text = RandomMap(7).make()->to_json_ld().dump();
  std::mt19937 random(8);
  std::uniform_int_distribution<std::size_t> place(0, text.size() - 1);
  const std::string bytes = "{}[],:\"0-9eE.@\\/\x01\xff ntf";
  for (int i = 0; i < 3000; ++i) {
    std::string damaged = text;
    const std::size_t at = place(random);
    if (i % 3 == 0) damaged[at] = bytes[place(random) % bytes.size()];
    if (i % 3 == 1) damaged.resize(at);
    if (i % 3 == 2) damaged.insert(at, text.substr(place(random), 40));
    CAPTURE(i, damaged);
    try {
      (void)SemanticMap::parse(damaged, "damaged");
    } catch (const MapError&) {
    }
  }
}
