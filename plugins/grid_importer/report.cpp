#include "report.hpp"

#include <opal/common/quantile.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace opal::grid_importer {
namespace {

// Cells farther from every feature than this are explained by none: two cells of smear.
constexpr double kExplained_m = 0.15;
// Walls are thinner than this, at least their part that a LiDAR smears.
constexpr double kMaxThickness_m = 1.0;

long count(const OccupancyGrid& grid, Occupancy occupancy) { return std::ranges::count(grid.cells(), occupancy); }

std::string about_grid(const OccupancyGrid& grid) {
  const double res = grid.resolution_m();
  return fmt::format("grid of {} x {} cells of {:g} m: {} occupied, {} free ({:.0f} m2)", grid.columns(), grid.rows(),
                     res, count(grid, Occupancy::occupied), count(grid, Occupancy::free),
                     static_cast<double>(count(grid, Occupancy::free)) * res * res);
}

std::string about_faces(const std::vector<Face>& faces, double res) {
  int at_least_5_m = 0;
  int at_least_1_m = 0;
  double length_m = 0;
  for (const Face& face : faces) {
    at_least_5_m += face.length() * res >= 5;
    at_least_1_m += face.length() * res >= 1;
    length_m += face.length() * res;
  }
  return fmt::format("{} wall faces, {:.0f} m: {} of at least 5 m, {} of 1 to 5 m, {} shorter", faces.size(), length_m,
                     at_least_5_m, at_least_1_m - at_least_5_m, faces.size() - static_cast<std::size_t>(at_least_1_m));
}

std::string about_corners(const VectorMap& vectors) {
  std::size_t convex = 0;
  for (const Corner& corner : vectors.corners) {
    const CellPoint before = vectors.faces[static_cast<std::size_t>(corner.before)].line().tangent;
    convex += cross(before, vectors.faces[static_cast<std::size_t>(corner.after)].line().tangent) < 0;
  }
  return fmt::format("{} corners: {} convex, {} concave; {} round columns", vectors.corners.size(), convex,
                     vectors.corners.size() - convex, vectors.columns.size());
}

/// Distance from each boundary cell to the nearest feature, in cells, infinite beyond `reach`.
class Distances {
 public:
  Distances(const Boundary& boundary, const VectorMap& vectors, double reach)
      : boundary_(boundary),
        reach_(reach),
        distances_(static_cast<std::size_t>(boundary.size()), std::numeric_limits<double>::infinity()) {
    for (const Face& face : vectors.faces)
      visit_around(face.begin, face.end, 0, [&](const CellPoint& p) {
        return distance_m(Segment{face.begin, face.end}, p);
      });
    for (const RoundColumn& column : vectors.columns)
      visit_around(column.centre, column.centre, column.radius,
                   [&](const CellPoint& p) { return std::abs((p - column.centre).norm() - column.radius); });
  }

  const std::vector<double>& values() const { return distances_; }

 private:
  /// Lowers the distances near the way from a to b, piece by piece, so that long faces look at few cells.
  template <class Distance>
  void visit_around(const CellPoint& a, const CellPoint& b, double radius, const Distance& distance_to) {
    const int around = static_cast<int>(std::ceil(reach_ + radius)) + 1;
    const int pieces = static_cast<int>((b - a).norm() / around) + 1;
    for (int k = 0; k <= pieces; ++k) {
      const CellPoint p = a + (b - a) * k / pieces;
      const Cell centre = cell_at(p);
      boundary_.visit_near(centre, around, [&](int cell) {
        const double distance = distance_to(centre_of(boundary_[cell].cell));
        double& known = distances_[static_cast<std::size_t>(cell)];
        if (distance <= reach_) known = std::min(known, distance);
      });
    }
  }

