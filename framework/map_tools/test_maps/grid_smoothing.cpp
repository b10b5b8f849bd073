#include "map_tools/test_maps/grid_smoothing.hpp"

#include <cmath>
#include <cstddef>

namespace opal {
namespace {

/// Of unit sum, over three sigma to either side.
std::vector<double> gaussian(double sigma_cells) {
  const int reach = static_cast<int>(std::ceil(3 * sigma_cells));
  std::vector<double> kernel;
  for (int k = -reach; k <= reach; ++k) kernel.push_back(std::exp(-0.5 * k * k / (sigma_cells * sigma_cells)));
  double sum = 0;
  for (const double weight : kernel) sum += weight;
  for (double& weight : kernel) weight /= sum;
  return kernel;
}

struct Shape {
  int columns, rows;
};

void smooth_along(std::vector<double>& values, const Shape& shape, const std::vector<double>& kernel, int right,
                  int up) {
  const std::vector<double> before = values;
  const int reach = static_cast<int>(kernel.size() / 2);
  const auto at = [&](int column, int row) {
    const bool inside = column >= 0 && row >= 0 && column < shape.columns && row < shape.rows;
    return inside ? before[static_cast<std::size_t>(row) * shape.columns + column] : 0.0;
  };
  for (int row = 0; row < shape.rows; ++row)
    for (int column = 0; column < shape.columns; ++column) {
      double sum = 0;
      for (int k = -reach; k <= reach; ++k)
        sum += kernel[static_cast<std::size_t>(k + reach)] * at(column + k * right, row + k * up);
      values[static_cast<std::size_t>(row) * shape.columns + column] = sum;
    }
}

}  // namespace

void smooth_grid(std::vector<double>& values, int columns, int rows, double sigma_cells) {
  if (sigma_cells < 0.1) return;
  const std::vector<double> kernel = gaussian(sigma_cells);
  smooth_along(values, {columns, rows}, kernel, 1, 0);
  smooth_along(values, {columns, rows}, kernel, 0, 1);
}

}  // namespace opal
