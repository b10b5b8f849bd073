#pragma once

#include <opal/trajectory.hpp>

#include <optional>
#include <vector>

namespace opal {

/// The recorded truth of one time line.
class TruthTrack {
 public:
  TruthTrack() = default;
  /// @param poses  T_map_base, by increasing stamp
  explicit TruthTrack(std::vector<StampedPose> poses) : poses_(std::move(poses)) {}

  /// Interpolated between neighbouring poses; nullopt outside the recorded time.
  std::optional<Pose2> at(double stamp_s) const;

 private:
  std::vector<StampedPose> poses_;
};

}  // namespace opal
