#include "doubts.hpp"

#include "size_evidence.hpp"

#include <opal/common/quantile.hpp>
#include <opal/import_kit/first_ids.hpp>
#include <opal/map/perceivable_faces.hpp>

#include <fmt/format.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

namespace opal::dxf_importer {
namespace {

constexpr double kLongestColumn_m = 3;
constexpr double kWidestDoor_m = 5;
// A plan of single lines that is no larger has its corridors two metres wide, not its walls.
constexpr double kSmallestDoubtful_m = 100;
// Walls are long beside their thickness. Of a drawing that is a hundred times too large, walls of 0.2 m are 20 m apart.
constexpr double kLengthByThickness = 8;
constexpr double kMaxTooLarge = 100;
constexpr double kThickestWall_m = 0.4;
// Of all faces: the longest ones speak for the plan.
constexpr std::size_t kMaxFaces = 1000;
constexpr double kParallelSine = 0.02;
constexpr double kOneSidedShare = 0.01, kPairedShare = 0.5;

double length_m(const PlanLine& line) {
  double length = 0;
  for (std::size_t k = 0; k + 1 < line.points.size(); ++k) length += (line.points[k + 1] - line.points[k]).norm();
  return length;
}

std::vector<std::string> long_columns(const std::vector<PlanElement>& elements) {
  std::vector<std::string> ids;
  for (const PlanElement& element : elements)
    if (element.type == "opal:Column" && !element.sensor.empty() &&
        std::ranges::any_of(element.lines,
                            [](const PlanLine& line) { return !line.closed && length_m(line) > kLongestColumn_m; }))
      ids.push_back(element.id);
  return ids;
}

/// Of the doors in the middle: one gate, or one line that belongs to no door, says nothing.
double usual_door_m(const std::vector<PlanElement>& elements) {
  std::vector<double> widths_m;
  for (const PlanElement& element : elements)
    if (element.type == "opal:Door") widths_m.push_back(door_width(element).width_m);
  if (widths_m.empty()) return 0;
  return upper_median_of(std::move(widths_m));
}

std::vector<Segment> longest_faces(const SemanticMap& map) {
  std::vector<Segment> faces = perceivable_faces(map);
  std::ranges::stable_sort(faces, std::greater{}, &Segment::length_m);
  faces.resize(std::min(faces.size(), kMaxFaces));
  return faces;
}

/// How far away the nearest face is that runs beside this one for many times that distance; none: infinity.
double beside_m(const Segment& face, const std::vector<Segment>& faces, double from_m, double to_m) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const Segment& other : faces) {
    const Point along = face.direction();
    if (std::abs(cross(along, other.direction())) > kParallelSine) continue;
    const double away_m = std::abs(cross(along, other.midpoint() - face.begin));
    if (away_m <= from_m || away_m > to_m) continue;
    const double a_m = along.dot(other.begin - face.begin), b_m = along.dot(other.end - face.begin);
    const double together_m = std::min(face.length_m(), std::max(a_m, b_m)) - std::max(0.0, std::min(a_m, b_m));
    if (together_m >= kLengthByThickness * away_m) nearest_m = std::min(nearest_m, away_m);
  }
  return nearest_m;
}

/// The thickness of most walls, if that is the distance between the faces of a drawing which is far too large. Then no
/// face has its other one as near as walls are thick, and most run beside another one all the same.
std::optional<double> thickness_of_giants_m(const PlanAssembly& assembly, const PlanOptions& options) {
  const PlanTally& tally = assembly.tally;
  const double one_sided_m = tally.pairs_m + tally.outlines_m;
  if (tally.two_sided_m <= 0 || one_sided_m > kOneSidedShare * tally.two_sided_m) return std::nullopt;
  const std::vector<Segment> faces = longest_faces(*assembly.map);
  Eigen::AlignedBox2d box;
  for (const Segment& face : faces) box.extend(face.begin).extend(face.end);
  if (box.isEmpty() || box.sizes().maxCoeff() < kSmallestDoubtful_m) return std::nullopt;
  std::vector<std::pair<double, double>> beside;
  double all_m = 0, paired_m = 0;
  for (const Segment& face : faces) {
    all_m += face.length_m();
    const double away_m = beside_m(face, faces, options.max_wall_thickness_m, kMaxTooLarge * kThickestWall_m);
    if (!std::isfinite(away_m)) continue;
    paired_m += face.length_m();
    beside.emplace_back(away_m, face.length_m());
  }
  if (beside.empty() || paired_m < kPairedShare * all_m) return std::nullopt;
  std::ranges::sort(beside);
  double so_far_m = 0;
  for (const auto& [away_m, face_m] : beside) {
    so_far_m += face_m;
    if (so_far_m >= paired_m / 2) return away_m;
  }
  return std::nullopt;
}

/// Whether anything in the plan has a size that people know.
bool shows_its_size(const std::vector<PlanElement>& elements, const PlanTally& tally) {
  return tally.pairs_m + tally.outlines_m > 0 || usual_door_m(elements) > 0;
}

}  // namespace

std::vector<std::string> doubts_about(const std::vector<PlanElement>& elements, const std::vector<DoorStroke>& strokes,
                                      const PlanAssembly& assembly, const PlanOptions& options, const LengthUnit& unit,
                                      bool is_unit_of_file) {
  std::vector<std::string> doubts;
  if (const std::string doubt = doubt_about_size(elements, assembly, options, unit); !doubt.empty())
    doubts.push_back(doubt);
  else if (const double width_m = usual_door_m(elements); width_m > kWidestDoor_m)
    doubts.push_back(fmt::format("doubtful: doors are {:.1f} m wide, is the unit right?", width_m));
  if (const auto thickness_m = thickness_of_giants_m(assembly, options))
    doubts.push_back(fmt::format(
        "doubtful: no wall has its other face within {} m, and most have one at {:.1f} m, is the unit right?",
        options.max_wall_thickness_m, *thickness_m));
  if (is_unit_of_file && !shows_its_size(elements, assembly.tally))
    doubts.push_back(
        fmt::format("doubtful: no door and no wall with two faces shows whether {} is the right unit; many programs "
                    "write one unasked",
                    unit.name));
  if (const auto ids = closed_doors(strokes, *assembly.map); !ids.empty())
    doubts.push_back(
        fmt::format("doubtful: doors on a wall that goes on under them, so that the wall closes them: {} ({})",
                    ids.size(), first_of(ids)));
  if (const auto ids = long_columns(elements); !ids.empty())
    doubts.push_back(fmt::format("doubtful: open lines of columns that are longer than {:.0f} m, as axes are: {} ({})",
                                 kLongestColumn_m, ids.size(), first_of(ids)));
  return doubts;
}

}  // namespace opal::dxf_importer
