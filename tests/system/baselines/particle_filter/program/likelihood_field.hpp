#pragma once

#include <opal/common/geometry.hpp>
#include <opal/sensing/scan.hpp>

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <vector>

/// What a laser reading is worth at a pose (Thrun, Burgard and Fox 2005, table 6.3), with the values of
/// Hendrikx (2023), table 3.2. Beams count as in ROS 1 AMCL, which adds the cubes of their likelihoods up
/// instead of multiplying them: a product of thirty collapses.
struct LikelihoodFieldOptions {
  double z_hit = 0.95, z_rand = 0.05, sigma_hit_m = 0.2, farthest_m = 2;
  double range_max_m = 30;
  int beams = 30;
};

class LikelihoodField {
 public:
  LikelihoodField(const mrpt::maps::COccupancyGridMap2D& grid, const LikelihoodFieldOptions& options);

  /// Takes the reading that is judged from now on. @param ranges_m  by beam.
  void take(const std::vector<double>& ranges_m, const opal::LaserModel& laser);
  /// log of the weight of a particle, T_map_laser.
  double log_weight(double x, double y, double heading_rad) const;

 private:
  double likelihood_at(double x, double y) const;

  LikelihoodFieldOptions options_;
  double x_min_, y_min_, resolution_m_;
  int columns_, rows_;
  std::vector<float> likelihood_;  ///< of a beam that ends in a cell
  double far_;                     ///< of one that ends far from everything
  std::vector<opal::Point> ends_;  ///< of the reading's beams, laser frame
};
