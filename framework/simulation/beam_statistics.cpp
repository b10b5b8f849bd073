#include "simulation/beam_statistics.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace opal::simulation {

void count_beams(const RawScan& scan, const Pose2& T_map_laser, const LaserModel& laser, const RayCaster& mapped,
                 BeamStatistics& statistics) {
  constexpr double kMargin_m = 0.3;
  const double angle_min = scan.angle_min_rad.value_or(laser.angle_min_rad);
  const double increment = scan.angle_increment_rad.value_or(laser.angle_increment_rad);
  const double reach_m = std::min(laser.range_max_m, laser.no_return_m);
  for (std::size_t beam = 0; beam < scan.ranges_m.size(); ++beam) {
    const double reading = scan.ranges_m[beam];
    if (!(reading >= laser.range_min_m)) continue;  // NaN, too
    const Point direction = T_map_laser.rotate(unit_vector(angle_min + static_cast<double>(beam) * increment));
    const RayHit expected = mapped.cast(T_map_laser.position(), direction, reach_m);
    const bool came_back = reading < reach_m;
    if (expected.solid < 0)
      ++(came_back ? statistics.early : statistics.free);
    else if (!came_back)
      ++statistics.missing;
    else if (reading < expected.range_m - kMargin_m)
      ++statistics.early;
    else if (reading > expected.range_m + kMargin_m)
      ++statistics.through;
    else
      ++statistics.on_surface;
  }
}

std::string side_by_side(const std::string& name_a, const BeamStatistics& a, const std::string& name_b,
                         const BeamStatistics& b) {
  struct Row {
    const char* name;
    long BeamStatistics::*count;
  };
  constexpr Row kRows[] = {{"on the first mapped surface", &BeamStatistics::on_surface},
                           {"before it, or nothing mapped", &BeamStatistics::early},
                           {"through it", &BeamStatistics::through},
                           {"lost, though something is mapped", &BeamStatistics::missing},
                           {"free", &BeamStatistics::free}};
  std::string text = fmt::format("{:<34} {:>12} {:>12}\n", "beams [%]", name_a, name_b);
  const auto percent = [](long count, long of) {
    return of == 0 ? 0 : 100 * static_cast<double>(count) / static_cast<double>(of);
  };
  for (const Row& row : kRows)
    text += fmt::format("{:<34} {:12.1f} {:12.1f}\n", row.name, percent(a.*row.count, a.beams()),
                        percent(b.*row.count, b.beams()));
  return text + fmt::format("{:<34} {:12} {:12}\n", "beams", a.beams(), b.beams());
}

}  // namespace opal::simulation
