#include "benchmark/experiments/storeys/storey_report.hpp"

#include <opal/common/quantile.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace opal::experiments {
namespace {

// A ride is judged by the first metres after it.
constexpr double kSoon_m = 10;

template <class Test>
std::string count_of(const std::vector<StoreyRun>& runs, Test test) {
  return std::to_string(std::count_if(runs.begin(), runs.end(), test));
}

bool is_soon(const std::optional<double>& from_m) { return from_m && *from_m <= kSoon_m; }

std::string median_localized(const std::vector<StoreyRun>& runs) {
  std::vector<double> all_m;
  for (const StoreyRun& run : runs)
    if (run.localized_from_m) all_m.push_back(*run.localized_from_m);
  const auto median_m = median_of(std::move(all_m));
  return median_m ? fmt::format("{:.1f}", *median_m) : "";
}

/// A wall that is not where the map has it may be an error of the map: so few say nothing.
constexpr double kAlike = 0.03;

template <class Test>
std::vector<StoreyRun> those(const std::vector<StoreyRun>& runs, Test test) {
  std::vector<StoreyRun> chosen;
  std::copy_if(runs.begin(), runs.end(), std::back_inserter(chosen), test);
  return chosen;
}

std::vector<Cell> row_of(const std::string& name, const std::vector<StoreyRun>& runs) {
  return {name,
          std::to_string(runs.size()),
          count_of(runs, [](const StoreyRun& run) { return run.is_right; }),
          count_of(runs, [](const StoreyRun& run) { return run.wrong > 0; }),
          count_of(runs, [](const StoreyRun& run) { return run.wrong_storey > 0; }),
          count_of(runs, [](const StoreyRun& run) { return is_soon(run.right_from_m); }),
          count_of(runs, [](const StoreyRun& run) { return is_soon(run.localized_from_m); }),
          median_localized(runs)};
}

std::string written(const std::optional<double>& metres) { return metres ? fmt::format("{:.2f}", *metres) : ""; }

}  // namespace

Table storey_table(const std::vector<StoreyRun>& runs) {
  Table table;
  table.columns = {{"", "", false},
                   {"drives"},
                   {"localized rightly at the end"},
                   {"with a false positive"},
                   {"... on another storey"},
                   {"best one right after 10 m"},
                   {"localized after 10 m"},
                   {"localized after, median", "m"}};
  for (const bool is_ride : {false, true}) {
    const auto these = those(runs, [&](const StoreyRun& run) { return run.is_ride == is_ride; });
    if (these.empty()) continue;
    table.rows.push_back(row_of(is_ride ? "rides" : "drives", these));
    const auto is_alike = [](const StoreyRun& run) { return run.difference < kAlike; };
    table.rows.push_back(
        row_of(fmt::format("... fewer than {:.0f} % of beams tell the storey", 100 * kAlike), those(these, is_alike)));
    table.rows.push_back(
        row_of("... more tell it", those(these, [&](const StoreyRun& run) { return !is_alike(run); })));
  }
  return table;
}

Table storey_rows(const std::vector<StoreyRun>& runs) {
  Table table;
  table.columns = {{"kind", "", false},  {"seed"},         {"from", "", false},  {"to", "", false}, {"lift", "", false},
                   {"localized_before"}, {"right_from_m"}, {"localized_from_m"}, {"right"},         {"right_storey"},
                   {"answers"},          {"wrong"},        {"wrong_storey"},     {"wrong_at_m"},    {"driven_m"},
                   {"difference"}};
  for (const StoreyRun& run : runs)
    table.rows.push_back({run.is_ride ? "ride" : "drive", std::to_string(run.seed), run.from, run.to, run.lift,
                          run.localized_before ? "1" : "0", written(run.right_from_m), written(run.localized_from_m),
                          run.is_right ? "1" : "0", run.is_storey ? "1" : "0", std::to_string(run.answers),
                          std::to_string(run.wrong), std::to_string(run.wrong_storey),
                          run.wrong > 0 ? fmt::format("{:.2f}", run.wrong_at_m) : "",
                          fmt::format("{:.1f}", run.driven_m), fmt::format("{:.3f}", run.difference)});
  return table;
}

}  // namespace opal::experiments
