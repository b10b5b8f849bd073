#include <opal/import_kit/mean_thickness.hpp>

namespace opal {

double mean_thickness_m(std::span<const std::vector<Point>> rings) {
  double twice_area = 0, perimeter = 0;
  for (std::size_t k = 0; k < rings.size(); ++k) {
    const std::vector<Point>& ring = rings[k];
    double twice_of_ring = 0;
    for (std::size_t p = 0; p < ring.size(); ++p) {
      const Point& next = ring[(p + 1) % ring.size()];
      twice_of_ring += cross(ring[p] - ring.front(), next - ring.front());
      perimeter += (next - ring[p]).norm();
    }
    twice_area += (k == 0 ? 1 : -1) * std::abs(twice_of_ring);
  }
  return perimeter > 0 ? twice_area / perimeter : 0;
}

}  // namespace opal
