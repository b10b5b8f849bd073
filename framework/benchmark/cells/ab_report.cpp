#include "benchmark/cells/ab_report.hpp"

#include "benchmark/verdict/quantity_words.hpp"
#include "benchmark/verdict_page/paper.hpp"

#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>
#include "common/phrases.hpp"
#include "common/text_file.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <regex>

namespace opal::benchmark {
namespace {

namespace ab = opal::ab;
namespace st = opal::statistics;
using nlohmann::ordered_json;

constexpr bool kMeasured = true;

const std::vector<st::Metric>& known_metrics() {
  using Kind = st::Metric::Kind;
  static const std::vector<st::Metric> all{
      {"success", Kind::proportion, true, "", "is right in", 0},
      {"distance_to_success_m", Kind::distance_until, false, "m", "is right", 0},
      {"localized", Kind::proportion, true, "", "localizes in", 0},
      {"distance_to_localized_m", Kind::distance_until, false, "m", "calls itself localized", 0},
      {"honest", Kind::proportion, true, "", "never calls a wrong pose localized in", 0},
      {"cpu_ms", Kind::cost, false, "ms", "CPU", 0, kMeasured},
      {"strict", Kind::proportion, true, "", "is right within 0.5 m and 5 degrees in", 0},
      {"time_to_success_s", Kind::distance_until, false, "s", "is right", 0},
      {"distance_to_strict_m", Kind::distance_until, false, "m", "is so right", 0},
      {"error_m", Kind::cost, false, "m", "error", 0},
      {"hypotheses", Kind::cost, false, "", "hypotheses", 0},
      {"cpu_ms_p99", Kind::cost, false, "ms", "CPU in the slowest of 100 updates", 0, kMeasured},
      {"peak_mb", Kind::cost, false, "MB", "memory", 0, kMeasured},
  };
  return all;
}
constexpr std::size_t kUsual = 6;  // of these

/// Of arms that observe.
const std::vector<st::Metric>& known_rankings() {
  using Kind = st::Metric::Kind;
  static const std::vector<st::Metric> all{
      {"on_top", Kind::proportion, true, "", "mostly has the truth on top in", 0},
      {"odds", Kind::cost, true, "", "odds for the truth", 0},
      {"surprise", Kind::cost, false, "", "surprise by the truth", 0},
      {"cpu_ms", Kind::cost, false, "ms", "CPU", 0, kMeasured},
  };
  return all;
}

std::vector<st::ReportPage::Version> versions_of(const ordered_json& manifest) {
  std::vector<st::ReportPage::Version> versions{
      {"opal", manifest["opal"]["version"], manifest["opal"]["program_sha256"]},
      {"libopal.so", manifest["opal"]["version"], manifest["opal"]["library_sha256"]}};
  const auto add = [&](const st::ReportPage::Version& version) {
    const auto same = [&](const st::ReportPage::Version& v) {
      return v.name == version.name && v.file_hash == version.file_hash;
    };
    if (std::ranges::none_of(versions, same)) versions.push_back(version);
  };
  for (const ordered_json& arm : manifest["arms"])
    for (const ordered_json& plugin : arm["plugins"]) {
      add({plugin["name"], plugin["version"], plugin["sha256"]});
      if (plugin.contains("description_sha256"))
        add({plugin["name"].get<std::string>() + ", description", plugin["version"], plugin["description_sha256"]});
    }
  return versions;
}

/// Infinite ends become null.
ordered_json json_of(const st::Interval& interval) { return {interval.low, interval.high}; }

ordered_json json_of(const st::MetricResult& result) {
  return {{"metric", result.metric.name},
          {"baseline", result.effect.a},
          {"arm", result.effect.b},
          {"difference", result.effect.size},
          {"interval", json_of(result.effect.interval)},
          {"pairs", result.pairs},
          {"better", result.better},
          {"worse", result.worse},
          {"between_clusters", result.between_clusters},
          {"p", result.p},
          {"p_corrected", result.p_corrected},
          {"more_queries", result.more_queries},
          {"outcome", st::word_of(result.outcome)}};
}

ordered_json json_of(const st::Verdict& verdict) {
  ordered_json json{{"arm", verdict.arm},           {"baseline", verdict.baseline}, {"sentence", verdict.sentence},
                    {"notes", verdict.notes},       {"queries", verdict.queries},   {"clusters", verdict.clusters},
                    {"failures", verdict.failures}, {"level", verdict.level},       {"metrics", ordered_json::array()}};
  for (const st::MetricResult& result : verdict.metrics) json["metrics"].push_back(json_of(result));
  return json;
}

/// How often a plugin failed differs from cell to cell.
void print_failures(const st::ResultsTable& table, const std::string& logs) {
  static const std::regex kTimes(" [0-9]+ times");
  std::map<std::string, std::map<std::string, std::size_t>> by_arm;
  for (const st::ResultRow& row : table)
    if (!row.failure.empty()) ++by_arm[row.arm][std::regex_replace(row.failure, kTimes, "")];
  for (const auto& [arm, failures] : by_arm)
    for (const auto& [failure, count] : failures)
      std::cout << arm << ": " << opal::count_of(count, "cell") << ' ' << failure << '\n';
  if (!by_arm.empty()) std::cout << "what the failed cells said: see the logs in " << logs << '\n';
}

}  // namespace

std::vector<st::Metric> metrics_of(const ab::Experiment& experiment) {
  const auto& known = experiment.observes ? known_rankings() : known_metrics();
  if (experiment.metrics.empty())
    return {known.begin(), known.begin() + static_cast<std::ptrdiff_t>(std::min(kUsual, known.size()))};
  std::vector<st::Metric> metrics;
  const std::string names = opal::listed_by(known, &st::Metric::name);
  for (const std::string& name : experiment.metrics) {
    const auto found = std::ranges::find_if(known, [&](const st::Metric& metric) { return metric.name == name; });
    if (found == known.end())
      throw opal::ConfigError(experiment.file + ": /metrics: \"" + name + "\", expected one of " + names);
    metrics.push_back(*found);
  }
  return metrics;
}

bool is_measured(const std::string& metric) {
  const auto is_so = [&](const st::Metric& known) { return known.name == metric && known.is_measured; };
  return std::any_of(known_metrics().begin(), known_metrics().end(), is_so) ||
         std::any_of(known_rankings().begin(), known_rankings().end(), is_so);
}

st::ResultsTable table_of(const ab::MergedResults& results, const ab::CellPlan& plan) {
  st::ResultsTable table;
  results.for_each_complete_task([&](const ab::Cell& cell, const ab::CellResult& result) {
    st::ResultRow row{plan.arm(cell), plan.scenario(cell.task), plan.query(cell.task), cell.task.seed, result.values,
                      result.failure};
    row.values.insert(result.costs.begin(), result.costs.end());
    table.push_back(std::move(row));
  });
  return table;
}

int look_at(const ab::Experiment& experiment, const ab::ResultFolder& folder, const ab::MergedResults& results,
            const ab::CellPlan& plan) {
  const auto looks = static_cast<std::size_t>(experiment.looks);
  const int look = static_cast<int>(looks * results.finished() / plan.cells());
  if (results.complete() || look == 0) return look;
  const std::string file = folder.file("looks.json");
  ordered_json before = std::filesystem::exists(file) ? ordered_json(opal::read_json(file)) : ordered_json::object();
  const std::string key = std::to_string(look);
  if (before.contains(key) && before[key] != results.finished()) return 0;
  before[key] = results.finished();
  opal::write_text(file, before.dump() + '\n');
  return look;
}

void report(const ab::Experiment& experiment, const ab::CellPlan& plan, const ab::ResultFolder& folder,
            const ab::MergedResults& results, const ordered_json& manifest, int look, const ViewLinks& links) {
  st::ReportPage page;
  page.title = experiment.name;
  page.table = table_of(results, plan);
  st::ComparisonOptions options;
  options.baseline = experiment.arms[experiment.baseline].name;
  options.metrics = metrics_of(experiment);
  options.look = look;
  options.looks = experiment.looks;
  page.verdicts = compare(page.table, options);
  page.configuration = manifest.dump(1);
  page.versions = versions_of(manifest);
  page.link = links;
  page.command = "opal ab " + experiment.file;
  print_failures(page.table, folder.file("logs"));
  auto verdicts = ordered_json::array();
  for (const st::Verdict& verdict : page.verdicts) {
    std::cout << verdict.sentence << '\n';
    for (const std::string& note : verdict.notes) std::cout << "  " << note << '\n';
    verdicts.push_back(json_of(verdict));
  }
  opal::write_text(folder.file("verdict.json"), verdicts.dump(1) + '\n');
  opal::write_text(folder.file("report.html"), to_html(page));
  write_paper(page, folder.file("paper"));
}

}  // namespace opal::benchmark
