#pragma once

#include "evaluation/ground_truth.hpp"
#include "evaluation/pose_tolerance.hpp"
#include "evaluation/results.hpp"

#include <iosfwd>
#include <optional>
#include <span>
#include <string>

namespace opal {

/// When a robot that was kidnapped may be called recovered.
struct RecoveryOptions {
  PoseTolerance right = kRightPose;
  double recover_within_m = 15;  ///< of driving after the cut
  double least_kept_m = 2;       ///< of driving that it must stay right for, up to the end
};

/// What became of one kidnapping. Distances are driven after the cut, along the truth [m]; none: never.
struct KidnappingVerdict {
  std::string id;
  double apart_m = 0;                       ///< between the places at the cut
  double driven_m = 0;                      ///< in all, after the cut
  bool localized_before = false;            ///< called itself localized, and was right, at the cut
  bool recovered = false;                   ///< is right again in time, and stays so to the end
  std::optional<double> right_after_m;      ///< until it was right for good, in time or not
  std::optional<double> noticed_after_m;    ///< until the first row that is not `localized`, or is right
  std::optional<double> lost_after_m;       ///< until the first row that is `lost`
  std::optional<double> localized_after_m;  ///< until it called itself localized again, and was right
  int rows = 0;                             ///< after the cut
  int false_rows = 0;                       ///< of them `localized` and wrong
  int false_rows_at_once = 0;               ///< of these, the ones before anything else was said
  double false_m = 0;                       ///< driven while `localized` and wrong

  /// It never called a wrong pose localized after the cut: it said that it did not know before it said anything wrong.
  bool honest() const { return false_rows == 0; }
};

/// @param rows  by increasing stamp, as the localizer gave them; stamps are those by which `truth` is looked up.
/// @param cut   the first row after the cut. Rows without truth are not judged.
OPAL_EXPORT KidnappingVerdict judge_kidnapping(std::span<const ResultRow> rows, std::size_t cut,
                                               const GroundTruth& truth, const RecoveryOptions& options = {});

/// One row per sequence: the verdict's members by name; -1: never.
OPAL_EXPORT void write_kidnappings(std::ostream& out, std::span<const KidnappingVerdict> verdicts);

/// The same in a few lines for people.
OPAL_EXPORT std::string summary_of(std::span<const KidnappingVerdict> verdicts, const RecoveryOptions& options = {});

}  // namespace opal
