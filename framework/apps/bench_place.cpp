#include "bench_place.hpp"

#include "session.hpp"

#include <ctime>
#include <filesystem>

double process_cpu_s() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

opal::Replay BenchPlace::replay(const opal::Query& window) const {
  opal::ReplayOptions options;
  options.from_s = window.start_s;
  options.to_s = window.end_s;
  return {records, deployment.laser, options};
}

BenchPlace read_bench_place(const opal::PluginRegistry& registry, const std::string& prefix,
                            const std::string& config) {
  BenchPlace place;
  place.prefix = prefix;
  place.name = std::filesystem::path(prefix).filename().string();
  place.queries = opal::read_queries(prefix + ".queries.json");
  place.deployment = opal::read_deployment(config.empty() ? shipped_config("default.jsonld") : config);
  const std::string sensor = place.deployment.laser.id;
  place.deployment.laser = opal::read_site_laser(prefix + ".info.json");
  place.deployment.laser.id = sensor;
  const double import_start_s = process_cpu_s();
  place.map = import_map(registry, prefix + ".map.yaml").map;
  place.import_s = process_cpu_s() - import_start_s;
  place.records = opal::read_all(*open_log(registry, prefix + ".log.gz"));
  return place;
}
