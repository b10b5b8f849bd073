#include "boundary_loop.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <optional>
#include <utility>

namespace opal::dxf_importer {
namespace {

// Ends of edges are rounded; of the size of their loop.
constexpr double kMeeting = 1e-3;

double size_of(const std::vector<BoundaryEdge>& edges) {
  Eigen::AlignedBox2d box;
  for (const BoundaryEdge& edge : edges) box.extend(edge.from).extend(edge.to);
  return box.sizes().maxCoeff();
}

BoundaryEdge turned(const BoundaryEdge& edge) { return {edge.to, edge.from, -edge.bulge}; }

/// The edges from the first one on, each turned if that makes it meet the one before it.
std::optional<std::vector<BoundaryEdge>> chained(const std::vector<BoundaryEdge>& edges, bool turn_first) {
  if (edges.size() == 1 && edges.front().bulge != 0) return edges;  // a whole circle
  const double near = kMeeting * size_of(edges);
  std::vector<BoundaryEdge> chain{turn_first ? turned(edges.front()) : edges.front()};
  for (std::size_t k = 1; k < edges.size(); ++k) {
    const Point& end = chain.back().to;
    const bool meets = (edges[k].from - end).norm() <= near;
    if (!meets && (edges[k].to - end).norm() > near) return std::nullopt;
    chain.push_back(meets ? edges[k] : turned(edges[k]));
  }
  if ((chain.back().to - chain.front().from).norm() > near) return std::nullopt;
  return chain;
}

}  // namespace

void close_loops(const std::vector<std::vector<BoundaryEdge>>& edges, DxfFill& fill) {
  std::vector<std::vector<DxfVertex>> closed;
  for (std::size_t k = 0; k < fill.loops.size(); ++k) {
    std::vector<DxfVertex> loop = std::move(fill.loops[k]);
    if (k < edges.size() && !edges[k].empty()) {
      auto chain = chained(edges[k], false);
      if (!chain) chain = chained(edges[k], true);
      fill.open_loops += !chain;
      if (!chain) continue;
      for (const BoundaryEdge& edge : *chain) loop.push_back({edge.from, edge.bulge});
    }
    closed.push_back(std::move(loop));
  }
  fill.loops = std::move(closed);
}

}  // namespace opal::dxf_importer
