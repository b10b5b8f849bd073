#include "benchmark/runs/bench_place.hpp"

#include "benchmark/runs/recorded_log.hpp"
#include "sensing/log_check.hpp"

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
  const std::string info = site.prefix + ".info.json", queries = site.prefix + ".queries.json";
  RecordedLog log = read_recorded_log(registry, site.prefix + ".log.gz", deployment);
  const opal::LaserModel laser = opal::read_site_laser(info);
  opal::check_log(log.records, laser, log.file, info);
  BenchPlace place{site, with_laser(std::move(deployment), laser), opal::read_queries(queries), {}};
  expect_scans(place.queries, log, queries);
  place.records = std::move(log.records);
  return place;
}
