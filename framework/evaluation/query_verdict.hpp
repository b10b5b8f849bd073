#pragma once

#include "evaluation/ground_truth.hpp"
#include "evaluation/pose_tolerance.hpp"
#include "evaluation/results.hpp"
#include "evaluation/site.hpp"

#include <optional>
#include <span>

namespace opal {

/// When a robot that began without any idea of its pose may be called localized in truth.
struct QueryJudgeOptions {
  PoseTolerance right = kRightPose, strictly_right = kStrictlyRightPose;
  double least_kept_m = 2;  ///< of driving that it must stay right for, up to the end: no lucky last row
  double end_gap_m = 3;     ///< the last row may lie so much driving before the window's end,
  double end_gap_s = 5;     ///< or so much time
};

/// What became of one localization from scratch. Distances are driven along the truth from the window's begin [m];
/// none: never.
struct QueryVerdict {
  bool success = false;                 ///< right from some row on, and up to the end
  std::optional<double> right_after_m;  ///< until it was so
  std::optional<double> right_after_s;  ///< the same in time
  std::optional<double> error_m;        ///< of the position, mean over the rows from there on
  bool strict = false;                  ///< the same, strictly
  std::optional<double> strict_after_m;
  std::optional<double> localized_after_m;  ///< until the first row that is `localized` and right
  int rows = 0;                             ///< with truth
  int localized_rows = 0;
  int false_rows = 0;  ///< of these, the ones that are wrong

  /// It never called a wrong pose localized.
  bool honest() const { return false_rows == 0; }
};

/// @param rows  of the window, by increasing stamp. Rows without truth are not judged.
OPAL_EXPORT QueryVerdict judge_query(std::span<const ResultRow> rows, const Query& window, const GroundTruth& truth,
                                     const QueryJudgeOptions& options = {});

}  // namespace opal
