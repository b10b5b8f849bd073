// The same answers from both stores: in the process (MapView) and from the server.
#include "made_maps.hpp"
#include "plugins/postgis_store/server.hpp"

#include <opal/map/view/map_view.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>

using namespace opal;
using namespace opal::store_tests;

namespace {

struct Question {
  Point center;
  double radius_m;
};

std::vector<MapFeatureNumber> sorted(std::vector<MapFeatureNumber> numbers) {
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

/// Somewhere around the map, or on an end, a centre or a rim of a feature; as far as anything, or exactly as far as
/// some feature is.
class Questions {
 public:
  Questions(const MapView& view, unsigned seed) : view_(view), random_(seed) {}

  Question next() {
    const Point center = random_() % 3 == 0 ? on_some_feature() : anywhere();
    if (random_() % 3 != 0) return {center, std::pow(10.0, uniform(-2, 1.5))};
    return {center, distance_m(some_geometry_near(center), center)};
  }

 private:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  const Geometry& some_geometry() {
    return view_.feature(view_.features()[random_() % view_.features().size()]).geometry;
  }
  const Geometry& some_geometry_near(const Point& center) {
    const std::vector<MapFeatureNumber> near = view_.within(center, 15);
    return near.empty() ? some_geometry() : view_.feature(near[random_() % near.size()]).geometry;
  }
  Point anywhere() {
    const auto [low, high] = view_.bounds();
    return {uniform(low.x() - 5, high.x() + 5), uniform(low.y() - 5, high.y() + 5)};
  }
  Point on_some_feature() {
    const Geometry& geometry = some_geometry();
    if (const auto* segment = std::get_if<Segment>(&geometry))
      return random_() % 2 ? segment->begin : segment->midpoint();
    if (const auto* circle = std::get_if<Circle>(&geometry); circle && random_() % 2)
      return circle->center + circle->radius_m * unit_vector(uniform(-3, 3));
    return anchor_of(geometry);
  }

  const MapView& view_;
  std::mt19937 random_;
};

struct Tally {
  int questions = 0, found = 0, differ = 0;
  int sql_differ = 0;   ///< of the SQL function, by features whose distance is not within 1e-9 m of the radius
  int on_the_line = 0;  ///< differences of the SQL function in the last digits of a distance
};

/// By the SQL function that the database offers to everybody.
std::vector<MapFeatureNumber> by_sql(postgis_store::Server& server, const NearQuery& query) {
  std::vector<MapFeatureNumber> numbers;
  const auto text = [](double value) { return nlohmann::json(value).dump(); };
  server.read([&](postgis_store::Session& session) {
    for (const auto& row :
         session.ask("SELECT number FROM opal.features_near($1, $2::integer, $3, $4::float8, $5::float8, $6::float8)",
                     {query.building, std::to_string(query.version), query.sensor, text(query.center.x()),
                      text(query.center.y()), text(query.radius_m)}))
      numbers.emplace_back(std::stoi(row[0]));
  });
  return numbers;
}

void compare_sql(const MapView& view, const Question& question, const std::vector<MapFeatureNumber>& expected,
                 const std::vector<MapFeatureNumber>& found, Tally& tally) {
  std::vector<MapFeatureNumber> different;
  std::set_symmetric_difference(expected.begin(), expected.end(), found.begin(), found.end(),
                                std::back_inserter(different));
  for (const MapFeatureNumber number : different) {
    const double off_m = distance_m(view.feature(number).geometry, question.center) - question.radius_m;
    ++(std::abs(off_m) < 1e-9 ? tally.on_the_line : tally.sql_differ);
  }
}

Tally ask_both(const Map& map, const std::string& building, const std::string& sensor, int questions, unsigned seed) {
  const auto both = store();
  const int version = both->push(*map, {building}).version;
  const MapView view(map, sensor);
  postgis_store::Server server({});
  Questions ask(view, seed);
  Tally tally;
  for (int k = 0; k < questions; ++k, ++tally.questions) {
    const Question question = ask.next();
    const std::vector<MapFeatureNumber> expected = sorted(view.within(question.center, question.radius_m));
    const NearQuery query{building, version, sensor, question.center, question.radius_m};
    std::vector<MapFeatureNumber> found;
    for (const NearFeature& feature : both->features_near(query)) {
      found.push_back(feature.number);
      CHECK(feature.distance_m == distance_m(map->feature(feature.number).geometry, question.center));
    }
    tally.found += static_cast<int>(found.size());
    tally.differ += found != expected;
    compare_sql(view, question, expected, by_sql(server, query), tally);
  }
  WARN(building + ", " + sensor + ": " + std::to_string(tally.questions) + " questions, " +
       std::to_string(tally.found) + " features found, " + std::to_string(tally.differ) +
       " answers differ; the SQL function differs in " + std::to_string(tally.sql_differ) + " features, and in " +
       std::to_string(tally.on_the_line) + " more whose distance is within 1e-9 m of the radius");
  return tally;
}

void check(const Tally& tally) {
  CHECK(tally.found > tally.questions);
  CHECK(tally.differ == 0);
  CHECK(tally.sql_differ == 0);
}

}  // namespace

TEST_CASE("both stores find the same features near a place in a recorded hall") {
  check(ask_both(malaga(), "malaga", "PlanarLidar2D", 3000, 11));
}

TEST_CASE("both stores find the same features near a place in a large map") {
  const Map map = large_map(20000, 5);
  check(ask_both(map, "large hall", "PlanarLidar2D", 3000, 12));
  check(ask_both(map, "large hall", "Camera", 1000, 13));
}

TEST_CASE("a question about a building, a version or a place that is not there is refused") {
  const auto both = store();
  both->push(*malaga(), {"asked"});
  CHECK_THROWS_WITH(both->features_near({"unasked", 0, "PlanarLidar2D", {0, 0}, 1}),
                    Catch::Contains("no map of building 'unasked'"));
  CHECK_THROWS_WITH(both->features_near({"asked", 9, "PlanarLidar2D", {0, 0}, 1}),
                    Catch::Contains("no version 9 of building 'asked'; there is: 1"));
  CHECK(both->features_near({"asked", 0, "NoSensor", {0, 0}, 100}).empty());
  CHECK_THROWS_AS(both->features_near({"asked", 0, "PlanarLidar2D", {NAN, 0}, 1}), StoreError);
  CHECK_THROWS_AS(both->features_near({"asked", 0, "PlanarLidar2D", {0, 0}, INFINITY}), StoreError);
}
