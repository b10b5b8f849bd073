#include "columns.hpp"

#include <opal/common/error.hpp>
#include "patterns/pattern_layer.hpp"
#include "tests/kit/refusal.hpp"

#include <algorithm>
#include <set>

using namespace opal;
using Catch::Contains;

namespace {

using Templates = std::vector<Named<PatternTemplate>>;

Templates templates(const std::vector<std::string>& names) {
  Templates made;
  for (const std::string& name : names) made.push_back({name, shipped(name)});
  return made;
}

const std::vector<std::string> kColumns{"opal:ColumnPair", "opal:Collinear", "opal:LShape"};

PatternLayer layer_of(const std::vector<Feature>& features, const std::vector<std::string>& names = kColumns,
                      double size_m = 8) {
  return find_pattern_layer(view_of(map_of(features)), templates(names), {size_m});
}

int count(const PatternLayer& layer, const std::string& name) {
  return static_cast<int>(std::count_if(layer.patterns.begin(), layer.patterns.end(),
                                        [&](const MapPattern& p) { return p.pattern_template == name; }));
}

std::string complaint_about(const MapPattern& pattern) {
  const auto map = map_of({column(0, 0), column(7.4, 0), column(0, 6.2), wall(-1, -1, 9, -1)}, {pattern});
  return refused_with<MapError>(
      [&] { layer_instances(view_of(map), pattern.pattern_template, *shipped(pattern.pattern_template)); });
}

}  // namespace

TEST_CASE("a grid of columns gets the patterns of neighbours, and no others") {
  const PatternLayer layer = layer_of(column_grid(4, 2));
  CHECK(count(layer, "opal:ColumnPair") == 10);
  CHECK(count(layer, "opal:Collinear") == 4);
  CHECK(count(layer, "opal:LShape") == 12);
}

TEST_CASE("neighbours between which something stands are no pattern") {
  std::vector<Feature> features{column(0, 0), column(7, 0)};
  CHECK(layer_of(features).patterns.size() == 1);
  features.push_back(wall(3, -1, 3, 1));
  CHECK(layer_of(features).patterns.empty());
  features.back() = column(3, 0.1);
  CHECK(count(layer_of(features), "opal:ColumnPair") == 2);  // with the one between, not across it
}

TEST_CASE("a wall hides a neighbour where it crosses the way, not where the way passes by its end") {
  const auto pairs = [](double low_y,
                        double high_y) {  // of two columns, the way between which crosses x = 2 at y = 0.8
    return layer_of({column(0, 0), column(7, 2.8), wall(2, low_y, 2, high_y)}).patterns.size();
  };
  CHECK(pairs(0.5, 1.1) == 0);
  CHECK(pairs(1.1, 1.7) == 1);
  CHECK(pairs(-0.7, 0.5) == 1);
}

TEST_CASE("a wall that ends at a corner does not hide it, a wall before it does") {
  const std::vector<Feature> room{corner(0, 0, 0.25 * std::numbers::pi), corner(6, 0, 0.75 * std::numbers::pi),
                                  wall(0, 0, 6, 0), wall(0, 5, 0, 0), wall(6, 0, 6, 5)};
  const std::vector<std::string> names{"opal:CornerPair"};
  CHECK(layer_of(room, names).patterns.size() == 1);
  std::vector<Feature> divided = room;
  divided.push_back(wall(3, 4, 3, -0.5));
  CHECK(layer_of(divided, names).patterns.empty());
}

TEST_CASE("corners of a pillar that look away from each other are no neighbours") {
  const double pi = std::numbers::pi;
  const std::vector<Feature> pillar{corner(0, 0, -0.75 * pi, 1.5 * pi), corner(1, 1, 0.25 * pi, 1.5 * pi)};
  CHECK(layer_of(pillar, {"opal:CornerPair"}).patterns.empty());
}

