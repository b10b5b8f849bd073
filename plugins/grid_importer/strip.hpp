#pragma once

#include "boundary.hpp"
#include "face.hpp"

#include <vector>

namespace opal::grid_importer {

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

/// The part of a support with the largest surplus of covered over min_coverage x all slices (Kadane's maximum
/// subarray), where gaps that beams passed through count more: ends that hang together by single dots fall off.
struct BestPart {
  Support support;
  double surplus = 0;  ///< what speaks for it minus what speaks against it, in slices
};
BestPart best_part(const Boundary& boundary, const Line& line, const Support& support, double min_coverage);

/// Least squares in which each slice weighs the same, however many cells are smeared across it.
LineFit fit_to(const Boundary& boundary, const Support& support, const CellPoint& origin);

/// The piece of the fitted line from the first to the last supporter.
Face face_of(const Boundary& boundary, const Support& support, const LineFit& fit, const CellPoint& towards);

/// From the first to the last supporter, in cells along the line.
double extent_of(const Boundary& boundary, const Support& support, const Line& line);

/// Marks the cells that a face accounts for: those near it, for directions that see about the same side.
/// @param tolerance  of the line, in cells.
void explain(Boundary& boundary, const Face& face, const Support& support, double tolerance);

}  // namespace opal::grid_importer
