#pragma once

#include <opal/map/semantic_map.hpp>
#include "map_tools/map_raster.hpp"

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace opal {

/// The cheapest ways from one place of a floor to all others.
struct FloorWays {
  int start = -1;           ///< cell
  std::vector<float> cost;  ///< by cell [cells walked, dearer along walls]; infinite: no way
  std::vector<int> before;  ///< by cell: where its way comes from; -1: the start, or no way
};

/// Where somebody can be: the largest connected part of a grid's free cells, or all, and ways along them. Frame: that
/// of `low`.
class OPAL_EXPORT FloorGrid {
 public:
  enum class Parts {
    largest,
    all  ///< of at least 1 m2: rooms whose doors are closed, flats
  };
  /// @param low   lower left corner of the first cell [m].
  /// @param free  row by row, the lowest one first; cells at the border count as not free.
  FloorGrid(const Point& low, double cell_m, int columns, int rows, std::vector<char> free,
            Parts parts = Parts::largest);

  /// Cells of the parts that are kept; none if nothing is free.
  const std::vector<int>& cells() const { return free_; }
  double area_m2() const { return cell_m_ * cell_m_ * static_cast<double>(free_.size()); }
  double cell_m() const { return cell_m_; }
  Point center_of(int cell) const;
  /// -1: outside the grid.
  int cell_at(const Point& p) const;
  bool holds(const Point& p) const;
  /// The same cells as rectangles (corners min, max), one for each run of cells along x: for pictures.
  std::vector<std::array<Point, 2>> rectangles() const;
  /// Whether the straight way between two places stays on the floor.
  bool holds(const Point& from, const Point& to) const;
  /// The place on it next to p, no farther than 0.5 m; p itself if it is on the floor.
  std::optional<Point> nearest(const Point& p) const;

  /// What walking over a cell costs besides its length, by cell, in lengths; empty: nothing.
  using Surcharge = std::vector<float>;
  Surcharge no_surcharge() const { return Surcharge(clearance_m_.size(), 0.f); }
  /// Makes cells that are near to one of the points at least so dear.
  void raise(Surcharge& prices, std::span<const Point> points, double radius_m, float price) const;
  /// Makes them at most so dear.
  void limit(Surcharge& prices, std::span<const Point> points, double radius_m, float price) const;

  /// Makes these cells ground outside the building: no way leads there that begins inside, and one that begins there
  /// leads inside as soon as it can.
  /// @param outside  by cell of the grid, not 0: outside.
  void close_off(std::vector<char> outside) { outside_ = std::move(outside); }
  bool is_outside(const Point& p) const;

  /// The way from one place to another, along cell centres, that keeps its distance from what is not free where it can
  /// (A*, Hart, Nilsson and Raphael 1968); the ends are those given. Nullopt if one of them is not on the floor, or
  /// next to it, or no way leads there.
  std::optional<std::vector<Point>> way(const Point& from, const Point& to, const Surcharge& surcharge = {}) const;
  /// The same to everywhere (Dijkstra 1959). Nullopt if `from` is not on the floor, or next to it.
  std::optional<FloorWays> ways(const Point& from, const Surcharge& surcharge = {}) const;
  /// A way with straight lines for what they are no dearer than.
  std::vector<Point> straightened(const std::vector<Point>& way, const Surcharge& surcharge = {}) const;
  /// Centres of the cells along the way to a cell, which it ends with.
  std::vector<Point> along(const FloorWays& ways, int cell) const;

 private:
  /// Cells of the grid no more than so many columns and rows from that of a point, row by row.
  template <class Visit>
  void visit_around(const Point& p, int reach, const Visit& visit) const;
  /// Cells whose centres are that near to one of the points; some may come again.
  template <class Visit>
  void visit_near(std::span<const Point> points, double radius_m, const Visit& visit) const;
  void keep_parts(Parts parts);
  void measure_clearance();
  bool is_outside(int cell) const { return !outside_.empty() && outside_[cell]; }
  float price(int cell, const Surcharge& surcharge) const;
  double line_cost(const Point& from, const Point& to, const Surcharge& surcharge) const;
  FloorWays search(int start, int goal, const Surcharge& surcharge) const;

  Point low_;
  double cell_m_;
  int columns_, rows_;
  std::vector<float> clearance_m_;  ///< from the nearest cell that is not free; 0: not free
  std::vector<int> free_;           ///< cells of the parts that are kept
  std::vector<char> outside_;       ///< by cell; empty: none
};

/// Where somebody can be in a building, in cells of 0.1 m: from where some mapped surface is seen on its visible side,
/// and there is room. Frame: `map`.
/// @param has_room  at the centre of a cell.
OPAL_EXPORT FloorGrid seen_floor(const SemanticMap& map, const std::function<bool(const Point&)>& has_room);
/// The same from a raster of the map in cells of any size, which takes longer to make than all that follows from it.
OPAL_EXPORT FloorGrid seen_floor(const MapRaster& raster, const std::function<bool(const Point&)>& has_room,
                                 FloorGrid::Parts parts = FloorGrid::Parts::largest);
/// The raster of which `seen_floor` makes the floor of a map: cells of 0.1 m, all doors open.
OPAL_EXPORT MapRaster floor_raster(const SemanticMap& map);

}  // namespace opal
