#pragma once

#include "line_fit.hpp"

namespace opal::grid_importer {

/// A straight piece of surface, visible from the left of begin -> end. In cell units.
struct Face {
  CellPoint begin = CellPoint::Zero();
  CellPoint end = CellPoint::Zero();
  double covered = 0;  ///< how much of the length has boundary cells that agree with it
  double rms = 0;      ///< root mean square distance of these cells to the face

  double length() const { return (end - begin).norm(); }
  Line line() const { return {begin, (end - begin).normalized()}; }
};

}  // namespace opal::grid_importer
