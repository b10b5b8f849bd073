#pragma once

#include "python/values/arrays.hpp"

#include <opal/sensing/sample.hpp>

namespace opal::python {

/// A scan of numbers, cleaned, with the odometry at its stamp. @throws std::invalid_argument for other shapes.
Sample sample_of_ranges(const LaserModel& laser, const GivenRanges& ranges_m, const GivenArray& odometry,
                        double stamp_s);
extern const char* const kSampleWords;  ///< what Python's help says of it

}  // namespace opal::python
