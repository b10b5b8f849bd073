#pragma once

#include "localization/tree/hypothesis_set.hpp"

#include <opal/localization/options/localizer_options.hpp>
#include <opal/map/view/map_view.hpp>
#include <opal/sensing/sample.hpp>

#include <memory>
#include <optional>
#include <vector>

namespace opal {

/// Watches for rides in lifts: a robot that stands in a mapped lift may be carried to another storey, and odometry does
/// not show it. That is no kidnapping, for the places where it may be then are few and known. A map without lifts that
/// serve several storeys costs nothing.
class OPAL_EXPORT RideWatch {
 public:
  RideWatch(const std::shared_ptr<const MapView>& map, const RideOptions& options);

  /// Takes what odometry says with every sample, in order of time.
  /// @param best  the best hypothesis' pose at this sample, frame `map`; none without a hypothesis.
  /// @param sees_other  what the robot sees fits there no more: a door has closed, or has opened elsewhere.
  /// @return true if the robot stands in a lift, and has done so for so long, or sees such a change, that it may have
  ///         been carried. It is said once for every time that the robot stands.
  bool may_have_ridden(const Sample& sample, const std::optional<Pose2>& best, bool sees_other);

  /// Where a robot at a pose may have been carried: the same place in the cabin on every other storey that the lift
  /// serves. Empty if the pose lies in no lift. Frame: `map`.
  std::vector<Pose2> elsewhere(const Pose2& T_map_base) const;
  void reset() { anchor_.reset(); }

 private:
  struct Cabin {
    double radius_m = 0;
    std::vector<Pose2> T_map_landing;  ///< one per storey
  };
  bool is_in_lift(const Pose2& T_map_base) const { return !elsewhere(T_map_base).empty(); }

  RideOptions options_;
  std::vector<Cabin> cabins_;
  struct Anchor {
    Pose2 T_odom_base;
    double since_s = 0;
    bool is_told = false;
  };
  std::optional<Anchor> anchor_;  ///< where the robot stands
};

}  // namespace opal
