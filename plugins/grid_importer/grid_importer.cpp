#include "grid_importer.hpp"

#include "blur.hpp"
#include "drawn_faces.hpp"
#include "map_assembly.hpp"
#include "report.hpp"
#include "smear.hpp"

#include <opal/common/error.hpp>
#include <opal/common/file_start.hpp>
#include <opal/common/letter_case.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>

namespace opal::grid_importer {
namespace {

/// "maps/acapulco.map.yaml" is called "acapulco".
std::string name_of(const std::string& path) {
  const std::string file = std::filesystem::path(path).filename().string();
  const std::string name = file.substr(0, file.find('.'));
  return name.empty() ? file : name;
}

bool names_an_image(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  for (int k = 0; k < 100 && std::getline(file, line); ++k) {
    if (k == 0) erase_byte_order_mark(line);
    if (line.starts_with("image:") || line.starts_with("\"image\":")) return true;
  }
  return false;
}

/// With upper and lower case the same.
bool ends_with_any_case(const std::string& path, std::string_view ending) {
  return lower_case_letters(path).ends_with(ending);
}

/// No face is known better than the cells that it runs through.
constexpr double kToleranceCells = 1.2;

}  // namespace

VectorizerLimits GridImporter::limits_for(const OccupancyGrid& grid) const {
  VectorizerLimits limits = limits_;
  limits.line_tolerance_m = std::max(limits.line_tolerance_m, kToleranceCells * grid.resolution_m());
  return limits;
}

bool GridImporter::recognizes(const std::string& path) const {
  return (ends_with_any_case(path, ".yaml") || ends_with_any_case(path, ".yml")) && names_an_image(path);
}

MapImport GridImporter::import(const std::string& path) const {
  GridDescription description;
  OccupancyGrid grid = read_grid(path, description);
  if (limits_.thicken_m > 0) grid = smeared(grid, limits_.thicken_m);
  grid = sharpened(grid);
  const double smear_m = estimate_smear_m(grid);
  std::optional<Boundary> boundary(std::in_place, grid);
  const GridKind kind = kind_of(*boundary);
  if (smear_m > 0) {
    grid = unsmeared(grid, smear_m);
    boundary.emplace(grid);
  }
  const VectorMap vectors = vectorize(*boundary, limits_for(grid), kind);
  if (vectors.faces.empty() && vectors.columns.empty())
    throw MapError(fmt::format(
        "{}: {} cells are occupied and {} free, and no wall is between them, expected a building: mode, negate and the "
        "thresholds say what the pixels mean",
        path, std::count(grid.cells().begin(), grid.cells().end(), Occupancy::occupied),
        std::count(grid.cells().begin(), grid.cells().end(), Occupancy::free)));
  return {assemble(name_of(path), vectors, grid, smear_m), report(description, *boundary, vectors, smear_m)};
}

}  // namespace opal::grid_importer
