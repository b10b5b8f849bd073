#include "omni_motion.hpp"

#include <cmath>

mrpt::poses::CPosePDFGaussian omni_motion(const opal::Pose2& step, const OmniMotionOptions& options) {
  const double distance_2 = step.position().squaredNorm(), angle_2 = step.heading_rad() * step.heading_rad();
  const auto variance = [&](double by_translation, double by_rotation) {
    const double meant = by_translation * distance_2 + by_rotation * angle_2;
    return options.variance_as_deviation ? meant * meant : meant;
  };
  const double along = variance(options.translation_by_translation, options.translation_by_rotation);
  const double across = variance(options.strafe_by_translation, options.translation_by_rotation);
  const double turn = variance(options.rotation_by_translation, options.rotation_by_rotation);
  const double bearing = distance_2 > 0 ? std::atan2(step.y(), step.x()) : 0, c = std::cos(bearing),
               s = std::sin(bearing);
  // A covariance that is not positive definite cannot be drawn from.
  constexpr double kLeast = 1e-8;
  mrpt::math::CMatrixDouble33 covariance;
  covariance(0, 0) = c * c * along + s * s * across + kLeast;
  covariance(1, 1) = s * s * along + c * c * across + kLeast;
  covariance(0, 1) = covariance(1, 0) = c * s * (along - across);
  covariance(2, 2) = turn + kLeast;
  return mrpt::poses::CPosePDFGaussian(mrpt::poses::CPose2D(step.x(), step.y(), step.heading_rad()), covariance);
}
