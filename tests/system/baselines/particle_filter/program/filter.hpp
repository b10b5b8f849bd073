#pragma once

#include "likelihood_field.hpp"
#include "omni_motion.hpp"

#include <mrpt/slam/CMonteCarloLocalization2D.h>

#include <memory>
#include <optional>

/// Table 3.2 of Hendrikx (2023), as far as MRPT has it.
struct FilterOptions {
  int most_particles = 50000, least_particles = 100;
  double kld_error = 0.01;
  double kld_z = 0.99;  ///< as in AMCL, where it is the quantile itself, not a probability
  double bin_m = 0.5, bin_rad = 0.17453292519943295;
  double update_m = 0.1, update_rad = 0.2;
  int resample_interval = 2;
  OmniMotionOptions motion;
  double localized_m2 = 2;  ///< variances of x and y below this: says that it is localized
};

/// A circle that the robot is known to be in.
struct Region {
  opal::Point center;
  double radius_m = 0;
};

/// MRPT's Monte Carlo localization with KLD-sampling (Fox 2003).
class ParticleFilter {
 public:
  /// Spreads the particles evenly over the free cells of a grid, or over those in the region. @throws
  /// opal::MapError if there is none.
  ParticleFilter(const mrpt::maps::COccupancyGridMap2D::Ptr& grid, const LikelihoodField& field,
                 const FilterOptions& options, const std::optional<Region>& region, std::uint32_t seed);
  ~ParticleFilter();

  /// @param step  of the laser since the update before.
  void update(const opal::Pose2& step);

  std::size_t particles() const;
  /// Whether all particles together say where they are.
  bool localized() const;
  /// T_map_laser: the mean of the heaviest cluster of particles, which are those in neighbouring bins.
  opal::Pose2 best() const;

 private:
  class Mrpt;
  FilterOptions options_;
  std::unique_ptr<Mrpt> filter_;
  int updates_ = 0;
};
