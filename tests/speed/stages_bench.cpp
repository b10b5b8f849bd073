// CPU time per pipeline stage on the recorded halls: median and 95th percentile over keyframes, in pipeline order.
#include "tests/system/replay/recorded_site.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdio>

using namespace opal;

namespace {

struct Stage {
  const char* name;
  double StageTimes::*time;
};

constexpr Stage kStages[] = {{"sensor", &StageTimes::sensor_s},         {"detect", &StageTimes::detect_s},
                             {"local map", &StageTimes::local_map_s},   {"track", &StageTimes::track_s},
                             {"generate", &StageTimes::generate_s},     {"search", &StageTimes::search_s},
                             {"retrospect", &StageTimes::retrospect_s}, {"grow", &StageTimes::grow_s},
                             {"status", &StageTimes::status_s}};

double quantile_ms(std::vector<double> times_s, double share) {
  std::sort(times_s.begin(), times_s.end());
  return 1e3 * times_s[static_cast<std::size_t>(share * static_cast<double>(times_s.size() - 1))];
}

}  // namespace

TEST_CASE("stages of the pipeline on recorded logs", "[!benchmark]") {
  for (const char* name : {"malaga-demo", "malaga"}) {
    const RecordedSite site(name);
    Localizer localizer(site.parts());
    std::vector<StageTimes> updates;
    for (const Sample& sample : site.samples)
      if (localizer.update(sample)) updates.push_back(localizer.last_times());
    REQUIRE_FALSE(updates.empty());
    std::printf("\n%s, %zu keyframes       median      p95  [ms]\n", name, updates.size());
    for (const Stage& stage : kStages) {
      std::vector<double> times;
      for (const StageTimes& update : updates) times.push_back(update.*stage.time);
      std::printf("  %-24s %9.3f %8.3f\n", stage.name, quantile_ms(times, 0.5), quantile_ms(times, 0.95));
    }
  }
}
