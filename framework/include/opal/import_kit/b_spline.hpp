#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace opal {

/// A B-spline curve as drawings and building models have it, rational if it has weights (Piegl and Tiller 1997, ch. 3
/// and 4). It begins at knot `degree` and ends at knot `control_points.size()`; which of the outer knots are repeated
/// is its own matter.
struct BSpline {
  int degree = 3;                               ///< at least 1; 3: a cubic curve
  std::vector<double> knots;                    ///< not falling; degree + 1 more than control points
  std::vector<Eigen::Vector3d> control_points;  ///< in the unit of the source
  std::vector<double> weights;                  ///< positive; none: all the same
};

/// @return what is wrong with it, in words; empty if nothing is.
std::string fault_of(const BSpline& spline);

/// By de Boor's algorithm (de Boor 1972). @pre fault_of(spline) is empty.
Eigen::Vector3d point_at(const BSpline& spline, double parameter);

/// Points along the curve, both ends included, whose chords are about `tolerance` off it at most, in its own unit.
/// @pre fault_of(spline) is empty; tolerance > 0.
std::vector<Eigen::Vector3d> chord_points(const BSpline& spline, double tolerance);

}  // namespace opal
