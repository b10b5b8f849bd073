// What the map store costs: build/release/bin/map_store_tests "[.measurement]". docs/notebook/maps_and_kidnapping.md
// has the table.
#include "made_maps.hpp"

#include <opal/map/view/map_view.hpp>

#include <catch2/catch.hpp>

#include <chrono>
#include <cstdio>
#include <random>

using namespace opal;
using namespace opal::store_tests;

namespace {

template <class Work>
double seconds_of(Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Mean time of a question [ms].
template <class Ask>
double ms_per_question(const MapView& view, int questions, Ask ask) {
  std::mt19937 random(1);
  const auto [low, high] = view.bounds();
  std::uniform_real_distribution<double> x(low.x(), high.x()), y(low.y(), high.y());
  ask(Point(low));  // the first one finds a connection, and the server's memory warm
  return 1000 * seconds_of([&] {
           for (int k = 0; k < questions; ++k) ask(Point{x(random), y(random)});
         }) /
         questions;
}

}  // namespace

TEST_CASE("what the map store costs", "[.measurement]") {
  std::printf("features, push s, pull s, parse s, document MB, ms per question r = 10 m and 30 m: store, view\n");
  const auto both = store();
  for (const int features : {1000, 10000, 100000}) {
    const Map map = large_map(features, 1);
    const std::string building = "measured " + std::to_string(features);
    StoredMap pulled;
    const double push_s = seconds_of([&] { both->push(*map, {building}); });
    const double pull_s = seconds_of([&] { pulled = both->pull(building, 0); });
    const double parse_s = seconds_of([&] { (void)SemanticMap::parse(pulled.document, "pulled"); });
    const MapView view(map, "PlanarLidar2D");
    std::printf("%d, %.2f, %.2f, %.2f, %.1f", features, push_s, pull_s, parse_s,
                1e-6 * static_cast<double>(pulled.document.size()));
    for (const double radius_m : {10.0, 30.0}) {
      const auto ask_store = [&](const Point& p) {
        (void)both->features_near({building, 0, "PlanarLidar2D", p, radius_m});
      };
      std::printf(", %.2f", ms_per_question(view, 200, ask_store));
      std::printf(" %.4f", ms_per_question(view, 2000, [&](const Point& p) { (void)view.within(p, radius_m); }));
    }
    std::printf("\n");
  }
}
