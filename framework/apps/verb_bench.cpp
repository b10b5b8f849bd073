#include "bench_splices.hpp"
#include "damage_options.hpp"
#include "session.hpp"
#include "verbs.hpp"

#include <opal/error.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
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
  std::optional<std::uint64_t> splice;  ///< seed
  opal::SpliceOptions splices;
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

RunRecord run_queries(opal::Localizer& localizer, const BenchPlace& place) {
  RunRecord all;
  for (const opal::Query& query : place.queries) {
    localizer.reset();
    opal::Replay replay = place.replay(query);
    all.append(run_log(localizer, place.deployment.laser, replay, query.id));
  }
  return all;
}

SplicedRuns run_kidnappings(opal::Localizer& localizer, const BenchPlace& place, const BenchOptions& options) {
  opal::SpliceOptions splices = options.splices;
  splices.seed = *options.splice;
  return run_splices(localizer, place, opal::GroundTruth::read(place.prefix + ".gt.csv"), splices);
}

int bench(const BenchOptions& options) {
  const opal::PluginRegistry registry = load_plugins();
  BenchPlace place = read_bench_place(registry, options.prefix, options.config);
  if (options.damage.any()) place.map = opal::damaged_map(*place.map, options.damage.damage());
  opal::Localizer localizer(opal::build_parts(place.deployment, registry, place.map));
  SplicedRuns kidnapped;
  if (options.splice) kidnapped = run_kidnappings(localizer, place, options);
  const RunRecord all = options.splice ? std::move(kidnapped.all) : run_queries(localizer, place);

  const fs::path out(options.out);
  fs::create_directories(out);
  auto results = writable(out / "results.csv"), rivals = writable(out / "rivals.csv");
  opal::write_results(results, all.rows);
  opal::write_rivals(rivals, all.rivals);
  if (options.splice) {
    auto splices = writable(out / "splices.csv");
    opal::write_kidnappings(splices, kidnapped.verdicts);
    std::cout << opal::summary_of(kidnapped.verdicts);
  }
  auto summary = summarize(all, options.splice ? kidnapped.verdicts.size() : place.queries.size(), place.import_s);
  summary["site"] = fs::absolute(options.prefix).lexically_normal().string();
  writable(out / "summary.json") << summary.dump(2) << '\n';
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
  verb->add_option("-o,--out", options->out, "folder for results.csv, rivals.csv and summary.json")->required();
  options->damage.add_to(*verb);
  verb->add_option("--config", options->config, "deployment to run (default: configs/default.jsonld)");
  verb->add_option("--splice", options->splice,
                   "kidnap the robot instead: join windows with a cut that nothing tells, drawn by this seed; reads "
                   "PREFIX.gt.csv to choose and to judge, and also writes splices.csv");
  verb->add_option("--splices", options->splices.count, "so many (default: as many as there are queries)")
      ->check(CLI::Range(1, 100000));
  verb->callback([options, &exit_code] { exit_code = bench(*options); });
}
