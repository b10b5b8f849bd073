#pragma once

#include "evaluation/calibration.hpp"

#include <string>

namespace opal {

/// Draws the reliability diagram: said against came true, with the intervals, all of it and from 0.9 on, and how many
/// statements there are. Both show the same. @throws Error naming the file if it cannot be written.
OPAL_EXPORT void write_reliability_svg(const Calibration& calibration, const std::string& title,
                                       const std::string& path);
OPAL_EXPORT void write_reliability_png(const Calibration& calibration, const std::string& title,
                                       const std::string& path);

}  // namespace opal
