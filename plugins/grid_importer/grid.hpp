#pragma once

#include "grey_image.hpp"
#include "grid_description.hpp"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace opal::grid_importer {

enum class Occupancy : std::uint8_t { unknown, free, occupied };

struct Cell {
  int column = 0;
  int row = 0;
};

/// A position in a grid, in units of cells: the centre of cell (column, row) is at (column, row) exactly. Geometry
/// is done in these units, since sums over whole numbers do not depend on where in the grid a wall stands.
using CellPoint = Eigen::Vector2d;

inline CellPoint centre_of(const Cell& cell) { return {cell.column, cell.row}; }

/// The cell that a position lies in.
inline Cell cell_at(const CellPoint& p) {
  return {static_cast<int>(std::lround(p.x())), static_cast<int>(std::lround(p.y()))};
}

/// So many steps from a cell.
inline Cell moved(const Cell& from, const Cell& by, int times = 1) {
  return {from.column + times * by.column, from.row + times * by.row};
}

/// Which parts of a plane are occupied. Row 0 is the lowest; all outside is unknown.
class OccupancyGrid {
 public:
  OccupancyGrid(int columns, int rows, double resolution_m, const Pose2& T_map_grid);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  double resolution_m() const { return resolution_m_; }
  const Pose2& T_map_grid() const { return T_map_grid_; }

  bool contains(const Cell& c) const { return c.column >= 0 && c.row >= 0 && c.column < columns_ && c.row < rows_; }
  std::size_t index_of(const Cell& c) const {
    return static_cast<std::size_t>(c.row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(c.column);
  }
  Occupancy at(const Cell& c) const { return contains(c) ? cells_[index_of(c)] : Occupancy::unknown; }
  void set(const Cell& c, Occupancy occupancy) { cells_[index_of(c)] = occupancy; }
  const std::vector<Occupancy>& cells() const { return cells_; }

  Point to_map(const CellPoint& p) const { return T_map_grid_ * (resolution_m_ * (p + CellPoint(0.5, 0.5))); }
  double to_cells(double length_m) const { return length_m / resolution_m_; }

 private:
  int columns_;
  int rows_;
  double resolution_m_;
  Pose2 T_map_grid_;
  std::vector<Occupancy> cells_;
};

/// The rules of map_server: brightness, thresholds and mode make each pixel free, occupied or unknown. What `scale`
/// and `raw` leave between the thresholds is unknown here, and so is what is transparent. If nothing is free, the
/// transparent part is the paper that a plan was drawn on, and free.
OccupancyGrid classify(const GreyImage& image, const GridDescription& description);

/// The whole file. @throws MapError, also if there are more than max_bytes.
std::string read_bytes(const std::string& path, std::uint64_t max_bytes);

/// Reads the yaml file and the image that it names. @throws MapError naming the file and the place in it.
OccupancyGrid read_grid(const std::string& yaml_path, GridDescription& description);

}  // namespace opal::grid_importer