TEST_CASE("a column does not hide what a detector sees on it, only what stands behind it") {
  std::vector<MapFeature> features;
  const auto add = [&](std::size_t object, const Feature& seen) {
    features.push_back(
        {"f" + std::to_string(features.size()), MapObjectNumber(object), seen.type, "lidar", seen.geometry});
  };
  for (const std::size_t object : {0, 1}) {
    const double x = 5.0 * static_cast<double>(object);
    add(object, {"acme:Rim", Circle{{x, 0}, 0.5}});
    add(object, column(x, 0));  // smaller: within it
  }
  const auto long_pairs = [&] {
    const std::vector<MapObject> objects{{"a", "opal:Column"}, {"b", "opal:Column"}, {"c", "opal:Column"}};
    const auto view = view_of(SemanticMap::make("posts", objects, features));
    const PatternLayer layer = find_pattern_layer(view, templates({"opal:ColumnPair"}), {8});
    return std::count_if(layer.patterns.begin(), layer.patterns.end(),
                         [](const MapPattern& pattern) { return pattern.dimensions.front() > 4; });
  };
  CHECK(long_pairs() == 4);
  add(2, {"acme:Rim", Circle{{2.5, 0}, 0.5}});
  CHECK(long_pairs() == 0);
}

TEST_CASE("a wall does not hide what is round and stands in it, only what is of another object") {
  const auto pairs = [](std::size_t object_of_wall) {
    const std::vector<MapObject> objects{{"a", "opal:Wall"}, {"b", "opal:Column"}, {"c", "opal:Wall"}};
    std::vector<MapFeature> features;
    for (const auto& [object, seen] :
         {std::pair{std::size_t{0}, column(2.9, 0)}, std::pair{std::size_t{1}, column(7, 0)},
          std::pair{object_of_wall, wall(3, 1, 3, -1)}})
      features.push_back(
          {"f" + std::to_string(features.size()), MapObjectNumber(object), seen.type, "lidar", seen.geometry});
    const auto view = view_of(SemanticMap::make("pilaster", objects, features));
    return find_pattern_layer(view, templates({"opal:ColumnPair"}), {8}).patterns.size();
  };
  CHECK(pairs(0) == 1);
  CHECK(pairs(2) == 0);
}

TEST_CASE("a size limit keeps patterns of neighbours that are farther apart away") {
  CHECK(count(layer_of(column_grid(4, 2), kColumns, 7), "opal:ColumnPair") == 4);  // along y only
  CHECK(layer_of(column_grid(4, 2), kColumns, 6).patterns.empty());
}

TEST_CASE("a triple names the pairs that it is made of") {
  const PatternLayer layer = layer_of(column_grid(3, 2));
  std::set<std::string> pairs;
  for (const MapPattern& pattern : layer.patterns)
    if (pattern.features.size() == 2) pairs.insert(pattern.id);
  for (const MapPattern& pattern : layer.patterns) {
    if (pattern.features.size() == 2) continue;
    REQUIRE(pattern.subpatterns.size() == 2);
    for (const std::string& part : pattern.subpatterns) CHECK(pairs.contains(part));
  }
}

TEST_CASE("how unique a pattern is counts those that look like it") {
  std::vector<Feature> features = column_grid(3, 1);
  features.push_back(column(14.8, 5));
  const PatternLayer layer = layer_of(features, {"opal:ColumnPair"});
  REQUIRE(layer.patterns.size() == 3);
  std::vector<int> alike = layer.alike;
  std::sort(alike.begin(), alike.end());
  CHECK(alike == std::vector<int>{0, 1, 1});
  CHECK(layer.summaries[0].unique == 1);
  CHECK(sentence_of(layer.summaries[0]) ==
        "opal:ColumnPair: 3 patterns, 1 unique; half have at most 1 look-alike, the worst 1; "
        "4 of 4 features of its shapes are in one");
}

TEST_CASE("a layer is written and read back whole, and gives the same patterns") {
  const auto map = map_of(column_grid(4, 2));
  const PatternLayer layer = find_pattern_layer(view_of(map), templates(kColumns), {8});
  const auto with = map->with_patterns(layer.patterns);
  const auto again = SemanticMap::parse(with->to_json_ld().dump(), "again.jsonld");
  REQUIRE(again->patterns().size() == layer.patterns.size());
  for (std::size_t k = 0; k < again->patterns().size(); ++k) {
    const MapPattern &a = with->patterns()[k], &b = again->patterns()[k];
    CHECK(a.id == b.id);
    CHECK(a.pattern_template == b.pattern_template);
    CHECK(a.features == b.features);
    CHECK(a.subpatterns == b.subpatterns);
    CHECK(a.dimensions == b.dimensions);
  }
  CHECK(again->to_json_ld().dump() == with->to_json_ld().dump());
  const MapView view = view_of(again);
  CHECK(has_pattern_layer(view));
  for (const std::string& name : kColumns)
    CHECK(static_cast<int>(layer_instances(view, name, *shipped(name)).size()) == count(layer, name));
}

