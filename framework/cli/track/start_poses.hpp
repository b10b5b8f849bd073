#pragma once

#include "cli/track/track_run.hpp"

#include <opal/common/geometry.hpp>

#include <cstdint>
#include <random>
#include <string>

namespace opal::cli {

/// "X,Y,THETA" as a pose [m, m, rad]. @throws opal::ConfigError naming what was found and what was expected.
Pose2 read_pose(const std::string& text);

/// How far start poses that come from the truth are moved, to see what a tracker makes of poor ones.
struct Disturbance {
  double position_m = 0;  ///< x and y each by up to this much
  double heading_rad = 0;
};
/// "METRES,RADIANS". @throws opal::ConfigError naming what was found and what was expected.
Disturbance read_disturbance(const std::string& text);

/// Start poses from recorded truth: every window's first scan for which there is some.
class StartPoses {
 public:
  StartPoses(const GroundTruth& truth, const Pose2& T_base_laser, const Disturbance& disturbance, std::uint64_t seed)
      : truth_(truth), T_base_laser_(T_base_laser), disturbance_(disturbance), random_(seed) {}

  /// For the next window; each has a disturbance of its own.
  StartAt next();

 private:
  const GroundTruth& truth_;
  Pose2 T_base_laser_;
  Disturbance disturbance_;
  std::mt19937_64 random_;
};

}  // namespace opal::cli
