#include "massive_walls.hpp"

#include <algorithm>
#include <map>

namespace opal::geojson_importer {
namespace {

constexpr double kAtBorder_m = 0.01;

}  // namespace

MassiveWalls::MassiveWalls(const std::vector<PlanElement>& elements) {
  for (const PlanElement& element : elements) {
    if (element.type != "opal:Wall" || element.sensor.empty()) continue;
    std::map<int, Wall> polygons;
    for (const PlanLine& line : element.lines) {
      if (line.sides != PlanSides::solid || line.points.empty()) continue;
      Wall& wall = polygons[line.solid];
      for (std::size_t k = 0; k < line.points.size(); ++k) {
        wall.edges.push_back({line.points[k], line.points[(k + 1) % line.points.size()]});
        wall.box.extend(line.points[k]);
      }
    }
    for (auto& [number, wall] : polygons) {
      wall.id = element.id;
      walls_.push_back(std::move(wall));
    }
  }
}

std::string MassiveWalls::wall_at(const Point& p) const {
  const auto found = std::find_if(walls_.begin(), walls_.end(), [&](const Wall& wall) { return holds(wall, p); });
  return found == walls_.end() ? "" : found->id;
}

bool MassiveWalls::holds(const Wall& wall, const Point& p) {
  const Point margin = Point::Constant(kAtBorder_m);
  if ((p.array() < (wall.box.min() - margin).array()).any() || (p.array() > (wall.box.max() + margin).array()).any())
    return false;
  const auto is_at_border = [&](const Segment& edge) { return distance_m(edge, p) <= kAtBorder_m; };
  return std::any_of(wall.edges.begin(), wall.edges.end(), is_at_border) || is_within(wall.edges, p);
}

}  // namespace opal::geojson_importer