TEST_CASE("the same building in another order gets the same layer") {
  auto features = column_grid(4, 2);
  const PatternLayer layer = layer_of(features);
  std::reverse(features.begin(), features.end());
  const PatternLayer reversed = layer_of(features);
  CHECK(reversed.patterns.size() == layer.patterns.size());
  auto alike = [](PatternLayer l) {
    std::sort(l.alike.begin(), l.alike.end());
    return l.alike;
  };
  CHECK(alike(layer) == alike(reversed));
}

TEST_CASE("a layer that contradicts its template is refused with its place") {
  CHECK(complaint_about({"p", "opal:ColumnPair", {MapFeatureNumber(0), MapFeatureNumber(1)}, {}, {7.4}}) == "accepted");
  CHECK(complaint_about({"p", "opal:ColumnPair", {MapFeatureNumber(1), MapFeatureNumber(0)}}) ==
        "accepted");  // symmetric: either order
  CHECK(complaint_about({"p", "opal:ColumnPair", {MapFeatureNumber(0), MapFeatureNumber(1)}, {}, {9.9}}) ==
        "columns: /patterns/0 'p': pattern 'p' of opal:ColumnPair has the dimension 9.900 at position 0, but its "
        "features give "
        "7.400");
  CHECK_THAT(
      complaint_about({"p", "opal:ColumnPair", {MapFeatureNumber(0), MapFeatureNumber(1)}, {}, {7.4, 0.33, 0.33, 1}}),
      Contains("has 4 dimensions, expected at most 3"));
  CHECK_THAT(complaint_about({"p", "opal:ColumnPair", {MapFeatureNumber(0)}}), Contains("has 1 features, expected 2"));
  CHECK_THAT(complaint_about({"p", "opal:ColumnPair", {MapFeatureNumber(0), MapFeatureNumber(3)}}),
             Contains("has the member 'k4-shape', which is a segment, expected a circle"));
  CHECK_THAT(complaint_about({"p", "opal:LShape", {MapFeatureNumber(2), MapFeatureNumber(0), MapFeatureNumber(1)}}),
             Contains("in another order, expected 'k2-shape', 'k1-shape', 'k3-shape'"));
  CHECK_THAT(complaint_about({"p", "opal:Collinear", {MapFeatureNumber(1), MapFeatureNumber(0), MapFeatureNumber(2)}}),
             Contains("do not stand to each other as the template asks"));
}

TEST_CASE("a layer in a file that names a feature which is not there is refused with file and place") {
  auto document = nlohmann::json::parse(
      map_of({column(0, 0), column(5, 0)}, {{"p", "opal:ColumnPair", {MapFeatureNumber(0), MapFeatureNumber(1)}}})
          ->to_json_ld()
          .dump());
  document["@graph"].back()["features"][1] = "k9-shape";
  CHECK_THROWS_WITH(SemanticMap::parse(document.dump(), "hall.jsonld"),
                    Contains("hall.jsonld: /@graph/4/features/1") && Contains("k9-shape"));
}

TEST_CASE("a pattern that was read knows where it stands") {
  const auto map = map_of({column(0, 0), column(5, 0)},
                          {{"p", "opal:ColumnPair", {MapFeatureNumber(0), MapFeatureNumber(1)}, {}, {6}}});
  const auto read = SemanticMap::parse(map->to_json_ld().dump(), "hall.jsonld");
  CHECK_THROWS_WITH(
      layer_instances(view_of(read), "opal:ColumnPair", *shipped("opal:ColumnPair")),
      Catch::StartsWith("hall.jsonld: /@graph/4: pattern 'p' of opal:ColumnPair has the dimension 6.000"));
}
