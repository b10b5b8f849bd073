#include "localization/search/pattern_lookup.hpp"

#include <catch2/catch.hpp>

using namespace opal;

namespace {

/// A point's pattern is its distance from the origin, in whole metres.
struct DistanceTemplate final : PatternTemplate {
  PatternShape shape() const override { return {{GeometryKind::point}, 0, 0}; }
  std::optional<PatternInstance> match(std::span<const Feature* const> features) const override {
    const Point place = anchor_of(features[0]->geometry);
    return PatternInstance{{0}, {{std::round(place.norm()), 0.1}}, Pose2(place, 0)};
  }
};

/// The first number says how many patterns the map has at 1 m, the second at 2 m, and so on.
std::vector<MappedTemplate> templates_with(const std::vector<std::size_t>& counts) {
  PatternList table;
  for (std::size_t k = 0; k < counts.size(); ++k)
    for (std::size_t copy = 0; copy < counts[k]; ++copy) {
      PatternInstance mapped{{0}, {{static_cast<double>(k + 1), 0}}, Pose2()};
      table.add(mapped);
    }
  std::vector<MappedTemplate> templates;
  templates.push_back({"distance", std::make_shared<DistanceTemplate>(), PatternIndex(std::move(table))});
  return templates;
}

/// How many mapped patterns each lookup expects, of one observed point at each distance.
std::vector<std::size_t> expected(const std::vector<std::size_t>& counts, const SearchOptions& options = {}) {
  std::vector<Feature> features;
  for (std::size_t k = 0; k < counts.size(); ++k)
    features.push_back({"acme:Point", Point(static_cast<double>(k + 1), 0)});
  std::vector<std::size_t> numbers;
  for (const PatternLookup& lookup :
       choose_lookups(templates_with(counts), features, options, PatternKind::constrained))
    numbers.push_back(lookup.expected);
  return numbers;
}

using Numbers = std::vector<std::size_t>;

SearchOptions options_with(int places, int places_per_scan) {
  SearchOptions options;
  options.places = options.lookup_limit = places;
  options.places_per_scan = places_per_scan;
  return options;
}

}  // namespace

TEST_CASE("what the map has least often is looked up first, and what it does not have is not") {
  CHECK(expected({5, 0, 2, 9}) == Numbers{2, 5, 9});
  CHECK(expected({0, 0}).empty());
}

TEST_CASE("the rarer of two frequent patterns is known, however frequent they are") {
  CHECK(expected({3000, 2500}).front() == 2500);
}

TEST_CASE("a lookup with many places is made where there is none with fewer") {
  CHECK(expected({4000}, options_with(10, 1000)) == Numbers{4000});
  CHECK(expected({4000, 3}, options_with(10, 1000)) == Numbers{3});
}

TEST_CASE("of one template the rarest patterns are looked up that have few places together, one in any case") {
  SearchOptions options;
  options.places = 0;  // of all templates together there is no limit
  options.places_per_scan = 0;
  options.lookup_limit = 10;
  CHECK(expected({6, 4, 5}, options) == Numbers{4, 5});
  CHECK(expected({50, 40}, options) == Numbers{40});
}

TEST_CASE("a lookup with more places than scans can look at in time is not made") {
  CHECK(expected({400}, options_with(10, 10)).empty());
  CHECK(expected({400}, options_with(10, 0)) == Numbers{400});  // all places at one scan
}

namespace {

/// A wall's pattern is its length, in whole metres.
struct LengthTemplate final : PatternTemplate {
  PatternShape shape() const override { return {{GeometryKind::segment}, 0, 0}; }
  std::optional<PatternInstance> match(std::span<const Feature* const> features) const override {
    const auto& wall = std::get<Segment>(features[0]->geometry);
    return PatternInstance{{0}, {{std::round(wall.length_m()), 0.1}}, Pose2(wall.midpoint(), 0)};
  }
};

Feature wall(double length_m, double support_m) {
  Feature wall{"opal:Wall", Segment{{0, 0}, {length_m, 0}}};
  wall.support_m = support_m;
  return wall;
}

/// The length of the wall that is looked up, where only one is. The map has one of each length.
std::size_t looked_up_m(const std::vector<Feature>& walls) {
  PatternList table;
  for (int length_m = 1; length_m <= 5; ++length_m) {
    PatternInstance mapped{{0}, {{static_cast<double>(length_m), 0}}, Pose2()};
    table.add(mapped);
  }
  std::vector<MappedTemplate> templates;
  templates.push_back({"length", std::make_shared<LengthTemplate>(), PatternIndex(std::move(table))});
  SearchOptions one;
  one.patterns = 1;
  const auto lookups = choose_lookups(templates, walls, one, PatternKind::constrained);
  REQUIRE(lookups.size() == 1);
  const std::size_t chosen = static_cast<std::size_t>(lookups.front().observed.members.front());
  return static_cast<std::size_t>(std::get<Segment>(walls[chosen].geometry).length_m());
}

}  // namespace

TEST_CASE("of walls the one of which most is seen is looked up, and one that does not say how much is seen entirely") {
  CHECK(looked_up_m({wall(3, 2), wall(4, 1), wall(2, 1.5)}) == 3);
  CHECK(looked_up_m({wall(5, 1), wall(2, 0), wall(3, 1.5)}) == 2);
  CHECK(looked_up_m({wall(5, 4), wall(3, 0), wall(4, 0)}) == 5);
}
