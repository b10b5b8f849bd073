#pragma once

#include "import_kit/plan_sides.hpp"

#include <vector>

namespace opal {

/// A straight face of the plan, seen from the left of from -> to.
struct PlanFace {
  int from = 0;  ///< numbers of nodes
  int to = 0;
  int element = 0;          ///< number of the first element that has it
  std::vector<int> others;  ///< numbers of all other elements that run here
  int next = -1;            ///< number of the face that goes on at `to`, around the same free space; -1: none does
};

/// The seen sides of all edges, joined where they are straight: pieces of one element, and drawn lines of one type of
/// any.
std::vector<PlanFace> join_faces(const PlanStrokes& strokes, const std::vector<EdgeSides>& sides,
                                 const std::vector<PlanElement>& elements, double join_m);

}  // namespace opal
