#pragma once

#include "region.hpp"

#include <vector>

namespace opal::ifc_importer {

/// What one thing puts into the plan. Things are given in order of precedence: where two share a face, the first has
/// it.
struct PlanSolid {
  std::vector<Loop> loops;
  int object = 0;  ///< number of the map's object: faces of one object that lie in line are one face
};

/// A straight piece of visible surface; free space on the left of begin -> end.
struct PlanFace {
  int owner = 0;           ///< number of the solid
  int begin = 0, end = 0;  ///< numbers of nodes; faces that meet share one
  bool is_round = false;   ///< a facet of a circle
};

/// A visible circle or arc.
struct PlanCircle {
  int owner = 0;
  Circle circle;
  double visible_share = 1;
};

/// The united solids, as they are seen from free space: hidden joins are gone, gaps below a centimetre are closed.
struct Plan {
  std::vector<Point> nodes;
  std::vector<std::vector<PlanFace>> chains;  ///< closed: each face begins where the one before ends
  std::vector<PlanCircle> circles;
  int closed_voids = 0;  ///< hollow spaces in which no sensor fits, left out
};

Plan unite(const std::vector<PlanSolid>& solids);

}  // namespace opal::ifc_importer
