#include "import_kit/plan_sides.hpp"

#include <opal/import_kit/mean_thickness.hpp>

#include <algorithm>
#include <map>
#include <utility>

namespace opal {
namespace {

// Beside an edge, nearer than any wall is thick.
constexpr double kSideProbes[] = {0.1, 0.3, 0.5, 0.7, 0.9};
// At the outer side of a corner the other face is shorter by the thickness, so not all of a short face has one.
constexpr int kMinMassive = 2;

struct Side {
  bool is_massive = false;
  unsigned reasons = PlanMaterial::none;
};

Side probe(const Segment& edge, const Point& towards, const PlanMaterial& material) {
  int massive = 0;
  Side side;
  for (const double share : kSideProbes) {
    const unsigned reasons = material.at(edge.begin + share * (edge.end - edge.begin) + kProbe_m * towards);
    massive += reasons != PlanMaterial::none;
    side.reasons |= reasons;
  }
  side.is_massive = massive >= kMinMassive;
  return side;
}

EdgeSides sides_of(const Segment& edge, const PlanMaterial& material) {
  const Side left = probe(edge, edge.normal(), material), right = probe(edge, -edge.normal(), material);
  return {!left.is_massive, !right.is_massive,
          (left.is_massive ? left.reasons : 0) | (right.is_massive ? right.reasons : 0)};
}

/// Carries the known side of a face around to the short end of its wall.
class Ends {
 public:
  Ends(const PlanStrokes& strokes, const PlanOptions& options, std::vector<EdgeSides>& sides)
      : strokes_(strokes), options_(options), sides_(sides), at_node_(strokes.nodes.size()) {
    for (std::size_t k = 0; k < strokes.edges.size(); ++k) {
      if (sides[k].is_hidden()) continue;
      at_node_[static_cast<std::size_t>(strokes.edges[k].from)].push_back(static_cast<int>(k));
      at_node_[static_cast<std::size_t>(strokes.edges[k].to)].push_back(static_cast<int>(k));
    }
  }

  void run() {
    std::vector<int> waiting;
    for (std::size_t k = 0; k < sides_.size(); ++k)
      if (is_known(static_cast<int>(k))) waiting.push_back(static_cast<int>(k));
    while (!waiting.empty()) {
      const int known = waiting.back();
      waiting.pop_back();
      for (const int node : {edge(known).from, edge(known).to})
        if (const int other = neighbour(node, known); other >= 0 && take_over(known, other, node))
          waiting.push_back(other);
    }
  }

 private:
  const PlanEdge& edge(int number) const { return strokes_.edges[static_cast<std::size_t>(number)]; }
  EdgeSides& sides(int number) { return sides_[static_cast<std::size_t>(number)]; }
  bool is_known(int number) { return sides(number).left != sides(number).right; }

  /// The only other edge there.
  int neighbour(int node, int number) const {
    const std::vector<int>& edges = at_node_[static_cast<std::size_t>(node)];
    if (edges.size() != 2) return -1;
    return edges[0] == number ? edges[1] : edges[0];
  }

  bool is_for_finding(int number) const {
    return std::all_of(edge(number).lines.begin(), edge(number).lines.end(), [&](int line) {
      return strokes_.paths[static_cast<std::size_t>(line)].sides == PlanSides::to_find;
    });
  }

  bool take_over(int known, int other, int node) {
    if (!sides(other).is_two_sided() || !is_for_finding(other)) return false;
    if (strokes_.length_m(edge(other)) > options_.max_wall_thickness_m) return false;
    const bool arrives = edge(known).to == node, leaves = edge(other).from == node;
    const bool left_on_the_way = arrives == sides(known).left;  // going over the node from the known edge to the other
    sides(other) = {leaves == left_on_the_way, leaves != left_on_the_way, sides(known).reasons};
    return true;
  }

  const PlanStrokes& strokes_;
  const PlanOptions& options_;
  std::vector<EdgeSides>& sides_;
  std::vector<std::vector<int>> at_node_;
};

std::vector<Point> ring_of(const PlanStrokes& strokes, const PlanPath& path) {
  std::vector<Point> ring;
  for (const int node : path.nodes) ring.push_back(strokes.at(node));
  return ring;
}

}  // namespace

std::vector<EdgeSides> find_sides(const PlanStrokes& strokes, const PlanMaterial& material,
                                  const PlanOptions& options) {
  std::vector<EdgeSides> sides;
  for (const PlanEdge& edge : strokes.edges) sides.push_back(sides_of(strokes.segment(edge), material));
  Ends(strokes, options, sides).run();
  return sides;
}

PlanMaterial material_of(const PlanStrokes& strokes, const std::vector<PlanElement>& elements,
                         const PlanOptions& options, const std::vector<std::array<Point, 4>>& walls_between_pairs) {
  PlanMaterial material;
  std::map<std::pair<int, int>, std::vector<std::vector<Point>>> solids;  // by element and solid
  for (const PlanPath& path : strokes.paths) {
    if (!path.closed) continue;
    std::vector<Point> ring = ring_of(strokes, path);
    if (path.sides == PlanSides::solid)
      solids[{path.element, path.solid}].push_back(std::move(ring));
    else if (path.sides == PlanSides::to_find && mean_thickness_m({&ring, 1}) <= options.max_wall_thickness_m)
      material.add({std::move(ring)}, PlanMaterial::outline, path.element);
  }
  for (auto& [solid, rings] : solids) material.add(std::move(rings), PlanMaterial::outline, solid.first);
  for (std::size_t k = 0; k < elements.size(); ++k) {
    if (elements[k].sensor.empty()) continue;
    for (const Circle& circle : elements[k].circles) material.add(circle, static_cast<int>(k));
  }
  for (const auto& wall : walls_between_pairs)
    material.add({std::vector<Point>(wall.begin(), wall.end())}, PlanMaterial::pair);
  material.finish();
  return material;
}

}  // namespace opal
