#pragma once

#include <opal/common/geometry.hpp>

#include <map>
#include <utility>
#include <vector>

namespace opal::ifc_importer {

/// Lines divided where they meet: nodes, and edges between them of which no two cross or lie on each other.
class LineMesh {
 public:
  struct Edge {
    int from = 0, to = 0;
    std::vector<int> along = {};    ///< lines that run through it in its direction
    std::vector<int> against = {};  ///< lines that run through it the other way
  };

  /// @param same_m  points nearer than this are one node; lines nearer than this to a node go through it.
  LineMesh(const std::vector<Segment>& lines, double same_m);

  const std::vector<Point>& nodes() const { return nodes_; }
  const std::vector<Edge>& edges() const { return edges_; }
  Segment segment(const Edge& edge) const {
    return {nodes_[static_cast<std::size_t>(edge.from)], nodes_[static_cast<std::size_t>(edge.to)]};
  }

 private:
  void add(std::map<std::pair<int, int>, std::size_t>& numbers, int from, int to, int line);

  std::vector<Point> nodes_;
  std::vector<Edge> edges_;
};

/// Directed edges joined to closed chains, as positions in `directed`. Where several go on, the one farthest to the
/// left does, so that parts that touch in a point stay apart. Chains that do not close are left out.
std::vector<std::vector<std::size_t>> closed_chains(const LineMesh& mesh, const std::vector<LineMesh::Edge>& directed);

}  // namespace opal::ifc_importer
