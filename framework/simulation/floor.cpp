#include "simulation/floor.hpp"

#include <opal/error.hpp>
#include <opal/map_raster.hpp>

namespace opal::simulation {
namespace {

FloorGrid seen_floor(const SemanticMap& map, const RayCaster& solids, double radius_m) {
  RasterOptions options;
  options.resolution_m = Floor::kCell_m;
  const MapRaster raster = rasterized(map, options);
  std::vector<char> free(raster.cells.size(), 0);
  for (int cell = 0; cell < raster.columns * raster.rows; ++cell) {
    const Point center = raster.origin + Floor::kCell_m * Point(cell % raster.columns + 0.5, cell / raster.columns + 0.5);
    free[cell] = raster.cells[cell] == MapRaster::Cell::free && !solids.touches(center, radius_m);
  }
  return {raster.origin, Floor::kCell_m, raster.columns, raster.rows, std::move(free)};
}

}  // namespace

Floor::Floor(const SemanticMap& map, const RayCaster& solids, double radius_m)
    : FloorGrid(seen_floor(map, solids, radius_m)) {
  if (cells().empty())
    throw MapError(map.name() + ": has no floor for a robot of " + std::to_string(radius_m) +
                   " m radius, expected a place from which mapped walls are seen");
}

}  // namespace opal::simulation
