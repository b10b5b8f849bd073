#include "benchmark/cells/ab_runner.hpp"

#include <opal/common/quantile.hpp>
#include "benchmark/runs/event_file.hpp"
#include "benchmark/runs/localize_run.hpp"
#include "session/session.hpp"

#include "benchmark/ab/records/program_files.hpp"
#include "common/digest/sha256.hpp"

#include "common/whole_file.hpp"
#include "deployment/class_files.hpp"
#include "evaluation/query_verdict.hpp"
#include "localization/events/run_events.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace opal::benchmark {
namespace {

namespace ab = opal::ab;

/// An arm that observes runs beside what the baseline decides by.
std::vector<std::string> folders_of(const ab::Arm& arm, const ab::Experiment& experiment) {
  std::vector<std::string> folders = arm.plugin_folders;
  if (!experiment.observes) return folders;
  for (const std::string& folder : experiment.arms[experiment.baseline].plugin_folders)
    if (std::find(folders.begin(), folders.end(), folder) == folders.end()) folders.push_back(folder);
  return folders;
}

/// What was never reached is left out.
void set_if_reached(std::map<std::string, double>& values, const std::string& name,
                    const std::optional<double>& reached_after) {
  if (reached_after) values[name] = *reached_after;
}

std::map<std::string, double> values_of(const opal::QueryVerdict& verdict, const RunRecord& record) {
  std::map<std::string, double> values{{"success", verdict.success},
                                       {"strict", verdict.strict},
                                       {"localized", verdict.localized_after_m.has_value()},
                                       {"honest", verdict.honest()},
                                       {"rows", verdict.rows},
                                       {"localized_rows", verdict.localized_rows},
                                       {"false_rows", verdict.false_rows}};
  set_if_reached(values, "distance_to_success_m", verdict.right_after_m);
  set_if_reached(values, "time_to_success_s", verdict.right_after_s);
  set_if_reached(values, "distance_to_strict_m", verdict.strict_after_m);
  set_if_reached(values, "distance_to_localized_m", verdict.localized_after_m);
  set_if_reached(values, "error_m", verdict.error_m);
  if (!record.update_cpu_ms.empty())
    values["hypotheses"] = record.hypotheses / static_cast<double>(record.update_cpu_ms.size());
  return values;
}

std::map<std::string, double> costs_of(const RunRecord& record) {
  std::vector<double> cpu_ms = record.update_cpu_ms;
  if (cpu_ms.empty()) return {};
  std::sort(cpu_ms.begin(), cpu_ms.end());
  return {{"cpu_ms", std::accumulate(cpu_ms.begin(), cpu_ms.end(), 0.0) / static_cast<double>(cpu_ms.size())},
          {"cpu_ms_p99", opal::quantile_of(cpu_ms, 0.99).value_or(0)}};
}

std::string failure_of(const std::map<std::string, int>& plugin_failures) {
  std::string failure;
  for (const auto& [type, count] : plugin_failures)
    failure += fmt::format("{}{} {} times", failure.empty() ? "failed in a plugin: " : ", ", type, count);
  return failure;
}

}  // namespace

std::vector<ArmPlugins> load_arm_plugins(const ab::Experiment& experiment) {
  std::map<std::vector<std::string>, ArmPlugins> by_folders;
  std::vector<ArmPlugins> all;
  for (const ab::Arm& arm : experiment.arms) {
    const std::vector<std::string> folders = folders_of(arm, experiment);
    ArmPlugins& plugins = by_folders[folders];
    if (!plugins.registry) {
      plugins.registry = std::make_shared<const opal::PluginRegistry>(session::load_plugins(folders));
      plugins.files = ab::plugin_files(*plugins.registry);
    }
    opal::check_parts(arm.deployment, *plugins.registry);
    all.push_back(plugins);
    for (const std::string& file : class_files(arm.deployment))
      all.back().files.push_back({{"name", file}, {"version", ""}, {"sha256", opal::sha256_of_file(file)}});
  }
  return all;
}

void LocalizingRunner::enter(const ab::Task& task) {
  if (world_ && entered_.same_world(task)) return;
  world_.reset();
  world_ = worlds_.make(experiment_.scenarios[task.scenario], task.seed);
  entered_ = task;
}

std::string LocalizingRunner::input(const ab::Task& task) const {
  constexpr std::size_t kDigits = 16;
  const opal::Query& query = world_->query(task.query);
  return opal::sha256_of(world_->digest + fmt::format(" {:.9f} {:.9f}", query.start_s, query.end_s)).substr(0, kDigits);
}

void LocalizingRunner::set_up(std::size_t arm) {
  const ab::Arm& chosen = experiment_.arms[arm];
  opal::Deployment deployment = chosen.deployment;
  if (experiment_.observes) {
    deployment = experiment_.arms[experiment_.baseline].deployment;
    observed_ = let_observe(deployment, chosen, arm == experiment_.baseline);
  }
  localizer_ = std::make_unique<opal::Localizer>(parts_of(std::move(deployment), arm));
}

/// In the world that is entered, with the plugins of an arm.
opal::LocalizerParts LocalizingRunner::parts_of(opal::Deployment deployment, std::size_t arm) const {
  deployment = with_lasers(std::move(deployment), world_->place.deployment.lasers);
  if (world_->region) deployment.stages.search.region = world_->region;
  return build_parts(deployment, *plugins_[arm].registry, world_->place.site.map);
}

void LocalizingRunner::record(const ab::Task& task, std::size_t arm, const std::string& folder) const {
  opal::make_folder(folder);
  EventFile events(folder + "/events.jsonl");
  const opal::LocalizerParts parts = parts_of(experiment_.arms[arm].deployment, arm);
  const opal::Query& query = world_->query(task.query);
  events.write(opal::run_event({world_->place.site.name, experiment_.arms[arm].name, parts.map->map().name()},
                               parts.lasers.front()));
  events.write(opal::map_event(*parts.map));
  events.write(opal::start_event(query.id));
  events.write(truth_event_of(world_->truth, query, parts.lasers.front()));
  opal::Localizer localizer(parts, &events);
  run_query(localizer, world_->place, query);
  events.finish();
}

void LocalizingRunner::run(const ab::Task& task, ab::CellResult& result) {
  const opal::Query& query = world_->query(task.query);
  RankedRun ranked(*localizer_, world_->truth, world_->place.deployment.lasers.front().T_base_laser, observed_);
  RunObserver observer;
  if (experiment_.observes) observer.updated = [&](const RunRecord& so_far) { ranked.look(so_far.last.stamp_s); };
  const RunRecord record = run_query(*localizer_, world_->place, query, observer);
  result.values = values_of(judge_query(record.rows, query, world_->truth), record);
  if (experiment_.observes) {
    result.values.merge(ranked.values());
    result.input = "/" + ranked.digest();
  }
  result.costs = costs_of(record);
  result.failure = failure_of(localizer_->plugin_failures());
}

}  // namespace opal::benchmark
