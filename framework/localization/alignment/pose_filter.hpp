#pragma once

#include "localization/alignment/registration.hpp"

#include <Eigen/Core>

#include <optional>

namespace opal {

struct PoseFilterOptions {
  double memory = 0.9;  ///< share of what is known that is kept per whole piece of evidence; 0: each scan stands alone
  double jump_m = 0.2;  ///< scale of the robust weight of what is known: an alignment further from where dead reckoning
                        ///< predicts it means that dead reckoning failed, and what was known with it
};

/// The step from one update to the next.
struct DeadReckoning {
  Pose2 predicted;     ///< T_map_base after it
  Pose2 T_local_base;  ///< after it, in a frame in which it is driven
  Eigen::Matrix3d covariance =
      Eigen::Matrix3d::Zero();  ///< of the step in (x, y, heading), axes of `local` [m, m, rad]
};

/// What the scans of the last metres say together about a pose: an information filter on (x, y, heading) of `base_link`
/// in frame `map` (Thrun, Burgard and Fox 2005, 3.5) that forgets exponentially. One scan may lie on a wall that is not
/// where the map says, or slide along the only wall in view: it moves the pose no further than it knows better.
class OPAL_EXPORT PoseFilter {
 public:
  PoseFilter();

  /// @param step  since the update before; what was known about the pose is known that much less exactly.
  /// @param scan  the newest scan, aligned with the map from where the step ends.
  /// @param tempering_weight  how much of a new piece of evidence it is, in (0, 1].
  /// @return T_map_base by all of them; the scan's own, as long as nothing is known.
  Pose2 update(const DeadReckoning& step, const Alignment& scan, double tempering_weight,
               const PoseFilterOptions& options);

  /// Of the pose of the newest update, (x, y, heading) in the map frame [m, m, rad]: what scans leave open, and what
  /// the map itself is wrong by. It grows where nothing fixes the robot, as along a bare corridor.
  Eigen::Matrix3d covariance() const;

  /// Nothing is known any more but where the hypothesis was found.
  void reset() { *this = PoseFilter(); }

 private:
  Eigen::Matrix3d known_after(const DeadReckoning& step) const;

  Eigen::Matrix3d known_;              ///< information about the pose of the newest update
  std::optional<Pose2> T_local_base_;  ///< then; none before the first
};

}  // namespace opal
