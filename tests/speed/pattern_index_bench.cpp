// The pattern index over maps of growing size: a lookup that finds the same few patterns should cost about the
// logarithm of the number of patterns.
#include "patterns/pattern_index.hpp"

#include <catch2/catch.hpp>

#include <random>

using namespace opal;

namespace {

PatternIndex random_index(int size) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> turn(0.35, 2.8), extent(-12, 12);
  std::vector<PatternInstance> patterns(size);
  for (PatternInstance& pattern : patterns)
    pattern.invariants = {{turn(random)}, {extent(random)}, {extent(random)}, {extent(random)}, {extent(random)}};
  return PatternIndex(patterns);
}

/// About five patterns whatever the size: the box shrinks as the map grows.
PatternInstance query_for(int size) {
  const double share = std::pow(5.0 / size, 0.2);
  PatternInstance query;
  query.invariants = {{1.57, 1.2 * share, Comparison::equal}};
  for (int k = 0; k < 4; ++k) query.invariants.push_back({0, 12 * share, Comparison::equal});
  return query;
}

}  // namespace

TEST_CASE("pattern index lookups", "[!benchmark]") {
  for (const int size : {1000, 10000, 100000, 1000000}) {
    const PatternIndex index = random_index(size);
    const PatternInstance query = query_for(size);
    BENCHMARK("find among " + std::to_string(size)) { return index.find(query).size(); };
  }
}
