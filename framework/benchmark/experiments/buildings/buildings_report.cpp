#include "benchmark/experiments/buildings/buildings_report.hpp"

#include "benchmark/experiments/kit/order_statistics.hpp"
#include "benchmark/experiments/kit/summary_json.hpp"
#include "report/quantity_text.hpp"

namespace opal::experiments {
namespace {

using nlohmann::ordered_json;

std::string in_percent(const BuildingShare& share) {
  return within_text(100 * share.share, 100 * share.within.low, 100 * share.within.high, 1);
}

std::string with_interval(const BuildingMedian& found) {
  return within_text(found.median, found.within.low, found.within.high, 1);
}

ordered_json metres_or_null(const std::optional<double>& value) {
  return value ? ordered_json(*value) : ordered_json(nullptr);
}

ordered_json to_json(const BuildingShare& share) {
  return {{"share", share.share}, {"low", share.within.low}, {"high", share.within.high}};
}

ordered_json to_json(const BuildingMedian& found) {
  return {{"median", number_or_null(found.median)},
          {"low", number_or_null(found.within.low)},
          {"high", number_or_null(found.within.high)}};
}

ordered_json to_json(const BuildingGroup& group) {
  ordered_json json = {{"contender", group.contender}, {"group", group.name()}};
  if (!group.kind.empty()) json["kind"] = group.kind;
  if (group.difficulty) json["difficulty"] = *group.difficulty;
  json.update(ordered_json{{"buildings", group.buildings},
                           {"runs", group.runs},
                           {"success", to_json(group.success)},
                           {"localized", to_json(group.localized)},
                           {"wrong", to_json(group.wrong)},
                           {"unknown", to_json(group.unknown)},
                           {"localized_after_m", to_json(group.localized_after_m)},
                           {"localized_after_s", to_json(group.localized_after_s)},
                           {"cpu_ms", group.cpu_ms}});
  return json;
}

ordered_json to_json(const ChallengeRun& run) {
  return {{"challenge", run.challenge},
          {"seed", run.seed},
          {"contender", run.contender},
          {"outcome", name_of(outcome_of(run))},
          {"success", run.success},
          {"right_after_m", metres_or_null(run.right_after_m)},
          {"localized_after_m", metres_or_null(run.localized_after_m)},
          {"localized_after_s", number_or_null(localized_after_s(run))},
          {"wrong_after_s", number_or_null(wrong_after_s(run))},
          {"error_m", metres_or_null(run.error_m)},
          {"truth_probability", run.truth_probability},
          {"scans", run.moments.size()},
          {"localized_scans", run.localized_rows},
          {"falsely_localized_scans", run.false_rows},
          {"hypotheses_before", run.hypotheses_before},
          {"hypotheses_after", run.hypotheses_after},
          {"cpu_ms", run.cpu_ms}};
}

ordered_json to_json(const BuildingRuns& done) {
  const auto& request = done.building.request;
  ordered_json json = {{"id", done.building.id},
                       {"kind", request.kind},
                       {"seed", request.seed},
                       {"size_m2", request.size_m2},
                       {"symmetry", request.symmetry},
                       {"clutter", done.building.clutter},
                       {"difficulty", done.building.difficulty},
                       {"cpu_s", done.cpu_s},
                       {"runs", ordered_json::array()}};
  for (const ChallengeRun& run : done.runs) json["runs"].push_back(to_json(run));
  return json;
}

}  // namespace

Table buildings_table(const BuildingsExperiment& experiment) {
  Table table{{{"", "", false},
               {"group", "", false},
               {"buildings"},
               {"runs"},
               {"success", "%"},
               {"localized, right", "%"},
               {"falsely localized", "%"},
               {"honestly unknown", "%"},
               {"driven to localized", "m"},
               {"time to localized", "s"},
               {"CPU per update", "ms"}},
              {},
              true};
  for (const BuildingGroup& group : experiment.groups)
    table.rows.push_back({group.contender, group.name(), std::to_string(group.buildings), std::to_string(group.runs),
                          in_percent(group.success), in_percent(group.localized), in_percent(group.wrong),
                          in_percent(group.unknown), with_interval(group.localized_after_m),
                          with_interval(group.localized_after_s), number(group.cpu_ms, 2)});
  return table;
}

nlohmann::ordered_json to_json(const BuildingsExperiment& experiment) {
  ordered_json json = {{"experiment", "buildings"},
                       {"command", experiment.command},
                       {"groups", ordered_json::array()},
                       {"buildings", ordered_json::array()}};
  for (const BuildingGroup& group : experiment.groups) json["groups"].push_back(to_json(group));
  for (const BuildingRuns& building : experiment.buildings) json["buildings"].push_back(to_json(building));
  return json;
}

std::string command_for(const BuildingsExperiment& experiment, const BuildingRuns& building, const ChallengeRun& run) {
  return experiment.run_command + " --building " + building.building.id + " --challenge " + run.challenge;
}

}  // namespace opal::experiments
