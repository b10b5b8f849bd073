#pragma once

#include <opal/import_kit/plan_assembly.hpp>

#include <string>
#include <vector>

namespace opal {

/// A stroke of a plan between two nodes, with nothing else meeting it in between.
struct PlanEdge {
  int from = 0;  ///< number of a node; from < to
  int to = 0;
  std::vector<int> lines;  ///< numbers of the lines that run here, in order of the elements; never empty
};

/// One line of an element that takes part, as the nodes that it goes through.
struct PlanPath {
  int element = 0;
  PlanSides sides = PlanSides::to_find;
  bool closed = false;
  int solid = 0;
  std::vector<int> nodes;  ///< no two equal in a row; closed: the first is not repeated
};

/// All strokes of a plan, cut where they meet. Ends nearer than join_m are one node, and nodes nearer than that to a
/// stroke are on it, so strokes that run along each other end up as the same edges.
struct PlanStrokes {
  std::vector<Point> nodes;
  std::vector<PlanPath> paths;
  std::vector<PlanEdge> edges;
  std::vector<PlanPath> unseen;  ///< lines of the elements without a sensor: they cut nothing and are not cut

  Segment segment(const PlanEdge& edge) const { return {at(edge.from), at(edge.to)}; }
  const Point& at(int node) const { return nodes[static_cast<std::size_t>(node)]; }
  double length_m(const PlanEdge& edge) const { return segment(edge).length_m(); }
};

/// @throws MapError, see assemble_plan.
PlanStrokes cut_strokes(const std::string& name, const std::vector<PlanElement>& elements, double join_m);

/// The paths cut again at the given places of their edges, which are nearer than 1e-6 m to one.
void cut_again(PlanStrokes& strokes, const std::vector<std::pair<int, Point>>& edge_and_place);

}  // namespace opal
