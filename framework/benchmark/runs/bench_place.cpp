#include "benchmark/runs/bench_place.hpp"

#include "session/session.hpp"

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
  auto records = opal::read_all(*open_log(registry, site.prefix + ".log.gz", deployment));
  return {site, with_laser(std::move(deployment), opal::read_site_laser(site.prefix + ".info.json")),
          opal::read_queries(site.prefix + ".queries.json"), std::move(records)};
}
