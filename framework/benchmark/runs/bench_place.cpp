#include "benchmark/runs/bench_place.hpp"

#include "benchmark/runs/recorded_log.hpp"
#include "sensing/log_check.hpp"

namespace opal::benchmark {

opal::Replay BenchPlace::replay(const opal::Query& window) const {
  opal::ReplayOptions options;
  options.from_s = window.start_s;
  options.to_s = window.end_s;
  return {records, deployment.lasers, options};
}

RunRecord run_query(opal::Localizer& localizer, const BenchPlace& place, const opal::Query& window,
                    const RunObserver& observer) {
  localizer.reset();
  opal::Replay replay = place.replay(window);
  return run_log(localizer, place.deployment.lasers.front(), replay, window.id, observer);
}

namespace {

/// A place describes the one laser that recorded it; a robot with several describes them itself.
opal::Deployment with_recorded_lasers(opal::Deployment deployment, const RecordedLog& log, const std::string& info) {
  if (deployment.lasers.size() > 1) {
    deployment.lasers =
        opal::lasers_of_log(log.records, std::move(deployment.lasers), log.file, deployment.file + ": /sensor");
    return deployment;
  }
  const opal::LaserModel laser = opal::read_site_laser(info);
  opal::check_log(log.records, laser, log.file, info);
  return with_lasers(std::move(deployment), {laser});
}

}  // namespace

BenchPlace read_bench_place(const opal::PluginRegistry& registry, const BenchSite& site, opal::Deployment deployment) {
  const std::string info = site.prefix + ".info.json", queries = site.prefix + ".queries.json";
  RecordedLog log = read_recorded_log(registry, site.prefix + ".log.gz", deployment);
  deployment = with_recorded_lasers(std::move(deployment), log, info);
  BenchPlace place{site, std::move(deployment), opal::read_queries(queries), {}};
  expect_scans(place.queries, log, queries);
  place.records = std::move(log.records);
  return place;
}

}  // namespace opal::benchmark
