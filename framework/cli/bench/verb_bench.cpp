#include "benchmark/runs/answer.hpp"
#include "cli/bench/bench_cost.hpp"
#include "cli/bench/bench_kidnappings.hpp"
#include "cli/options/damage_options.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/options/join_options.hpp"
#include "cli/options/number_option.hpp"
#include "cli/options/overlay_options.hpp"
#include "cli/options/run_products.hpp"
#include "cli/options/verbs.hpp"
#include "cli/terminal/run_end.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "evaluation/place_verdict.hpp"
#include "session/overlays.hpp"
#include "session/session.hpp"
#include "session/shipped_files.hpp"

#include <opal/common/error.hpp>
#include "common/text_file.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>

namespace opal::cli {
namespace {

namespace fs = std::filesystem;

struct BenchOptions {
  std::vector<std::string> prefixes;
  std::string out;
  std::string config = "default";
  std::string maps;  ///< folder; empty: the maps beside the recordings
  DamageOptions damage;
  bool joined = false;
  JoinOptions join;
  std::optional<std::uint64_t> sequence;  ///< seed
  KidnappingSequenceOptions sequences;
  OverlayFiles overlays;
};

/// What was run of a place before a stop was asked for; what had begun then is left out.
struct PlaceRun {
  benchmark::RunRecord all;
  std::size_t finished = 0;  ///< queries or kidnappings
  bool is_cut = false;
};

PlaceRun run_queries(Localizer& localizer, const benchmark::BenchPlace& place, const std::stop_token& stop) {
  const benchmark::RunObserver observer{[&](double) { return !stop.stop_requested(); }, {}, {}};
  PlaceRun run;
  for (const Query& query : place.queries) {
    const benchmark::RunRecord record = benchmark::run_query(localizer, place, query, observer);
    run.is_cut = stop.stop_requested();
    if (run.is_cut) break;
    run.all.append(record);
    ++run.finished;
  }
  return run;
}

KidnappingRuns run_kidnappings(Localizer& localizer, const benchmark::BenchPlace& place, const BenchOptions& options,
                               const std::stop_token& stop) {
  KidnappingSequenceOptions sequences = options.sequences;
  sequences.seed = *options.sequence;
  return cli::run_kidnappings(localizer, place, GroundTruth::read(place.site.prefix + ".gt.csv"), sequences, stop);
}

/// Where the results of a place go.
struct BenchFiles {
  fs::path results;  ///< poses
  fs::path folder;   ///< everything else
};

/// Results are told in the frame of the place's own map.
void write_record(benchmark::RunRecord& all, const benchmark::BenchSite& site, const BenchFiles& files) {
  const Pose2 T_site_map = site.T_map_site.inverse();
  for (ResultRow& row : all.rows) row.T_map_laser = T_site_map * row.T_map_laser;
  for (AlternativeRow& row : all.alternatives) row.T_map_laser = T_site_map * row.T_map_laser;
  write_with(files.results.string(), [&](std::ostream& out) { write_results(out, all.rows); });
  write_with((files.folder / "alternatives.csv").string(),
             [&](std::ostream& out) { write_alternatives(out, all.alternatives); });
}

/// Judges the rows of all queries, in the frame of the place's own map, if the place has a recorded truth.
std::optional<PlaceVerdict> judged(const benchmark::BenchPlace& place, const benchmark::RunRecord& all) {
  const std::string truth = place.site.prefix + ".gt.csv";
  if (!fs::exists(truth)) return std::nullopt;
  return judge_place(all.rows, place.queries, GroundTruth::read(truth));
}

/// What a run of a place leaves to tell.
struct PlaceReport {
  nlohmann::ordered_json summary;
  std::string text;  ///< for people: did it work, then the costs
  std::optional<PlaceVerdict> verdict;
  bool is_cut = false;  ///< by a stop
};

PlaceRun run_and_judge_kidnappings(Localizer& localizer, const benchmark::BenchPlace& place,
                                   const BenchOptions& options, const BenchFiles& files, const std::stop_token& stop,
                                   PlaceReport& report) {
  KidnappingRuns runs = run_kidnappings(localizer, place, options, stop);
  write_with((files.folder / "kidnappings.csv").string(),
             [&](std::ostream& out) { write_kidnappings(out, runs.verdicts); });
  report.text = summary_of(runs.verdicts);
  return {std::move(runs.all), runs.verdicts.size(), runs.is_cut};
}

/// Says whether queries succeeded, where their truth is recorded.
void judge(const benchmark::BenchPlace& place, const PlaceRun& run, PlaceReport& report) {
  report.verdict = judged(place, run.all);
  if (!report.verdict) {
    report.text = "not judged: there is no recorded truth in " + place.site.prefix + ".gt.csv\n";
    return;
  }
  report.text = summary_of(*report.verdict);
  report.summary["verdict"] = to_json(*report.verdict);
}

/// All queries of a place, or as many kidnappings, as far as no stop is asked for.
PlaceReport run_place(const benchmark::BenchPlace& place, const PluginRegistry& registry, const BenchOptions& options,
                      const BenchFiles& files, const std::stop_token& stop) {
  const double before_mb = allocated_mb();
  Localizer localizer(build_parts(place.deployment, registry, place.site.map));
  const double localizer_mb = allocated_mb() - before_mb;
  PlaceReport report;
  PlaceRun run = options.sequence ? run_and_judge_kidnappings(localizer, place, options, files, stop, report)
                                  : run_queries(localizer, place, stop);
  report.is_cut = run.is_cut;
  write_record(run.all, place.site, files);
  report.summary = summarize(run.all, {run.finished, place.site.import_s, localizer_mb});
  report.summary["site"] = fs::absolute(place.site.prefix).lexically_normal().string();
  if (!options.sequence && !run.is_cut) judge(place, run, report);
  report.summary["plugin_failures"] = localizer.plugin_failures();
  report.text += benchmark::skipped_text(localizer.plugin_failures()) + cost_text(report.summary);
  write_text((files.folder / "summary.json").string(), report.summary.dump(2) + '\n');
  return report;
}

/// Of several places together; nothing if none was judged.
void print_totals(const PlaceVerdict& all, std::size_t places) {
  if (places > 1 && all.queries > 0) std::cout << "all places\n" << summary_of(all);
}

/// Overlays speak of one building's ids, and of the map as it was imported.
void lay_overlays(std::vector<benchmark::BenchSite>& sites, const std::vector<std::string>& files,
                  const DamageOptions& damage) {
  if (files.empty()) return;
  if (sites.size() > 1 || damage.any())
    throw ConfigError("bench: overlays with several places or with damage, expected one place as it is");
  sites.front().map = session::with_overlays(sites.front().map, files);
}

MapJoin join_of(const BenchOptions& options) {
  MapJoin join = options.join.join;
  join.seed = options.damage.seed;
  if (join.copies > 0 && !options.joined) throw ConfigError("bench: --copies without --join");
  if (options.sequence && options.joined) throw ConfigError("bench: --kidnap with --join, expected one of them");
  return join;
}

std::vector<benchmark::BenchSite> sites_of(const BenchOptions& options, const PluginRegistry& registry,
                                           const Deployment& deployment) {
  const MapJoin join = join_of(options);
  std::vector<benchmark::BenchSite> sites =
      benchmark::load_sites(registry, options.prefixes, {options.maps, options.damage.asked()});
  std::vector<std::string> overlays = deployment.overlays;
  overlays.insert(overlays.end(), options.overlays.files.begin(), options.overlays.files.end());
  lay_overlays(sites, overlays, options.damage);
  if (options.joined) benchmark::join_sites(sites, join);
  return sites;
}

/// Of all places; each has a folder of its own if there are several.
std::vector<std::string> products_of(const std::vector<benchmark::BenchSite>& sites) {
  std::vector<std::string> names = run_products();
  for (const benchmark::BenchSite& site : sites) names.push_back(site.name + ".csv");
  return names;
}

/// One of several places.
PlaceReport run_in_own_folder(const benchmark::BenchPlace& place, const PluginRegistry& registry,
                              const BenchOptions& options, const StopSignals& signals) {
  const fs::path out = options.out;
  OutputFolder folder(out / place.site.name, "opal bench", run_products());
  const BenchFiles files{out / (place.site.name + ".csv"), folder.path()};
  PlaceReport report = run_place(place, registry, options, files, signals.token());
  if (report.is_cut)
    folder.interrupt(signals.signal());
  else
    folder.finish();
  return report;
}

/// All places one after the other until a stop is asked for. @return whether one was cut.
bool run_places(const std::vector<benchmark::BenchSite>& sites, const Deployment& deployment,
                const PluginRegistry& registry, const BenchOptions& options, const StopSignals& signals) {
  PlaceVerdict all;
  for (const benchmark::BenchSite& site : sites) {
    const PlaceReport report =
        run_in_own_folder(benchmark::read_bench_place(registry, site, deployment), registry, options, signals);
    std::cout << site.name << '\n' << report.text << std::flush;
    if (report.is_cut) return true;
    if (report.verdict) all.add(*report.verdict);
  }
  print_totals(all, sites.size());
  return false;
}

int bench(const BenchOptions& options) {
  const Deployment deployment = read_deployment(session::config_file(options.config));
  const PluginRegistry registry = session::load_plugins(deployment);
  const std::vector<benchmark::BenchSite> sites = sites_of(options, registry, deployment);
  std::vector<benchmark::BenchPlace> places;
  if (sites.size() == 1) places.push_back(benchmark::read_bench_place(registry, sites.front(), deployment));
  const StopSignals signals;
  OutputFolder folder(options.out, "opal bench", products_of(sites));
  bool is_cut = false;
  if (sites.size() == 1) {
    const BenchFiles files{folder.file("results.csv"), folder.path()};
    const PlaceReport report = run_place(places.front(), registry, options, files, signals.token());
    std::cout << report.text << std::flush;
    is_cut = report.is_cut;
  } else {
    is_cut = run_places(sites, deployment, registry, options, signals);
  }
  std::cout << "written to " << options.out << ": " << (sites.size() == 1 ? "results.csv" : "NAME.csv")
            << ", alternatives.csv and summary.json\n";
  return end_run(folder, is_cut ? signals.signal() : 0, kDone);
}

}  // namespace

void add_bench_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<BenchOptions>();
  CLI::App* verb = app.add_subcommand("bench", "recorded places from end to end: import their maps, run their queries");
  verb->add_option("PREFIX", options->prefixes,
                   "PREFIX.map.jsonld (or PREFIX.map.yaml, a grid), PREFIX.info.json, PREFIX.queries.json and "
                   "PREFIX.log.gz are read")
      ->required();
  verb->add_option("-o,--out", options->out,
                   "folder for results.csv, alternatives.csv and summary.json; for several places: NAME.csv and the "
                   "rest in NAME/")
      ->required();
  verb->add_option("--maps", options->maps,
                   "folder with other maps of these places, in the same frame: NAME.map.jsonld or NAME.map.yaml each");
  options->damage.add_to(*verb);
  options->overlays.add_to(*verb, ", beside those of the deployment; of a single place");
  verb->add_flag(
      "--join", options->joined,
      "run every query on the maps of all places side by side; results are in the frame of the place's own map");
  options->join.add_to(*verb);
  verb->add_option("--config", options->config, "deployment to run, or the name of one that ships")
      ->capture_default_str();
  verb->add_option("--kidnap", options->sequence,
                   "kidnap the robot instead: join windows with a cut that nothing tells, drawn by this seed; reads "
                   "PREFIX.gt.csv to choose and to judge, and also writes kidnappings.csv");
  verb->add_option("--kidnappings", options->sequences.count, "so many (default: as many as there are queries)")
      ->check(in_range(1, 100000));
  verb->callback([options, &exit_code] { exit_code = bench(*options); });
}

}  // namespace opal::cli
