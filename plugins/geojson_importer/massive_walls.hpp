#pragma once

#include <opal/import_kit/plan_assembly.hpp>

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace opal::geojson_importer {

/// The massive walls of a plan that a sensor sees, to be asked what lies in them. In the `map` frame.
class MassiveWalls {
 public:
  explicit MassiveWalls(const std::vector<PlanElement>& elements);

  /// Id of the wall that holds a point, within it or at most 1 cm away; empty: none does.
  std::string wall_at(const Point& p) const;

 private:
  struct Wall {
    std::string id;
    std::vector<Segment> edges;  ///< of all its rings
    Eigen::AlignedBox2d box;
  };
  static bool holds(const Wall& wall, const Point& p);

  std::vector<Wall> walls_;  ///< one per polygon
};

}  // namespace opal::geojson_importer
