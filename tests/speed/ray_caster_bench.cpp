// Rays per second on one core in synthetic buildings of 2,000 and 5,000 segments, 720 beams, 30 m.
#include "common/random.hpp"
#include "common/stage_clock.hpp"
#include "simulation/ray_caster.hpp"

#include <catch2/catch.hpp>

#include <cstdio>

using namespace opal;
using namespace opal::simulation;

namespace {

/// Rooms of 5 m with doorways, in rows.
std::vector<Solid> rooms(int segments) {
  std::vector<Solid> solids;
  const int side = static_cast<int>(std::ceil(std::sqrt(segments / 4.0)));
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      const Point low(5 * i, 5 * j);
      solids.push_back({Segment{low, low + Point(2, 0)}, false});
      solids.push_back({Segment{low + Point(3, 0), low + Point(5, 0)}, false});
      solids.push_back({Segment{low, low + Point(0, 2)}, false});
      solids.push_back({Segment{low + Point(0, 3), low + Point(0, 5)}, false});
    }
  return solids;
}

}  // namespace

TEST_CASE("rays through rooms", "[!benchmark]") {
  for (const int segments : {2000, 5000}) {
    const RayCaster caster(rooms(segments));
    const Point size = caster.bounds()[1];
    Random random(1);
    double sum = 0;
    long rays = 0;
    const double start = thread_cpu_s();
    for (int scan = 0; scan < 3000; ++scan) {
      const Point eye{random.uniform(0, size.x()), random.uniform(0, size.y())};
      for (int beam = 0; beam < 720; ++beam, ++rays)
        sum += caster.cast(eye, unit_vector(beam * std::numbers::pi / 360), 30).range_m;
    }
    const double spent = thread_cpu_s() - start;
    std::printf("%d segments: %.1f million rays per second (mean range %.2f m)\n", segments, 1e-6 * rays / spent,
                sum / rays);
    CHECK(sum > 0);
  }
}
