#pragma once

#include "hypothesis_set.hpp"

#include <opal/localizer.hpp>

namespace opal {

/// Turns hypotheses into one answer with a status.
class StatusEstimator {
 public:
  explicit StatusEstimator(const AssociationOptions& options) : options_(options) {}

  /// @param alive  best first; @param T_local_base  newest pose in the local frame.
  PoseEstimate estimate(const std::vector<Live>& alive, const Pose2& T_local_base, double stamp_s);
  /// The newest estimate, carried on to another pose in the local frame.
  PoseEstimate at(double stamp_s, const Pose2& T_local_base) const;

  bool localized() const { return last_.status == Status::localized; }
  void reset();

 private:
  void weigh(const std::vector<Live>& alive, const Pose2& T_local_base, PoseEstimate& estimate) const;
  Status judge(const std::vector<Live>& alive, const Pose2& T_local_base, const PoseEstimate& estimate);

  AssociationOptions options_;
  PoseEstimate last_;
  Pose2 T_map_local_;
  int sure_ = 0;             ///< updates in a row with the required probability, at one place
  bool was_localized_ = false;
  double mean_scan_nat_ = 0; ///< of the best hypothesis, over the newest scans
};

}  // namespace opal
