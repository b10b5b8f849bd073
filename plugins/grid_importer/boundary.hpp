#pragma once

#include "grid.hpp"

#include <cstdint>
#include <vector>

namespace opal::grid_importer {

/// A set of viewing directions, as bits of 16 sectors of 22.5 degrees, counter-clockwise from +column. Sixteen, so
/// that a grid turned by 90 degrees has the same sectors.
class DirectionSet {
 public:
  static constexpr int kSectors = 16;

  static int sector_of(const CellPoint& direction);
  static CellPoint direction_of(int sector);

  bool contains(int sector) const { return bits_ >> sector & 1U; }
  bool empty() const { return bits_ == 0; }
  /// Adds a sector and `spread` neighbours on each side of it.
  void add(int sector, int spread = 0);

 private:
  std::uint16_t bits_ = 0;
};

/// Whether free space lies beside a cell, 0.1 to 0.3 m away in a direction, and nothing occupied before it.
bool is_open(const OccupancyGrid& grid, const Cell& cell, int sector);

/// An occupied cell that can be seen from free space: a candidate for being part of a surface.
struct BoundaryCell {
  Cell cell;
  DirectionSet visible;    ///< directions, away from the cell, from which a sensor in free space can see it
  DirectionSet explained;  ///< visible directions that some found feature already accounts for
  /// Unit vector along the surface if the cells around the cell lie in a line; zero if they do not.
  CellPoint axis = CellPoint::Zero();

  /// Whether it is seen from a direction that no feature accounts for.
  bool is_partly_unexplained() const;
  /// How much the cell speaks for a surface along `tangent`, 0 to 1, by the angle between that and its axis.
  double agreement(const CellPoint& tangent) const;
};

/// All boundary cells of a grid, in row order, and where they are.
class Boundary {
 public:
  explicit Boundary(const OccupancyGrid& grid);

  std::vector<BoundaryCell>& cells() { return cells_; }
  const std::vector<BoundaryCell>& cells() const { return cells_; }
  int size() const { return static_cast<int>(cells_.size()); }
  BoundaryCell& operator[](int number) { return cells_[static_cast<std::size_t>(number)]; }
  const BoundaryCell& operator[](int number) const { return cells_[static_cast<std::size_t>(number)]; }

  /// Number of the boundary cell at a place, or -1.
  int at(const Cell& c) const { return grid_.contains(c) ? numbers_[grid_.index_of(c)] : -1; }
  const OccupancyGrid& grid() const { return grid_; }

  /// Calls visit(number) for the boundary cells within a square of +-radius cells, row by row.
  template <class Visit>
  void visit_near(const Cell& centre, int radius, Visit&& visit) const {
    for (int row = centre.row - radius; row <= centre.row + radius; ++row)
      for (int column = centre.column - radius; column <= centre.column + radius; ++column)
        if (const int number = at({column, row}); number >= 0) visit(number);
  }

 private:
  CellPoint axis_at(const Cell& cell) const;

  const OccupancyGrid& grid_;
  std::vector<BoundaryCell> cells_;
  std::vector<std::int32_t> numbers_;  // per grid cell
};

}  // namespace opal::grid_importer
