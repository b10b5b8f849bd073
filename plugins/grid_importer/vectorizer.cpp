#include "vectorizer.hpp"

#include "drawn_faces.hpp"
#include "face_growth.hpp"

namespace opal::grid_importer {

VectorMap vectorize(Boundary& boundary, const VectorizerLimits& limits, GridKind kind) {
  VectorMap map;
  map.columns = find_round_columns(boundary, limits);
  if (kind == GridKind::drawn) map.faces = find_drawn_faces(boundary, limits);
  map.drawn_faces = static_cast<int>(map.faces.size());
  const std::vector<Face> grown = grow_faces(boundary, limits, kind);
  map.faces.insert(map.faces.end(), grown.begin(), grown.end());
  map.corners = join_corners(map.faces, boundary.grid(), kind);
  return map;
}

}  // namespace opal::grid_importer