  const Boundary& boundary_;
  double reach_;
  std::vector<double> distances_;
};

std::string about_fit(const std::vector<double>& distances, double res) {
  std::vector<double> found;
  std::ranges::copy_if(distances, std::back_inserter(found), [](double d) { return std::isfinite(d); });
  std::ranges::sort(found);
  return fmt::format("boundary cells lie {:.3f} m from the nearest feature (median; p90 {:.3f} m)",
                     quantile_of(found, 0.5).value_or(0) * res, quantile_of(found, 0.9).value_or(0) * res);
}

std::string about_left_out(const std::vector<double>& distances) {
  const long left_out = std::ranges::count_if(distances, [](double d) { return !std::isfinite(d); });
  return fmt::format("left out: {} of {} boundary cells are farther than {:.2f} m from every feature", left_out,
                     distances.size(), kExplained_m);
}

/// From the face backwards, how far cells are occupied; a single other cell does not end it.
double thickness(const OccupancyGrid& grid, const CellPoint& surface, const CellPoint& inwards) {
  const double max_depth = grid.to_cells(kMaxThickness_m);
  double last = -1;
  for (double depth = -2; depth <= max_depth && depth - last <= 2; ++depth) {
    const CellPoint p = surface + depth * inwards;
    const Cell cell = cell_at(p);
    if (grid.at(cell) == Occupancy::occupied) last = depth;
  }
  return last + 1;
}

std::string about_smear(const OccupancyGrid& grid, const std::vector<Face>& faces) {
  std::vector<double> depths;
  for (const Face& face : faces) {
    const Line line = face.line();
    for (double along = 1; along < face.length(); along += 2)
      if (const double depth = thickness(grid, line.at(along), -line.normal()); depth > 0) depths.push_back(depth);
  }
  std::ranges::sort(depths);
  const double res = grid.resolution_m();
  return fmt::format("walls are {:.2f} m of occupied cells thick behind their faces (median; p90 {:.2f} m)",
                     quantile_of(depths, 0.5).value_or(0) * res, quantile_of(depths, 0.9).value_or(0) * res);
}

}  // namespace

std::vector<std::string> report(const GridDescription& description, const Boundary& boundary, const VectorMap& vectors,
                                double smear_m) {
  const OccupancyGrid& grid = boundary.grid();
  const double res = grid.resolution_m();
  const Distances distances(boundary, vectors, kExplained_m / res);
  std::vector<std::string> sentences{about_grid(grid),
                                     about_faces(vectors.faces, res),
                                     about_corners(vectors),
                                     about_left_out(distances.values()),
                                     about_fit(distances.values(), res),
                                     about_smear(grid, vectors.faces)};
  if (smear_m > 0)
    sentences.push_back(fmt::format(
        "walls stood {:.2f} m thicker in the grid than they are: faces were moved back by half of it", smear_m));
  if (vectors.drawn_faces > 0)
    sentences.push_back(
        fmt::format("a drawn plan: {} faces run along its rows and columns as they are drawn", vectors.drawn_faces));
  if (description.free_threshold > description.occupied_threshold)
    sentences.push_back(fmt::format(
        "doubtful: free_thresh {:g} lies above occupied_thresh {:g}: cells up to occupied_thresh are free, all "
        "others occupied",
        description.free_threshold, description.occupied_threshold));
  if (description.keeps_grey_unknown)
    sentences.push_back(fmt::format(
        "free_thresh {:g} would make the cells free that map_saver wrote as unknown (grey 205, also beside an alpha "
        "channel): they stay unknown",
        description.free_threshold));
  if (!description.image_in_place_of_named.empty())
    sentences.push_back(
        fmt::format("doubtful: the image {} is not there: {} was read, which is called as the yaml file",
                    description.image, description.image_in_place_of_named));
  if (description.lacks_yaw) sentences.push_back("doubtful: the yaw of origin is no number: 0 was taken");
  for (const std::string& key : description.ignored_keys)
    sentences.push_back("ignored in the yaml file: \"" + key + "\", which map_server does not define");
  return sentences;
}

}  // namespace opal::grid_importer
