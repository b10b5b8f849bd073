#include "map/semantic_map_draft.hpp"

#include <memory_resource>
#include <string_view>
#include <unordered_map>

namespace opal {
namespace {

struct PointsOf {
  std::vector<Point*> operator()(Point& p) const { return {&p}; }
  std::vector<Point*> operator()(OrientedPoint& p) const { return {&p.position}; }
  std::vector<Point*> operator()(Segment& s) const { return {&s.begin, &s.end}; }
  std::vector<Point*> operator()(Circle& c) const { return {&c.center}; }
};

struct PlacedPoint {
  Point position;
  std::size_t feature;
};

std::string text_of(const Point& point) { return nlohmann::json{point.x(), point.y()}.dump(); }

}  // namespace

std::vector<Point*> points_of(Geometry& geometry) { return std::visit(PointsOf{}, geometry); }

std::vector<Point> points_of(const Geometry& geometry) {
  Geometry copy = geometry;
  std::vector<Point> points;
  for (const Point* point : points_of(copy)) points.push_back(*point);
  return points;
}

std::vector<const char*> point_roles(const Geometry& geometry) {
  switch (kind_of(geometry)) {
    case GeometryKind::segment: return {"begin", "end"};
    case GeometryKind::circle: return {"center"};
    default: return {"point"};
  }
}

std::string text_of(double number) { return nlohmann::json(number).dump(); }

void unify_shared_points(MapDraft& draft) {
  std::pmr::monotonic_buffer_resource memory;
  std::pmr::unordered_map<std::string_view, PlacedPoint> known(&memory);
  known.reserve(2 * draft.features.size());
  for (std::size_t i = 0; i < draft.features.size(); ++i) {
    MapFeature& feature = draft.features[i];
    const std::vector<Point*> points = points_of(feature.geometry);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const auto [entry, is_new] = known.try_emplace(feature.points[k], PlacedPoint{*points[k], i});
      const PlacedPoint& first = entry->second;
      if ((first.position - *points[k]).norm() > kRounding_m)
        draft.fail(draft.feature_places[i], "point '" + feature.points[k] + "' is at " + text_of(*points[k]) +
                                                ", but feature '" + draft.features[first.feature].id + "' has it at " +
                                                text_of(first.position) + "; expected one position for one id");
      *points[k] = first.position;
    }
  }
}

}  // namespace opal
