#include "patterns/pattern_index.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>

using namespace opal;

namespace {

/// Two points at a distance, the first one the lower left: enough to see what the framework enumerates.
class PointPair final : public PatternTemplate {
 public:
  explicit PointPair(double reach_m) : reach_m_(reach_m) {}
  PatternShape shape() const override { return {{GeometryKind::point, GeometryKind::point}, reach_m_}; }
  std::optional<PatternInstance> match(std::span<const Feature* const> features) const override {
    const auto &a = std::get<Point>(features[0]->geometry), &b = std::get<Point>(features[1]->geometry);
    if (std::pair(b.x(), b.y()) < std::pair(a.x(), a.y())) return std::nullopt;
    PatternInstance instance;
    instance.members = {0, 1};
    instance.invariants = {{(b - a).norm(), 0.1, Comparison::equal}};
    return instance;
  }

 private:
  double reach_m_;
};

std::vector<Feature> random_points(int count, double side_m, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0, side_m);
  std::vector<Feature> features(count);
  for (Feature& feature : features) feature.geometry = Point{place(random), place(random)};
  return features;
}

PatternInstance with_invariants(std::vector<Invariant> invariants) {
  PatternInstance instance;
  instance.invariants = std::move(invariants);
  return instance;
}

bool matches(const Invariant& mapped, const Invariant& observed) {
  const auto m = static_cast<float>(mapped.value), o = static_cast<float>(observed.value),
             t = static_cast<float>(observed.tolerance);
  switch (observed.comparison) {
    case Comparison::equal: return m >= o - t && m <= o + t;
    case Comparison::mapped_at_most: return m <= o + t;
    case Comparison::mapped_at_least: return m >= o - t;
  }
  return false;
}

}  // namespace

TEST_CASE("pattern search finds the same pairs as a comparison of all with all") {
  const PointPair pair(3.0);
  const std::vector<Feature> features = random_points(120, 20, 7);
  std::vector<std::pair<int, int>> expected;
  for (int a = 0; a < 120; ++a)
    for (int b = 0; b < 120; ++b) {
      const Feature* both[] = {&features[a], &features[b]};
      const double gap = (std::get<Point>(both[0]->geometry) - std::get<Point>(both[1]->geometry)).norm();
      if (a != b && gap <= 3.0 && pair.match(both)) expected.emplace_back(a, b);
    }
  std::vector<std::pair<int, int>> found;
  for (const PatternInstance& instance : find_patterns(pair, features))
    found.emplace_back(instance.members[0], instance.members[1]);
  std::sort(found.begin(), found.end());
  CHECK(found == expected);
}

TEST_CASE("the pattern index finds exactly what a walk over all patterns finds") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> value(-5, 5);
  const Comparison comparisons[] = {Comparison::equal, Comparison::mapped_at_most, Comparison::mapped_at_least};
  std::vector<PatternInstance> patterns;
  for (int k = 0; k < 3000; ++k)
    patterns.push_back(with_invariants({{value(random)}, {value(random)}, {value(random)}}));
  const PatternIndex index(patterns);
  for (int query = 0; query < 200; ++query) {
    std::vector<Invariant> invariants;
    for (const Comparison comparison : comparisons) invariants.push_back({value(random), 0.7, comparison});
    const PatternInstance observed = with_invariants(invariants);
    std::vector<int> expected;
    for (int k = 0; k < 3000; ++k) {
      bool all = true;
      for (int d = 0; d < 3; ++d) all = all && matches(patterns[k].invariants[d], invariants[d]);
      if (all) expected.push_back(k);
    }
    CAPTURE(query);
    CHECK(index.find(observed) == expected);
    CHECK(index.count(observed, 1000000) == expected.size());
    CHECK(index.count(observed, 5) == std::min<std::size_t>(5, expected.size()));
  }
}

TEST_CASE("an index of no patterns answers that there are none") {
  const PatternIndex index{PatternList()};
  CHECK(index.find(with_invariants({{1.0, 0.1, Comparison::equal}})).empty());
  CHECK(index.count(with_invariants({{1.0, 0.1, Comparison::equal}}), 10) == 0);
}

namespace {

/// Any two faces that touch.
class TouchingFaces final : public PatternTemplate {
 public:
  PatternShape shape() const override { return {{GeometryKind::segment, GeometryKind::segment}, 0.1}; }
  std::optional<PatternInstance> match(std::span<const Feature* const>) const override {
    PatternInstance instance;
    instance.members = {0, 1};
    return instance;
  }
};

bool touch(const Segment& a, const Segment& b) {
  return !find_patterns(TouchingFaces(), std::vector<Feature>{{"opal:Wall", a}, {"opal:Wall", b}}).empty();
}

PatternInstance extended(double min_m, double max_m) {
  PatternInstance instance;
  instance.members = {0};
  instance.extent_min_m = min_m;
  instance.extent_max_m = max_m;
  return instance;
}

}  // namespace

TEST_CASE("faces that cross touch, however long they are, and those whose extensions cross do not") {
  const double length_m = GENERATE(0.4, 6.0);
  const Segment along{{0, 0}, {length_m, 0}};
  for (const double at : {0.3, 0.7}) {
    const Point middle(at * length_m, 0), half(0, 0.5 * length_m), farther(0, 0.2 * length_m + 0.15);
    CHECK(touch(along, {middle - half, middle + half}));
    CHECK(touch({middle - half, middle + half}, along));
    CHECK_FALSE(touch(along, {middle + farther, middle + farther + half}));
    CHECK_FALSE(touch({middle - farther, middle - farther - half}, along));
  }
  CHECK(touch(along, {{0, 0.05}, {length_m, 0.05}}));
  CHECK_FALSE(touch(along, {{0, 0.15}, {length_m, 0.15}}));
}

TEST_CASE("a table keeps how far each pattern extends, whichever of them do") {
  std::vector<PatternInstance> patterns{extended(-2, 0), extended(0, 0), extended(0, 3), extended(0, 0)};
  for (int turn = 0; turn < 4; ++turn) {
    std::rotate(patterns.begin(), patterns.begin() + 1, patterns.end());
    const PatternTable table{PatternList(patterns)},
        first{PatternList(std::span<const PatternInstance>(patterns).first(1))};
    REQUIRE(table.size() == 4);
    for (int k = 0; k < 4; ++k)
      CHECK(table.extent_m(k) == std::array<double, 2>{patterns[k].extent_min_m, patterns[k].extent_max_m});
    CHECK(first.extent_m(0) == table.extent_m(0));
  }
}

TEST_CASE("patterns without invariants are all alike, however many there are") {
  for (const int count : {0, 1, 16, 17, 1000}) {
    const PatternIndex index(
        PatternList(std::vector<PatternInstance>(static_cast<std::size_t>(count), with_invariants({}))));
    CHECK(index.find(with_invariants({})).size() == static_cast<std::size_t>(count));
    CHECK(index.count(with_invariants({}), 5) == static_cast<std::size_t>(std::min(count, 5)));
  }
}

TEST_CASE("a pattern with another number of invariants than the first of its template is refused") {
  PatternList table;
  table.add(with_invariants({{1, 0.1, Comparison::equal}}));
  CHECK_THROWS_AS(table.add(with_invariants({})), PluginError);
  CHECK(table.size() == 1);
}
