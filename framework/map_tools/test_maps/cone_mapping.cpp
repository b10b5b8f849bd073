#include "map_tools/test_maps/cone_mapping.hpp"

#include "common/random.hpp"
#include "map_tools/test_maps/expected_number.hpp"
#include "map_tools/test_maps/grid_smoothing.hpp"

#include <opal/common/error.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace opal {
namespace {

// Evidence in log odds.
constexpr double kFreeEvidence = -0.35, kArcEvidence = 0.5, kMostEvidence = 4, kDecidedEvidence = 0.3;
// The arc of a range, from before it to behind it; what is nearer is free.
constexpr double kArcBefore_m = 0.1, kArcBehind_m = 0.15;
// A robot that stands says the same again and again.
constexpr double kNextScan_m = 0.1, kNextScan_rad = 0.1;

constexpr ExpectedNumbers kExpectedOfMapping("cone mapping");

void expect_sense(const ConeMapping& mapping) {
  const auto& expect = kExpectedOfMapping;
  expect("cone", mapping.cone_rad, 0.01, 1.6, "rad");
  expect("range noise", mapping.range_sigma_m, 0, 2, "m");
  expect("reach", mapping.reach_m, 1, 100, "m");
  expect("drift", mapping.drift_m, 0, 5, "m");
  expect("drift of the heading", mapping.drift_rad, 0, 0.5, "rad");
  expect("cell", mapping.resolution_m, 0.02, 1, "m");
  expect("blur", mapping.blur_m, 0, 2, "m");
}

/// An error that changes slowly along the way: waves of some tens of metres.
class Drift {
 public:
  Drift(Random& random, double sigma) : sigma_(sigma) {
    for (Wave& wave : waves_) wave = {random.uniform(15, 60), random.uniform(0, 2 * std::numbers::pi)};
  }
  double at(double driven_m) const {
    double sum = 0;
    for (const Wave& wave : waves_) sum += std::sin(2 * std::numbers::pi * driven_m / wave.length_m + wave.phase_rad);
    return sigma_ * std::sqrt(2.0 / kWaves) * sum;
  }

 private:
  static constexpr int kWaves = 4;
  struct Wave {
    double length_m = 1, phase_rad = 0;
  };
  std::array<Wave, kWaves> waves_;
  double sigma_;
};

/// The nearest return of each cone of a scan; infinite where nothing was hit within reach.
struct Cone {
  double bearing_rad = 0;
  double range_m = std::numeric_limits<double>::infinity();
};

std::vector<Cone> cones_of(const Scan& scan, const ConeMapping& mapping) {
  double first = std::numeric_limits<double>::infinity(), last = -first;
  const auto look = [&](double bearing) { first = std::min(first, bearing), last = std::max(last, bearing); };
  for (const ScanPoint& point : scan.points) look(point.bearing_rad);
  for (const double bearing : scan.free_bearings_rad) look(bearing);
  const int count = last > first ? std::max(1, static_cast<int>((last - first) / mapping.cone_rad)) : 0;
  std::vector<Cone> cones(static_cast<std::size_t>(count));
  for (std::size_t k = 0; k < cones.size(); ++k)
    cones[k].bearing_rad = first + (static_cast<double>(k) + 0.5) * mapping.cone_rad;
  for (const ScanPoint& point : scan.points) {
    if (point.range_m >= mapping.reach_m) continue;
    const auto k = static_cast<std::size_t>((point.bearing_rad - first) / mapping.cone_rad);
    if (k < cones.size()) cones[k].range_m = std::min(cones[k].range_m, point.range_m);
  }
  return cones;
}

/// Log odds of the cells.
class EvidenceGrid {
 public:
  EvidenceGrid(const std::vector<PlacedScan>& scans, const ConeMapping& mapping) : mapping_(mapping) {
    Eigen::AlignedBox2d driven;
    for (const PlacedScan& placed : scans) driven.extend(placed.T_map_laser.position());
    const Point border = Point::Constant(mapping.reach_m + 4 * mapping.drift_m + 1);
    grid_.resolution_m = mapping.resolution_m;
    grid_.origin = driven.min() - border;
    const Point size = (driven.sizes() + 2 * border) / mapping.resolution_m;
    kExpectedOfMapping("cells", size.x() * size.y(), 1, 1e8);
    grid_.columns = static_cast<int>(size.x()) + 1;
    grid_.rows = static_cast<int>(size.y()) + 1;
    evidence_.assign(static_cast<std::size_t>(grid_.columns) * grid_.rows, 0);
  }

