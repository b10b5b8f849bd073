#include "benchmark/experiments/goals/goal_report.hpp"

#include "benchmark/experiments/kit/by_name.hpp"
#include "benchmark/experiments/kit/published.hpp"
#include "benchmark/experiments/kit/summary_json.hpp"
#include "common/phrases.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <ostream>

namespace opal::experiments {
namespace {

using Run = GoalRun;
using Runs = std::vector<const Run*>;

struct Measure {
  const char* name;
  std::function<double(const Run&)> of;
};

double reached_after_s(const Run& run) { return run.reached ? run.time_s : kNever; }

double places_after_inspection(const Run& run) {
  return run.places_after_inspection < 0 ? kNever : run.places_after_inspection;
}

/// What has a median and an interval.
const std::vector<Measure>& measures() {
  static const std::vector<Measure> all{{"total_s", reached_after_s},
                                        {"driven_m", &Run::driven_m},
                                        {"first_correct_pattern_s", &Run::right_after_s},
                                        {"localized_after_s", &Run::localized_after_s},
                                        {"localized_after_m", &Run::localized_after_m},
                                        {"wrong_pattern_starts", &Run::wrong_starts},
                                        {"places_after_inspection", places_after_inspection},
                                        {"places_after_arrival", &Run::places_at_end},
                                        {"recoveries", &Run::recoveries},
                                        {"collisions", &Run::collisions}};
  return all;
}

bool touched(const Run& run) { return run.collisions > 0; }
bool misled(const Run& run) { return run.false_scans > 0; }

double mean(const std::vector<double>& all) {
  return std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(all.size());
}

/// "L 14, C 6"
std::string patterns_of(const Runs& runs) {
  std::map<std::string, int> counts;
  for (const Run* run : runs)
    if (!run->pattern.empty()) ++counts[run->pattern];
  if (counts.empty()) return "-";
  return listed_by(counts, [](const auto& one) { return fmt::format("{} {}", one.first, one.second); });
}

std::string circles_of(const Runs& runs) {
  Runs right = runs;
  std::erase_if(right, [](const Run* run) { return run->right_after_s == kNever; });
  if (right.empty()) return "-";
  return number(median(values(right, &Run::circles)), 0) + "(" + number(median(values(right, &Run::candidates)), 0) +
         ")";
}

double published_total_s(const std::string& task) {
  const auto& columns = table_4_1_columns();
  const auto at = std::find(columns.begin(), columns.end(), task);
  return at == columns.end() ? kNever : table_4_1_total_s()[static_cast<std::size_t>(at - columns.begin())];
}

std::string about_all(std::span<const Run> runs, const std::string& contender) {
  const Runs all = those_of(runs, contender, &Run::task);
  int faster = 0, compared = 0;
  for (const std::string& task : names(runs, &Run::task)) {
    if (!std::isfinite(published_total_s(task))) continue;
    ++compared;
    faster += median(values(those_of(runs, contender, &Run::task, task), reached_after_s)) < published_total_s(task);
  }
  int steps = 0, scans = 0, wrong = 0;
  for (const Run* run : all) steps += run->collisions, scans += run->localized_scans, wrong += run->false_scans;
  return "reached " + share_text(count(all, &Run::reached), all.size()) + "; touched something in " +
         share_text(count(all, touched), all.size()) + ", " + std::to_string(steps) +
         " steps; said localized and was wrong at some time in " + share_text(count(all, misled), all.size()) + ", " +
         std::to_string(wrong) + " of " + std::to_string(scans) + " scans; median time below the published one in " +
         std::to_string(faster) + " of " + std::to_string(compared);
}

ThesisTable::Block block_of(std::span<const Run> runs, const std::string& contender,
                            const std::vector<std::string>& tasks) {
  ThesisTable::Block block{contender, {}, about_all(runs, contender)};
  const auto row = [&](const char* name, const std::function<std::string(const Runs&)>& cell) {
    block.rows.push_back({name, {}});
    for (const std::string& task : tasks)
      block.rows.back().cells.push_back(cell(those_of(runs, contender, &Run::task, task)));
  };
  const auto middle = [](const Runs& r, const auto& value) { return median(values(r, value)); };
  row("success", [](const Runs& r) { return share_of(count(r, &Run::reached), r.size()); });
  row("pattern type", patterns_of);
  row("total time", [&](const Runs& r) { return minutes(middle(r, reached_after_s)); });
  row("95 %", [](const Runs& r) {
    const Interval within = median_interval(values(r, reached_after_s));
    return minutes(within.low) + "-" + minutes(within.high);
  });
  row("wrong pattern starts", [](const Runs& r) { return number(mean(values(r, &Run::wrong_starts)), 2); });
  row("first correct pattern", [&](const Runs& r) { return minutes(middle(r, &Run::right_after_s)); });
  row("circles in local map", circles_of);
  row("places after inspection", [&](const Runs& r) { return number(middle(r, places_after_inspection), 0); });
  row("places after arrival", [&](const Runs& r) { return number(middle(r, &Run::places_at_end), 0); });
  row("recoveries", [](const Runs& r) { return number(mean(values(r, &Run::recoveries)), 2); });
  row("localized after", [&](const Runs& r) { return minutes(middle(r, &Run::localized_after_s)); });
  row("driven m", [&](const Runs& r) { return number(middle(r, &Run::driven_m), 1); });
  row("touched something", [](const Runs& r) { return share_of(count(r, touched), r.size()); });
  row("falsely localized", [](const Runs& r) { return share_of(count(r, misled), r.size()); });
  return block;
}

nlohmann::ordered_json summary_of(const Runs& runs, const std::string& task) {
  nlohmann::ordered_json summary = {{"runs", runs.size()},
                                    {"published_total_s", number_or_null(published_total_s(task))}};
  const auto share = [&](const char* name, const auto& holds) {
    summary[name] = share_json(count(runs, holds), runs.size());
  };
  share("reached", &Run::reached);
  share("touched_something", touched);
  share("falsely_localized", misled);
  for (const Measure& measure : measures()) summary[measure.name] = median_json(values(runs, measure.of));
  return summary;
}

}  // namespace

ThesisTable goal_table(std::span<const Run> runs) {
  ThesisTable table{names(runs, &Run::task), {}};
  table.blocks.push_back(with_columns(table_4_1(), table_4_1_columns(), table.columns));
  for (const std::string& contender : names(runs, &Run::contender))
    table.blocks.push_back(block_of(runs, contender, table.columns));
  return table;
}

nlohmann::ordered_json goal_summary(std::span<const Run> runs) { return summary_by(runs, &Run::task, summary_of); }

void write_runs(std::ostream& out, std::span<const Run> runs) {
  out << "contender,task,seed,reached,said_so,time_s,driven_m,off_goal_m,collisions,scans,localized_scans,"
         "false_scans,localized_after_m,"
         "localized_after_s,pattern,right_after_s,circles,candidates,wrong_starts,places_after_inspection,"
         "places_at_end,recoveries\n";
  for (const Run& r : runs)
    out << r.contender << ',' << r.task << ',' << r.seed << ',' << r.reached << ',' << r.said_so << ','
        << number(r.time_s, 1) << ',' << number(r.driven_m, 2) << ',' << number(r.off_goal_m, 2) << ',' << r.collisions
        << ',' << r.scans << ',' << r.localized_scans << ',' << r.false_scans << ',' << number(r.localized_after_m, 2)
        << ',' << number(r.localized_after_s, 1) << ',' << r.pattern << ',' << number(r.right_after_s, 1) << ','
        << r.circles << ',' << r.candidates << ',' << r.wrong_starts << ',' << r.places_after_inspection << ','
        << r.places_at_end << ',' << r.recoveries << '\n';
}

}  // namespace opal::experiments
