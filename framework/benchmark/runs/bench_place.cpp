#include "benchmark/runs/bench_place.hpp"

#include "benchmark/runs/recorded_log.hpp"

opal::Replay BenchPlace::replay(const opal::Query& window) const {
  opal::ReplayOptions options;
  options.from_s = window.start_s;
  options.to_s = window.end_s;
  return {records, deployment.laser, options};
}

RunRecord run_query(opal::Localizer& localizer, const BenchPlace& place, const opal::Query& window,
                    const RunObserver& observer) {
  localizer.reset();
  opal::Replay replay = place.replay(window);
  return run_log(localizer, place.deployment.laser, replay, window.id, observer);
}

BenchPlace read_bench_place(const opal::PluginRegistry& registry, const BenchSite& site, opal::Deployment deployment) {
  const std::string queries = site.prefix + ".queries.json";
  RecordedLog log = read_recorded_log(registry, site.prefix + ".log.gz");
  BenchPlace place{site,
                   with_laser(std::move(deployment), opal::read_site_laser(site.prefix + ".info.json")),
                   opal::read_queries(queries),
                   {}};
  expect_scans(place.queries, log, queries);
  place.records = std::move(log.records);
  return place;
}
