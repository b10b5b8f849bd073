#include "distance_transform.hpp"

#include <algorithm>
#include <cmath>

namespace opal::grid_importer {
namespace {

constexpr float kFar = 1e12f;  // squared cells; sums stay finite

/// min over q of (p - q)^2 + f(q) for every p: the lower envelope of parabolas.
class Envelope {
 public:
  explicit Envelope(std::size_t longest) : vertex_(longest), from_(longest + 1), f_(longest) {}

  template <class Get, class Set>
  void run(int n, Get get, Set set) {
    for (int q = 0; q < n; ++q) f_[q] = get(q);
    int k = 0;
    vertex_[0] = 0;
    from_[0] = -kFar;
    from_[1] = kFar;
    for (int q = 1; q < n; ++q) {
      float s = meeting(q, vertex_[k]);
      while (s <= from_[k]) s = meeting(q, vertex_[--k]);
      vertex_[++k] = q;
      from_[k] = s;
      from_[k + 1] = kFar;
    }
    k = 0;
    for (int p = 0; p < n; ++p) {
      while (from_[k + 1] < static_cast<float>(p)) ++k;
      const auto d = static_cast<float>(p - vertex_[k]);
      set(p, d * d + f_[vertex_[k]]);
    }
  }

 private:
  /// Where the parabola of q begins to be lower than that of v < q.
  float meeting(int q, int v) const {
    const double right = f_[q] + static_cast<double>(q) * q, left = f_[v] + static_cast<double>(v) * v;
    return static_cast<float>((right - left) / (2.0 * (q - v)));
  }

  std::vector<int> vertex_;
  std::vector<float> from_, f_;
};

std::vector<float> distances(const OccupancyGrid& grid, bool to_occupied) {
  const int columns = grid.columns(), rows = grid.rows();
  std::vector<float> squares(grid.cells().size());
  for (std::size_t k = 0; k < squares.size(); ++k)
    squares[k] = (grid.cells()[k] == Occupancy::occupied) == to_occupied ? 0 : kFar;
  Envelope envelope(static_cast<std::size_t>(std::max(columns, rows)));
  const auto at = [&](int column, int row) -> float& { return squares[grid.index_of({column, row})]; };
  for (int column = 0; column < columns; ++column)
    envelope.run(
        rows, [&](int row) { return at(column, row); }, [&](int row, float v) { at(column, row) = v; });
  for (int row = 0; row < rows; ++row)
    envelope.run(
        columns, [&](int column) { return at(column, row); }, [&](int column, float v) { at(column, row) = v; });
  for (float& square : squares) square = std::sqrt(square);
  if (to_occupied) return squares;
  for (int row = 0; row < rows; ++row)  // outside is not occupied
    for (int column = 0; column < columns; ++column) {
      const int to_edge = std::min({column, columns - 1 - column, row, rows - 1 - row}) + 1;
      at(column, row) = std::min(at(column, row), static_cast<float>(to_edge));
    }
  return squares;
}

}  // namespace

std::vector<float> distance_to_occupied(const OccupancyGrid& grid) { return distances(grid, true); }
std::vector<float> distance_to_unoccupied(const OccupancyGrid& grid) { return distances(grid, false); }

}  // namespace opal::grid_importer
