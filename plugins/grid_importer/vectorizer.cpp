#include "vectorizer.hpp"

#include "face_growth.hpp"

namespace opal::grid_importer {

VectorMap vectorize(Boundary& boundary, const VectorizerLimits& limits) {
  VectorMap map;
  map.columns = find_round_columns(boundary, limits);
  map.faces = grow_faces(boundary, limits);
  map.corners = join_corners(map.faces, boundary.grid());
  return map;
}

}  // namespace opal::grid_importer
