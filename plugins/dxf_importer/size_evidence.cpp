#include "size_evidence.hpp"

#include "closed_doors.hpp"

#include <opal/common/quantile.hpp>
#include <opal/map/perceivable_faces.hpp>

#include <fmt/format.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace opal::dxf_importer {
namespace {

// Leaves of doors are 0.6 to 1.3 m wide. The smallest factor between two units that are mixed up is 2.54 (cm, in).
constexpr double kNarrowLeaf_m = 0.6, kWideLeaf_m = 1.3;
constexpr double kTooNarrow_m = 0.5, kTooWide_m = 1.5;
// Arcs of handles and hinges are small: the widest leaves speak for what is too narrow. Gates are wide.
constexpr double kWidestShare = 0.9, kNarrowestShare = 0.25;
// Walls inside of a building are thinner.
constexpr double kThickWalls_m = 0.4;
constexpr double kThinnestShare = 0.1;
// A partition of boards on studs is thicker.
constexpr double kThinWalls_m = 0.07;
constexpr double kThickestShare = 0.9;
// Faces of outer walls alone are twice the perimeter of their extent; these may all be thick.
constexpr double kInnerWalls = 2.2;
constexpr double kWallLengthByThickness = 8;
constexpr double kParallelFaces = 0.02;
constexpr std::size_t kLongestFaces = 1000;

std::vector<double> leaves_of(const std::vector<PlanElement>& elements) {
  std::vector<double> leaves_m;
  for (const PlanElement& element : elements) {
    if (element.type != "opal:Door") continue;
    if (const DoorWidth door = door_width(element); door.has_swing) leaves_m.push_back(door.width_m);
  }
  std::ranges::sort(leaves_m);
  return leaves_m;
}

/// How far behind a face the other face of its wall is; infinity: there is none.
double thickness_m(const Segment& face, const std::vector<Segment>& faces, double to_m) {
  double nearest_m = std::numeric_limits<double>::infinity();
  const Point along = face.direction();
  for (const Segment& other : faces) {
    if (along.dot(other.direction()) > 0 || std::abs(cross(along, other.direction())) > kParallelFaces) continue;
    const double behind_m = -cross(along, other.midpoint() - face.begin);
    if (behind_m <= 0 || behind_m > to_m) continue;
    const double a_m = along.dot(other.begin - face.begin), b_m = along.dot(other.end - face.begin);
    const double together_m = std::min(face.length_m(), std::max(a_m, b_m)) - std::max(0.0, std::min(a_m, b_m));
    if (together_m >= kWallLengthByThickness * behind_m) nearest_m = std::min(nearest_m, behind_m);
  }
  return nearest_m;
}

/// Thickness and length of faces that have another one behind them, thinnest first.
struct WallFaces {
  std::vector<std::pair<double, double>> faces;
  double length_m = 0;
  bool has_inner = false;

  /// That a share of their length is below; 0: there is none.
  double thickness_m(double share) const {
    double so_far_m = 0;
    for (const auto& [thick_m, face_m] : faces) {
      so_far_m += face_m;
      if (so_far_m >= share * length_m) return thick_m;
    }
    return 0;
  }
};

WallFaces walls_of(const SemanticMap& map, double max_thickness_m) {
  std::vector<Segment> faces = perceivable_faces(map);
  std::ranges::stable_sort(faces, std::greater{}, &Segment::length_m);
  faces.resize(std::min(faces.size(), kLongestFaces));
  WallFaces walls;
  Eigen::AlignedBox2d box;
  for (const Segment& face : faces) {
    box.extend(face.begin).extend(face.end);
    const double thick_m = thickness_m(face, faces, max_thickness_m);
    if (!std::isfinite(thick_m)) continue;
    walls.faces.emplace_back(thick_m, face.length_m());
    walls.length_m += face.length_m();
  }
  std::ranges::sort(walls.faces);
  walls.has_inner = !box.isEmpty() && walls.length_m > kInnerWalls * 2 * box.sizes().sum();
  return walls;
}

/// Where no leaf of a door says more.
std::string doubt_about_walls(const WallFaces& walls, const LengthUnit& unit) {
  const double thinnest_m = walls.thickness_m(kThinnestShare), thickest_m = walls.thickness_m(kThickestShare);
  if (walls.has_inner && thinnest_m > kThickWalls_m)
    return fmt::format(
        "doubtful: walls are {:.2f} m thick, and hardly any is thinner than {:.2f} m, expected at most {} m inside of "
        "a building, is the unit right ({})? (--set unit=...)",
        walls.thickness_m(0.5), thinnest_m, kThickWalls_m, unit.name);
  if (thickest_m > 0 && thickest_m < kThinWalls_m)
    return fmt::format(
        "doubtful: walls are {:.2f} m thick, and hardly any is thicker than {:.2f} m, expected at least {} m for most, "
        "is the unit right ({})? (--set unit=...)",
        walls.thickness_m(0.5), thickest_m, kThinWalls_m, unit.name);
  return "";
}

}  // namespace

DoorWidth door_width(const PlanElement& door) {
  Eigen::AlignedBox2d box;
  double leaf_m = 0;
  for (const PlanLine& line : door.lines) {
    for (const Point& p : line.points) box.extend(p);
    if (const auto swing = swing_of(line.points); swing && !line.closed) leaf_m = std::max(leaf_m, swing->radius_m());
  }
  if (leaf_m > 0) return {leaf_m, true};
  return {box.isEmpty() ? 0 : box.sizes().maxCoeff(), false};
}

std::string doubt_about_size(const std::vector<PlanElement>& elements, const PlanAssembly& assembly,
                             const PlanOptions& options, const LengthUnit& unit) {
  const std::vector<double> leaves_m = leaves_of(elements);
  const bool is_odd = !leaves_m.empty() && (*quantile_of(leaves_m, kNarrowestShare) > kTooWide_m ||
                                            *quantile_of(leaves_m, kWidestShare) < kTooNarrow_m);
  if (!leaves_m.empty() && !is_odd) return "";
  const WallFaces walls = walls_of(*assembly.map, options.max_wall_thickness_m);
  if (leaves_m.empty()) return doubt_about_walls(walls, unit);
  const double leaf_m = *median_of(leaves_m);
  const std::string about_walls =
      walls.faces.empty() ? "" : fmt::format(", walls {:.2f} m thick", walls.thickness_m(0.5));
  return fmt::format(
      "doubtful: leaves of doors are {:.2f} m wide (median of {}){}, expected {} to {} m and at most {} m for most "
      "walls, is the unit right ({})?{}",
      leaf_m, leaves_m.size(), about_walls, kNarrowLeaf_m, kWideLeaf_m, kThickWalls_m, unit.name,
      length_units_that_fit(leaf_m / unit.metres, kNarrowLeaf_m, kWideLeaf_m));
}

}  // namespace opal::dxf_importer
