#pragma once

#include <opal/common/geometry.hpp>

#include <mrpt/poses/CPosePDFGaussian.h>

/// How far odometry of an omnidirectional robot is off: the noise parameters of ROS 1 AMCL's "omni" model.
struct OmniMotionOptions {
  double rotation_by_rotation = 0.2;                                       ///< alpha4
  double rotation_by_translation = 0.2;                                    ///< alpha2
  double translation_by_translation = 0.2, translation_by_rotation = 0.2;  ///< alpha3, alpha1
  double strafe_by_translation = 0.2;                                      ///< alpha5; and by rotation alpha1
  bool variance_as_deviation = false;  ///< as AMCL's "omni" does; "omni-corrected" does not
};

/// One step with its uncertainty, frame of the laser before the step.
/// AMCL passes alpha * distance^2 + alpha * angle^2, which is a variance, to a function that takes a standard
/// deviation (ros-planning/navigation issues 20, 499, 542): a step of 0.1 m is then off by 2 mm instead of 45 mm.
/// @param step  pose of the laser after it, in the frame before it.
mrpt::poses::CPosePDFGaussian omni_motion(const opal::Pose2& step, const OmniMotionOptions& options);