  /// All cells of the cone up to the range are free, those of the arc at it occupied.
  void add(const Pose2& T_map_laser, const Cone& cone, double range_m) {
    const double free_m = std::min(range_m - kArcBefore_m, mapping_.reach_m);
    const double end_m = std::isfinite(range_m) ? range_m + kArcBehind_m : free_m;
    if (!(end_m > 0)) return;
    cells_.clear();
    const double step_m = 0.7 * mapping_.resolution_m;
    const int rays = std::max(3, static_cast<int>(mapping_.cone_rad * end_m / step_m) + 1);
    for (int ray = 0; ray < rays; ++ray) {
      const double bearing = cone.bearing_rad + mapping_.cone_rad * (ray / (rays - 1.0) - 0.5);
      const Point direction = T_map_laser.rotate(unit_vector(bearing));
      for (double range = step_m; range < end_m; range += step_m)
        touch(T_map_laser.position() + range * direction, range >= free_m);
    }
    std::sort(cells_.begin(), cells_.end());
    for (std::size_t k = 0; k < cells_.size(); ++k)
      if (k == 0 || cells_[k].index != cells_[k - 1].index) weigh(cells_[k]);
  }

  MapRaster drawn() {
    smooth_grid(evidence_, grid_.columns, grid_.rows, mapping_.blur_m / mapping_.resolution_m);
    grid_.cells.resize(evidence_.size());
    for (std::size_t k = 0; k < evidence_.size(); ++k)
      grid_.cells[k] = evidence_[k] > kDecidedEvidence    ? MapRaster::Cell::occupied
                       : evidence_[k] < -kDecidedEvidence ? MapRaster::Cell::free
                                                          : MapRaster::Cell::unknown;
    return std::move(grid_);
  }

 private:
  struct Touched {
    std::size_t index = 0;
    bool is_free = true;  ///< a cell of both is occupied: it sorts first
    auto operator<=>(const Touched&) const = default;
  };

  void touch(const Point& p, bool in_arc) {
    const Point cell = (p - grid_.origin) / grid_.resolution_m;
    if (!(cell.x() >= 0 && cell.y() >= 0 && cell.x() < grid_.columns && cell.y() < grid_.rows)) return;
    cells_.push_back(
        {static_cast<std::size_t>(cell.y()) * grid_.columns + static_cast<std::size_t>(cell.x()), !in_arc});
  }

  void weigh(const Touched& cell) {
    double& evidence = evidence_[cell.index];
    evidence = std::clamp(evidence + (cell.is_free ? kFreeEvidence : kArcEvidence), -kMostEvidence, kMostEvidence);
  }

  const ConeMapping& mapping_;
  MapRaster grid_;  ///< its cells only at the end
  std::vector<double> evidence_;
  std::vector<Touched> cells_;  ///< of one cone
};

}  // namespace

MapRaster cone_mapped(const std::vector<PlacedScan>& scans, const ConeMapping& mapping) {
  expect_sense(mapping);
  if (scans.empty()) throw ConfigError("cone mapping: no scan has a known place, expected at least one");
  Random random(mapping.seed);
  const Drift x(random, mapping.drift_m), y(random, mapping.drift_m), heading(random, mapping.drift_rad);
  EvidenceGrid grid(scans, mapping);
  const PlacedScan* last = nullptr;
  double driven_m = 0;
  for (const PlacedScan& placed : scans) {
    if (last && distance_m(last->T_map_laser, placed.T_map_laser) < kNextScan_m &&
        angle_between_rad(last->T_map_laser, placed.T_map_laser) < kNextScan_rad)
      continue;
    if (last) driven_m += distance_m(last->T_map_laser, placed.T_map_laser);
    last = &placed;
    const Point off(x.at(driven_m), y.at(driven_m));
    const Pose2 T_map_laser(placed.T_map_laser.position() + off,
                            placed.T_map_laser.heading_rad() + heading.at(driven_m));
    for (const Cone& cone : cones_of(placed.scan, mapping)) {
      grid.add(T_map_laser, cone, cone.range_m + random.normal(mapping.range_sigma_m));
    }
  }
  return grid.drawn();
}

}  // namespace opal
