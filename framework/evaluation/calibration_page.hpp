#pragma once

#include "evaluation/calibration.hpp"

#include <span>
#include <string>

namespace opal {

/// What was said, as every statement counts and as every cluster does.
struct CalibrationChapter {
  std::string title;
  Calibration per_statement, per_cluster;
};

/// One HTML file that needs no other: reliability diagrams (said against came true, with the intervals; all of it and
/// from 0.9 on), how many statements there are, and all numbers. @param summary  lines of text at the top.
OPAL_EXPORT std::string calibration_page(const std::string& summary, std::span<const CalibrationChapter> chapters);

}  // namespace opal
