#pragma once

#include "import_kit/plan_material.hpp"
#include "import_kit/plan_strokes.hpp"

#include <vector>

namespace opal {

/// So far beside a line is asked what lies there.
inline constexpr double kProbe_m = 0.003;

/// From where an edge is seen, going from `from` to `to`; neither: it is hidden.
struct EdgeSides {
  bool left = true;
  bool right = true;
  unsigned reasons = PlanMaterial::none;  ///< why the other side is massive

  bool is_hidden() const { return !left && !right; }
  bool is_two_sided() const { return left && right; }
};

/// Asks the material on both sides of each edge. Short edges of which it says nothing, the ends of walls, go on like
/// the face that they are joined to.
std::vector<EdgeSides> find_sides(const PlanStrokes& strokes, const PlanMaterial& material, const PlanOptions& options);

/// What outlines, round columns and pairs of lines say is massive.
PlanMaterial material_of(const PlanStrokes& strokes, const std::vector<PlanElement>& elements,
                         const PlanOptions& options, const std::vector<std::array<Point, 4>>& walls_between_pairs);

}  // namespace opal
