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

TEST_CASE("a lookup with more places than scans can look at in time is not made") {
  CHECK(expected({400}, options_with(10, 10)).empty());
  CHECK(expected({400}, options_with(10, 0)) == Numbers{400});  // all places at one scan
}
