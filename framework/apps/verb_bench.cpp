#include "bench_site.hpp"
#include "join_options.hpp"
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
#include <malloc.h>
#include <numeric>
#include <sys/resource.h>

namespace {

namespace fs = std::filesystem;

struct BenchOptions {
  std::vector<std::string> prefixes;
  std::string out;
  std::string config;
  DamageOptions damage;
  bool joined = false;
  JoinOptions join;
};

double peak_rss_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

double quantile(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return 0;
  return sorted[std::min(sorted.size() - 1, static_cast<std::size_t>(share * static_cast<double>(sorted.size())))];
}

double allocated_mb() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd) / (1 << 20);
}

/// What a run is measured by, besides its results.
struct BenchCost {
  std::size_t queries = 0;
  double import_s = 0;
  double localizer_mb = 0;  ///< what the map's indices take
};

nlohmann::ordered_json summarize(const RunRecord& all, const BenchCost& cost) {
  std::vector<double> cpu = all.update_cpu_ms;
  std::sort(cpu.begin(), cpu.end());
  const double n = std::max<double>(1, static_cast<double>(cpu.size()));
  const auto mean_ms = [&](double sum_s) { return 1e3 * sum_s / n; };
  return {{"queries", cost.queries},
          {"updates", cpu.size()},
          {"cpu_ms_mean", std::accumulate(cpu.begin(), cpu.end(), 0.0) / n},
          {"cpu_ms_median", quantile(cpu, 0.5)},
          {"cpu_ms_p99", quantile(cpu, 0.99)},
          {"cpu_ms_max", cpu.empty() ? 0 : cpu.back()},
          {"peak_rss_mb", peak_rss_mb()},
          {"localizer_mb", cost.localizer_mb},
          {"import_s", cost.import_s},
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

/// All queries of a place. Results are told in the frame of the place's own map.
nlohmann::ordered_json run_site(const BenchSite& site, opal::Deployment deployment,
                                const opal::PluginRegistry& registry, const fs::path& results_file) {
  const std::vector<opal::Query> queries = opal::read_queries(site.prefix + ".queries.json");
  const std::string sensor = deployment.laser.id;
  deployment.laser = opal::read_site_laser(site.prefix + ".info.json");
  deployment.laser.id = sensor;

  const double before_mb = allocated_mb();
  opal::Localizer localizer(opal::build_parts(deployment, registry, site.map));
  const BenchCost cost{queries.size(), site.import_s, allocated_mb() - before_mb};
  const auto reader = open_log(registry, site.prefix + ".log.gz");
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
  for (opal::ResultRow& row : all.rows) row.T_map_laser = site.T_map_site.inverse() * row.T_map_laser;
  auto results = writable(results_file);
  opal::write_results(results, all.rows);
  return summarize(all, cost);
}

int bench(const BenchOptions& options) {
  const opal::PluginRegistry registry = load_plugins();
  const opal::Deployment deployment =
      opal::read_deployment(options.config.empty() ? shipped_config("default.jsonld") : options.config);
  opal::MapJoin join = options.join.join;
  join.seed = options.damage.seed;
  if (join.copies > 0 && !options.joined) throw opal::ConfigError("bench: --copies without --join");
  std::vector<BenchSite> sites = load_sites(registry, options.prefixes, options.damage);
  if (options.joined) join_sites(sites, join);
  const fs::path out = options.out;
  const bool single = sites.size() == 1;
  for (const BenchSite& site : sites) {
    const fs::path folder = single ? out : out / site.name;
    fs::create_directories(folder);
    const auto summary = run_site(site, deployment, registry, single ? out / "results.csv" : out / (site.name + ".csv"));
    writable(folder / "summary.json") << summary.dump(2) << '\n';
    std::cout << (single ? "" : site.name + ": ") << summary.dump(2) << '\n';
  }
  return 0;
}

}  // namespace

void opal::add_bench_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<BenchOptions>();
  CLI::App* verb = app.add_subcommand("bench", "recorded places from end to end: import their maps, run their queries");
  verb->add_option("PREFIX", options->prefixes,
                   "PREFIX.map.yaml, PREFIX.info.json, PREFIX.queries.json and PREFIX.log.gz are read")
      ->required();
  verb->add_option("-o,--out", options->out, "folder for results.csv and summary.json; for several places: NAME.csv and NAME/summary.json")
      ->required();
  options->damage.add_to(*verb);
  verb->add_flag("--join", options->joined,
                 "run every query on the maps of all places side by side; results are in the frame of the place's own map");
  options->join.add_to(*verb);
  verb->add_option("--config", options->config, "deployment to run (default: configs/default.jsonld)");
  verb->callback([options, &exit_code] { exit_code = bench(*options); });
}
