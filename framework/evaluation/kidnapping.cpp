#include "evaluation/kidnapping.hpp"

#include <opal/common/quantile.hpp>
#include "common/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

namespace opal {
namespace {

/// A row beside the truth.
struct RowBesideTruth {
  Status status = Status::searching;
  double error_m = 0, error_rad = 0;
  double driven_m = 0;  ///< since the first beside_truth row
};

std::vector<RowBesideTruth> beside_truth(std::span<const ResultRow> rows, const GroundTruth& truth) {
  std::vector<RowBesideTruth> beside_truth;
  std::optional<Pose2> before;
  double driven_m = 0;
  for (const ResultRow& row : rows) {
    const auto pose = truth.T_map_laser_at(row.stamp_s);
    if (!pose) continue;
    driven_m += before ? distance_m(*before, *pose) : 0;
    before = pose;
    beside_truth.push_back(
        {row.status, distance_m(*pose, row.T_map_laser), angle_between_rad(*pose, row.T_map_laser), driven_m});
  }
  return beside_truth;
}

/// Driven until the first row that is as wanted, if there is one.
template <class Wanted>
std::optional<double> driven_until(const std::vector<RowBesideTruth>& rows, Wanted&& wanted) {
  const auto found = std::find_if(rows.begin(), rows.end(), wanted);
  if (found == rows.end()) return std::nullopt;
  return found->driven_m;
}

}  // namespace

KidnappingVerdict judge_kidnapping(std::span<const ResultRow> rows, std::size_t cut, const GroundTruth& truth,
                                   const RecoveryOptions& options) {
  cut = std::min(cut, rows.size());
  const auto right = [&](const RowBesideTruth& row) { return options.right.holds(row.error_m, row.error_rad); };
  const auto falsely = [&](const RowBesideTruth& row) { return row.status == Status::localized && !right(row); };
  KidnappingVerdict verdict;
  const std::vector<RowBesideTruth> before = beside_truth(rows.subspan(0, cut), truth),
                                    after = beside_truth(rows.subspan(cut), truth);
  verdict.localized_before = !before.empty() && before.back().status == Status::localized && right(before.back());
  if (after.empty()) return verdict;
  verdict.rows = static_cast<int>(after.size());
  verdict.driven_m = after.back().driven_m;

  const auto wrong_last = std::find_if_not(after.rbegin(), after.rend(), right);
  const double right_from_m = wrong_last == after.rbegin() ? verdict.driven_m + 1
                              : wrong_last == after.rend() ? 0
                                                           : wrong_last.base()->driven_m;
  if (verdict.driven_m - right_from_m >= options.least_kept_m) verdict.right_after_m = right_from_m;
  verdict.recovered = verdict.right_after_m && *verdict.right_after_m <= options.recover_within_m;

  verdict.noticed_after_m = driven_until(after, [&](const RowBesideTruth& row) { return !falsely(row); });
  verdict.lost_after_m = driven_until(after, [](const RowBesideTruth& row) { return row.status == Status::lost; });
  verdict.localized_after_m =
      driven_until(after, [&](const RowBesideTruth& row) { return row.status == Status::localized && right(row); });
  verdict.false_rows = static_cast<int>(std::count_if(after.begin(), after.end(), falsely));
  verdict.false_rows_at_once = static_cast<int>(std::find_if_not(after.begin(), after.end(), falsely) - after.begin());
  for (std::size_t k = 1; k < after.size(); ++k)
    if (falsely(after[k - 1])) verdict.false_m += after[k].driven_m - after[k - 1].driven_m;
  return verdict;
}

void write_kidnappings(std::ostream& out, std::span<const KidnappingVerdict> verdicts) {
  out << "sequence,apart_m,driven_m,localized_before,recovered,right_after_m,noticed_after_m,lost_after_m,"
         "localized_after_m,rows,false_rows,false_rows_at_once,false_m\n";
  const auto metres = [](const std::optional<double>& driven_m) { return driven_m.value_or(-1); };  // never
  for (const KidnappingVerdict& v : verdicts) {
    const std::string numbers = fmt::format(
        ",{:.2f},{:.2f},{:d},{:d},{:.2f},{:.2f},{:.2f},{:.2f},{},{},{},{:.2f}\n", v.apart_m, v.driven_m,
        v.localized_before, v.recovered, metres(v.right_after_m), metres(v.noticed_after_m), metres(v.lost_after_m),
        metres(v.localized_after_m), v.rows, v.false_rows, v.false_rows_at_once, v.false_m);
    out << csv_field(v.id) << numbers;
  }
}

std::string summary_of(std::span<const KidnappingVerdict> verdicts, const RecoveryOptions& options) {
  std::vector<double> recovered_m, localized_m;
  int knew = 0, honest = 0, once = 0, false_rows = 0, lost = 0;
  double false_m = 0;
  for (const KidnappingVerdict& v : verdicts) {
    knew += v.localized_before;
    honest += v.honest();
    once += v.false_rows_at_once > 0;
    lost += v.lost_after_m.has_value();
    false_rows += v.false_rows;
    false_m += v.false_m;
    if (v.recovered) recovered_m.push_back(*v.right_after_m);
    if (v.localized_after_m) localized_m.push_back(*v.localized_after_m);
  }
  return fmt::format(
      "{} kidnappings, {} of them while localized\n"
      "recovered within {:.0f} m and to the end: {}, median after {:.1f} m\n"
      "localized again: {}, median after {:.1f} m\n"
      "never called a wrong pose localized after the cut: {}; said lost: {}\n"
      "called the old place localized right after the cut: {}; in all {} rows, {:.1f} m\n",
      verdicts.size(), knew, options.recover_within_m, recovered_m.size(), median_of(recovered_m).value_or(-1),
      localized_m.size(), median_of(localized_m).value_or(-1), honest, lost, once, false_rows, false_m);
}

}  // namespace opal
