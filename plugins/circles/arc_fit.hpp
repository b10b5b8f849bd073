#pragma once

#include <opal/sensing/lines/line_extraction.hpp>

#include <optional>

namespace opal::circles {

/// What was seen of an object that stands free: its hits, and the directions [unit] in which it ends, halfway
/// between its outermost beams and the beams that passed it.
struct Arc {
  std::span<const ScanPoint> hits;
  Point clockwise_edge;
  Point counter_clockwise_edge;
  double edge_sigma_rad = 0;
};

struct ArcFit {
  Circle circle;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< (x, y, radius) [m]
  double rms_m = 0;                                      ///< distance of the hits from the circle
  double edge_error_sigmas = 0;                          ///< the larger miss of the two edges
};

/// Fits an opaque cylinder: its surface explains the hits, its outline the edges. The outline is what makes
/// the radius of a far column, of which few hits are seen, known. Empty if the fit does not converge. Start:
/// Kasa (1976), "A circle fitting procedure and its error analysis"; then Gauss-Newton on the distances
/// (Gander, Golub and Strebel 1994, "Least-squares fitting of circles and ellipses").
std::optional<ArcFit> fit_arc(const Arc& arc, const ReadingNoise& noise);

}  // namespace opal::circles
