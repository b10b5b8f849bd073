#pragma once

#include "boundary.hpp"
#include "face.hpp"

#include <vector>

namespace opal::grid_importer {

/// In cells: a gap of as many as were asked for is not too long.
constexpr double kGapRounding = 1e-6;

/// A boundary cell that supports a line, and the slice of the line that it is in: a grid column if the line is
/// flatter than 45 degrees, else a grid row. A slice with any cell is covered.
struct Supporter {
  int cell = 0;
  int slice = 0;
};

/// Supporters in the order of their slices.
using Support = std::vector<Supporter>;

/// How far a line gathers its support, in cells.
struct Strip {
  double tolerance = 0;  ///< to both sides of the line
  double gap = 0;        ///< longest stretch without support
  double reach = 0;      ///< distance from the start, along the line
};

/// Boundary cells in a strip that are visible from the line's left and not yet explained in that direction, walking
/// both ways from `start`.
Support gather_support(const Boundary& boundary, const Line& line, const CellPoint& start, const Strip& strip);

/// A part of a support, and what speaks for it minus what speaks against it, in slices.
struct BestPart {
  Support support;
  double surplus = 0;
};

/// The part with the largest surplus (Kadane's maximum subarray): a covered slice counts up to 1, by how well its cells
/// lie on the line and run along it; every slice costs min_coverage, more where beams passed through. So ends that
/// hang together by single dots fall off.
BestPart best_part(const Boundary& boundary, const Line& line, const Support& support, double tolerance,
                   double min_coverage);

/// Robust least squares: cells weigh by Tukey's biweight of their distance to `line` (Beaton and Tukey 1974), so that
/// the fit settles on one of two surfaces that are both within the tolerance; cells of one slice share their weight.
LineFit fit_to(const Boundary& boundary, const Support& support, const Line& line, double tolerance);

/// The piece of the fitted line from the first to the last supporter.
Face face_of(const Boundary& boundary, const Support& support, const LineFit& fit, const CellPoint& towards,
             double tolerance);

/// From the first to the last supporter, in cells along the line.
double extent_of(const Boundary& boundary, const Support& support, const Line& line);

/// Marks the cells that a face accounts for: those near it, for directions that see about the same side.
/// @param tolerance  of the line, in cells.
void explain(Boundary& boundary, const Face& face, const Support& support, double tolerance);

}  // namespace opal::grid_importer
