#pragma once

#include <opal/common/geometry.hpp>

#include <cmath>

namespace opal {

/// Poses about a centre, evenly spaced in x, y and heading, the centre among them.
struct PoseGrid {
  double step_m, step_rad;
  int steps, turns;  ///< from the centre to either side, along x and y, and in heading

  /// One that reaches at least this far to either side.
  static PoseGrid covering(double half_m, double half_rad, double step_m, double step_rad) {
    return {step_m, step_rad, static_cast<int>(std::ceil(half_m / step_m)),
            static_cast<int>(std::ceil(half_rad / step_rad))};
  }
};

/// Steps from the centre of a grid.
struct GridSteps {
  int turn, x, y;
};

/// Calls `visit(pose, steps)` for each pose: by heading, then by x, then by y, each from the least.
template <class Visit>
void for_each_pose(const Pose2& center, const PoseGrid& grid, Visit&& visit) {
  for (int turn = -grid.turns; turn <= grid.turns; ++turn)
    for (int i = -grid.steps; i <= grid.steps; ++i)
      for (int j = -grid.steps; j <= grid.steps; ++j)
        visit(Pose2(center.x() + i * grid.step_m, center.y() + j * grid.step_m,
                    center.heading_rad() + turn * grid.step_rad),
              GridSteps{turn, i, j});
}

}  // namespace opal
