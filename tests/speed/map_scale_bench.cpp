// Patterns of synthetic buildings of 10^3 to 10^6 features: what loading costs, and what a lookup costs. Columns stand
// on a grid of 6 m, moved by up to 1.5 m, with radii of 0.2 to 0.6 m; patterns are pairs within 6.5 m.
#include <opal/plugin/plugin_registry.hpp>
#include "patterns/pattern_index.hpp"

#include "common/stage_clock.hpp"

#include <catch2/catch.hpp>

#include <cstdio>
#include <random>

using namespace opal;

namespace {

std::vector<Feature> columns(int count) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> aside(-1.5, 1.5), radius(0.2, 0.6);
  const int side = static_cast<int>(std::ceil(std::sqrt(count)));
  std::vector<Feature> features;
  for (int k = 0; k < count; ++k) {
    const int column = k % side, row = k / side;
    features.push_back(
        {"opal:Column", Circle{{6.0 * column + aside(random), 6.0 * row + aside(random)}, radius(random)}});
  }
  return features;
}

/// Every so many patterns as a robot would see them: with noise, and a tolerance that finds about as many in any map.
std::vector<PatternInstance> observed(std::span<const PatternInstance> patterns, int queries) {
  std::mt19937 random(4);
  std::uniform_int_distribution<std::size_t> any(0, patterns.size() - 1);
  std::normal_distribution<double> noise(0, 0.01);
  const double tolerance = 0.5 * std::cbrt(10.0 / static_cast<double>(patterns.size()));
  std::vector<PatternInstance> seen;
  for (int k = 0; k < queries; ++k) {
    seen.push_back(patterns[any(random)]);
    for (Invariant& invariant : seen.back().invariants) {
      invariant.value += std::min(tolerance, 0.01) * noise(random);
      invariant.tolerance = tolerance;
    }
  }
  return seen;
}

template <class Query>
double mean_us(const std::vector<PatternInstance>& queries, Query query) {
  const double start_s = thread_cpu_s();
  std::size_t sum = 0;
  for (const PatternInstance& each : queries) sum += query(each);
  REQUIRE(sum > 0);
  return 1e6 * (thread_cpu_s() - start_s) / static_cast<double>(queries.size());
}

}  // namespace

TEST_CASE("patterns of buildings of growing size", "[!benchmark]") {
  PluginRegistry registry;
  registry.load_all(OPAL_PLUGIN_DIR);
  const auto pair = registry.make<PatternTemplate>("opal:ColumnPair", {{"reach_m", 6.5}});
  std::printf("\nfeatures  patterns  find all s  build index s  find us  count us  found\n");
  for (const int size : {1000, 10000, 100000, 1000000}) {
    const auto features = columns(size);
    const double start_s = thread_cpu_s();
    const auto patterns = find_patterns(*pair, features);
    const double found_s = thread_cpu_s();
    const PatternIndex index(patterns);
    const double built_s = thread_cpu_s();
    const auto queries = observed(patterns, 2000);
    double matches = 0;
    for (const PatternInstance& query : queries) matches += static_cast<double>(index.find(query).size());
    const double find_us = mean_us(queries, [&](const PatternInstance& q) { return index.find(q).size(); });
    const double count_us = mean_us(queries, [&](const PatternInstance& q) { return index.count(q, 30000); });
    std::printf("%8d  %8zu  %10.3f  %13.3f  %7.2f  %8.2f  %5.1f\n", size, index.patterns().size(), found_s - start_s,
                built_s - found_s, find_us, count_us, matches / static_cast<double>(queries.size()));
  }
}
