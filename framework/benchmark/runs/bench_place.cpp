#include "benchmark/runs/bench_place.hpp"

#include "sensing/log_check.hpp"
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
  const std::string info = site.prefix + ".info.json", log = site.prefix + ".log.gz";
  const opal::LaserModel laser = opal::read_site_laser(info);
  std::vector<opal::LogRecord> records = opal::read_all(*open_log(registry, log, deployment));
  opal::check_log(records, laser, log, info);
  return {site, with_laser(std::move(deployment), laser), opal::read_queries(site.prefix + ".queries.json"),
          std::move(records)};
}
