#include "damage_options.hpp"
#include "run_record.hpp"
#include "session.hpp"
#include "verbs.hpp"

#include <opal/deployment.hpp>
#include <opal/error.hpp>
#include <opal/site.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <numeric>
#include <sys/resource.h>

namespace {

namespace fs = std::filesystem;

struct BenchOptions {
  std::string prefix;
  std::string out;
  std::string config;
  DamageOptions damage;
};

double process_cpu_s() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double peak_rss_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

double quantile(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return 0;
  return sorted[std::min(sorted.size() - 1, static_cast<std::size_t>(share * static_cast<double>(sorted.size())))];
}

nlohmann::ordered_json summarize(const RunRecord& all, std::size_t queries, double import_s) {
  std::vector<double> cpu = all.update_cpu_ms;
  std::sort(cpu.begin(), cpu.end());
  const double n = std::max<double>(1, static_cast<double>(cpu.size()));
  const auto mean_ms = [&](double sum_s) { return 1e3 * sum_s / n; };
  return {{"queries", queries},
          {"updates", cpu.size()},
          {"cpu_ms_mean", std::accumulate(cpu.begin(), cpu.end(), 0.0) / n},
          {"cpu_ms_median", quantile(cpu, 0.5)},
          {"cpu_ms_p99", quantile(cpu, 0.99)},
          {"cpu_ms_max", cpu.empty() ? 0 : cpu.back()},
          {"peak_rss_mb", peak_rss_mb()},
          {"import_s", import_s},
          {"hypotheses_mean", all.hypotheses / n},
          {"stage_ms_mean",
           {{"detect", mean_ms(all.stages.detect_s)},
            {"local_map", mean_ms(all.stages.local_map_s)},
            {"track", mean_ms(all.stages.track_s)},
            {"associate", mean_ms(all.stages.associate_s)},
            {"verify", mean_ms(all.stages.verify_s)}}}};
}

std::ofstream writable(const fs::path& path) {
  std::ofstream file(path);
  if (!file) throw opal::Error(path.string() + ": cannot be written");
  return file;
}

int bench(const BenchOptions& options) {
  const opal::PluginRegistry registry = load_plugins();
  const std::vector<opal::Query> queries = opal::read_queries(options.prefix + ".queries.json");
  opal::Deployment deployment =
      opal::read_deployment(options.config.empty() ? shipped_config("default.jsonld") : options.config);
  const std::string sensor = deployment.laser.id;
  deployment.laser = opal::read_site_laser(options.prefix + ".info.json");
  deployment.laser.id = sensor;

  const double import_start_s = process_cpu_s();
  auto map = import_map(registry, options.prefix + ".map.yaml").map;
  const double import_s = process_cpu_s() - import_start_s;

  if (options.damage.any()) map = opal::damaged_map(*map, options.damage.damage());

  opal::Localizer localizer(opal::build_parts(deployment, registry, map));
  const auto reader = open_log(registry, options.prefix + ".log.gz");
  const std::vector<opal::LogRecord> records = opal::read_all(*reader);
  RunRecord all;
  for (const opal::Query& query : queries) {
    localizer.reset();
    opal::ReplayOptions window;
    window.from_s = query.start_s;
    window.to_s = query.end_s;
    opal::Replay replay(records, deployment.laser, window);
    all.append(run_log(localizer, deployment.laser, replay, query.id));
  }

  fs::create_directories(options.out);
  auto results = writable(fs::path(options.out) / "results.csv");
  opal::write_results(results, all.rows);
  const auto summary = summarize(all, queries.size(), import_s);
  writable(fs::path(options.out) / "summary.json") << summary.dump(2) << '\n';
  std::cout << summary.dump(2) << '\n';
  return 0;
}

}  // namespace

void opal::add_bench_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<BenchOptions>();
  CLI::App* verb = app.add_subcommand("bench", "one recorded place from end to end: import its map, run its queries");
  verb->add_option("PREFIX", options->prefix,
                   "PREFIX.map.yaml, PREFIX.info.json, PREFIX.queries.json and PREFIX.log.gz are read")
      ->required();
  verb->add_option("-o,--out", options->out, "folder for results.csv and summary.json")->required();
  options->damage.add_to(*verb);
  verb->add_option("--config", options->config, "deployment to run (default: configs/default.jsonld)");
  verb->callback([options, &exit_code] { exit_code = bench(*options); });
}
