#include "local_map/local_map_odometry.hpp"

namespace opal {
Eigen::Vector3d odometry_sigma(const Pose2& T_from_to, const LocalMapOptions& options) {
  const double driven_m = T_from_to.position().norm();
  const double turned_rad = std::abs(T_from_to.heading_rad());
  const double sigma_m = std::hypot(options.odometry_sigma_m, options.odometry_sigma_per_m * driven_m);
  const double sigma_rad =
      std::hypot(options.odometry_heading_sigma_rad, options.odometry_heading_sigma_per_rad * turned_rad,
                 options.odometry_heading_sigma_per_m * driven_m);
  return {sigma_m, sigma_m, sigma_rad};
}

}  // namespace opal
