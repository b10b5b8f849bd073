#include "evaluation/query_verdict.hpp"

#include <algorithm>

namespace opal {
namespace {

/// A row beside the truth.
struct JudgedRow {
  double stamp_s = 0;
  double driven_m = 0;  ///< since the window's begin
  double error_m = 0, error_rad = 0;
  bool localized = false;
};

std::vector<JudgedRow> judged(std::span<const ResultRow> rows, double start_m, const GroundTruth& truth) {
  std::vector<JudgedRow> judged;
  for (const ResultRow& row : rows)
    if (const auto pose = truth.T_map_laser_at(row.stamp_s))
      judged.push_back({row.stamp_s, truth.driven_m(row.stamp_s) - start_m, distance_m(*pose, row.T_map_laser),
                        angle_between_rad(*pose, row.T_map_laser), row.localized()});
  return judged;
}

/// The end of a window, and how far is driven until then.
struct WindowEnd {
  double stamp_s = 0, driven_m = 0;
};

/// First row from which on all are as wanted, if the window's end is reached and enough is driven from there on; else
/// none.
template <class Wanted>
std::span<const JudgedRow> kept(std::span<const JudgedRow> rows, const WindowEnd& end, const QueryJudgeOptions& options,
                                Wanted&& wanted) {
  if (rows.empty()) return {};
  const JudgedRow& last = rows.back();
  if (end.driven_m - last.driven_m > options.end_gap_m && end.stamp_s - last.stamp_s > options.end_gap_s) return {};
  const auto wrong = std::find_if_not(rows.rbegin(), rows.rend(), wanted);
  const auto part = rows.last(static_cast<std::size_t>(wrong - rows.rbegin()));
  if (part.empty() || end.driven_m - part.front().driven_m < options.least_kept_m) return {};
  return part;
}

double mean_error_m(std::span<const JudgedRow> rows) {
  double sum = 0;
  for (const JudgedRow& row : rows) sum += row.error_m;
  return sum / static_cast<double>(rows.size());
}

}  // namespace

QueryVerdict judge_query(std::span<const ResultRow> all, const Query& window, const GroundTruth& truth,
                         const QueryJudgeOptions& options) {
  const double start_m = truth.driven_m(window.start_s);
  const WindowEnd end{window.end_s, truth.driven_m(window.end_s) - start_m};
  const std::vector<JudgedRow> rows = judged(all, start_m, truth);
  const auto right = [&](const JudgedRow& row) { return options.right.holds(row.error_m, row.error_rad); };
  const auto strictly = [&](const JudgedRow& row) { return options.strictly_right.holds(row.error_m, row.error_rad); };
  QueryVerdict verdict;
  verdict.rows = static_cast<int>(rows.size());
  if (const auto part = kept(rows, end, options, right); !part.empty()) {
    verdict.success = true;
    verdict.right_after_m = std::max(0.0, part.front().driven_m);
    verdict.right_after_s = std::max(0.0, part.front().stamp_s - window.start_s);
    verdict.error_m = mean_error_m(part);
  }
  if (const auto part = kept(rows, end, options, strictly); !part.empty()) {
    verdict.strict = true;
    verdict.strict_after_m = std::max(0.0, part.front().driven_m);
  }
  for (const JudgedRow& row : rows) {
    if (!row.localized) continue;
    ++verdict.localized_rows;
    verdict.false_rows += !right(row);
    if (!verdict.localized_after_m && right(row)) verdict.localized_after_m = std::max(0.0, row.driven_m);
  }
  return verdict;
}

}  // namespace opal
