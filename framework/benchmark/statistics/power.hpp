#pragma once

namespace opal::statistics {

/// Chance that Student's two-sided t-test of so many independent units finds a true mean of that many standard
/// deviations of one unit (noncentral t; Cohen 1988, 2.3). 0 with fewer than two units.
double t_test_power(double mean_in_sigmas, double units, double level);

/// Fewest units (2 or more) whose test has that power; infinite above a million.
double units_for_power(double mean_in_sigmas, double level, double power);

/// How much larger the variance of a mean over clusters is than if all pairs were independent (Kish 1965). Both of the
/// sum of all.
double design_effect(double variance_clustered, double variance_independent);

}  // namespace opal::statistics
