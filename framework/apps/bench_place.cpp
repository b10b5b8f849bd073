#include "bench_place.hpp"

#include "session.hpp"

opal::Replay BenchPlace::replay(const opal::Query& window) const {
  opal::ReplayOptions options;
  options.from_s = window.start_s;
  options.to_s = window.end_s;
  return {records, deployment.laser, options};
}

BenchPlace read_bench_place(const opal::PluginRegistry& registry, const BenchSite& site, opal::Deployment deployment) {
  BenchPlace place{site, std::move(deployment), opal::read_queries(site.prefix + ".queries.json"), {}};
  const std::string sensor = place.deployment.laser.id;
  place.deployment.laser = opal::read_site_laser(site.prefix + ".info.json");
  place.deployment.laser.id = sensor;
  place.records = opal::read_all(*open_log(registry, site.prefix + ".log.gz"));
  return place;
}
