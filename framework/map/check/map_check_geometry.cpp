#include "map/check/map_check_geometry.hpp"

#include "map/semantic_map_draft.hpp"

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <tuple>
#include <unordered_map>

namespace opal {
namespace {

using Cell = std::pair<std::int64_t, std::int64_t>;

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    return static_cast<std::size_t>(cell.first) * 0x9E3779B97F4A7C15u ^ static_cast<std::size_t>(cell.second);
  }
};

Cell cell_of(const Point& p, double size_m) {
  return {static_cast<std::int64_t>(std::floor(p.x() / size_m)), static_cast<std::int64_t>(std::floor(p.y() / size_m))};
}

template <class Visit>
void for_neighbours(const Cell& cell, Visit visit) {
  for (std::int64_t dx = -1; dx <= 1; ++dx)
    for (std::int64_t dy = -1; dy <= 1; ++dy) visit(Cell{cell.first + dx, cell.second + dy});
}

/// Numbered points in cells of kSamePoint_m. A cell keeps only a few: beyond that, more would only repeat the news.
class NearPoints {
 public:
  /// @return number of the place, which near points share.
  int place_of(const Point& point) {
    const int near = add(point);
    places_.push_back(near < 0 ? static_cast<int>(places_.size()) : places_[near]);
    return places_.back();
  }

  /// @return number of an earlier point that is near; -1 if there is none.
  int add(const Point& point) {
    const Cell home = cell_of(point, kSamePoint_m);
    int near = -1;
    for_neighbours(home, [&](const Cell& cell) {
      const auto found = cells_.find(cell);
      if (found == cells_.end() || near >= 0) return;
      for (const int other : found->second)
        if (near < 0 && (points_[other] - point).norm() < kSamePoint_m) near = other;
    });
    Few& here = cells_[home];
    if (here.size() < here.capacity()) here.push_back(static_cast<int>(points_.size()));
    points_.push_back(point);
    return near;
  }

 private:
  using Few = boost::container::static_vector<int, 8>;
  std::vector<Point> points_;
  std::vector<int> places_;  ///< by point, if each was asked for its place
  std::unordered_map<Cell, Few, CellHash> cells_;
};

bool has_topology(const Geometry& geometry) {
  return kind_of(geometry) == GeometryKind::segment || kind_of(geometry) == GeometryKind::oriented_point;
}

/// Where a map is not surer than that, or where no sensor looks, near points need not be one: the two sides of a thin
/// wall in a grid end side by side.
bool is_exact(const MapFeature& feature) { return !feature.sensor.empty() && feature.position_sigma_m <= kSamePoint_m; }

/// Of a source with classes: where it is thin, it is meant so, as a pane of 8 mm.
bool is_imported(const SemanticMap& map, MapObjectNumber object) {
  return object.exists() && !map.object(object).notes.source_class.empty();
}

/// What tells geometries of one kind and place apart.
std::array<double, 2> own_numbers(const Geometry& geometry) {
  if (const auto* circle = std::get_if<Circle>(&geometry)) return {circle->radius_m, 0};
  if (const auto* corner = std::get_if<OrientedPoint>(&geometry)) return {corner->heading_rad, corner->opening_rad};
  return {0, 0};
}

bool alike(const Geometry& a, const Geometry& b) {
  const std::array<double, 2> numbers_a = own_numbers(a), numbers_b = own_numbers(b);
  return std::abs(numbers_a[0] - numbers_b[0]) < kSamePoint_m && std::abs(numbers_a[1] - numbers_b[1]) < kSamePoint_m;
}

/// Cells of kNeighbour_m that a geometry passes; a very long segment is sampled, not walked.
std::vector<Cell> cells_passed(const Geometry& geometry) {
  std::vector<Cell> cells;
  if (const auto* segment = std::get_if<Segment>(&geometry)) {
    constexpr double kMostSteps = 1000;
    const double steps = std::clamp(std::ceil(2 * segment->length_m() / kNeighbour_m), 1.0, kMostSteps);
    for (double k = 0; k <= steps; ++k)
      cells.push_back(cell_of(segment->begin + k / steps * (segment->end - segment->begin), kNeighbour_m));
  } else {
    cells.push_back(cell_of(anchor_of(geometry), kNeighbour_m));
  }
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

/// The lowest and highest feature id in a cell: enough to know whether another than a given one is there.
struct Occupants {
  std::string_view lowest, highest;
};

}  // namespace

std::vector<PointPair> unshared_points(const SemanticMap& map) {
  struct Place {
    Point position;
    MapObjectNumber object;
  };
  std::map<std::string_view, Place> points;
  for (const MapFeature& feature : map.features())
    if (has_topology(feature.geometry) && is_exact(feature)) {
      const std::vector<Point> positions = points_of(feature.geometry);
      for (std::size_t k = 0; k < positions.size(); ++k)
        points.insert_or_assign(feature.points[k], Place{positions[k], feature.object});
    }
  NearPoints near_points;
  std::vector<decltype(points)::const_pointer> known;
  std::vector<PointPair> pairs;
  for (const auto& point : points) {
    const int near = near_points.add(point.second.position);
    if (near >= 0 && !(point.second.object == known[near]->second.object && is_imported(map, point.second.object)))
      pairs.push_back({std::string(point.first), std::string(known[near]->first)});
    known.push_back(&point);
  }
  return pairs;
}

std::vector<std::pair<MapFeatureNumber, MapFeatureNumber>> duplicate_features(const SemanticMap& map) {
  using Key = std::tuple<int, int, std::size_t, std::string_view>;  // places of the points, kind, sensor
  NearPoints near_points;
  std::map<Key, std::vector<MapFeatureNumber>> features_at;
  std::vector<std::pair<MapFeatureNumber, MapFeatureNumber>> pairs;
  for (std::size_t i = 0; i < map.features().size(); ++i) {
    const MapFeature& feature = map.features()[i];
    std::array<int, 2> places{-1, -1};
    const std::vector<Point> points = points_of(feature.geometry);
    for (std::size_t k = 0; k < points.size(); ++k) places[k] = near_points.place_of(points[k]);
    std::vector<MapFeatureNumber>& others =
        features_at[{places[0], places[1], feature.geometry.index(), feature.sensor}];
    const auto same = std::ranges::find_if(
        others, [&](MapFeatureNumber other) { return alike(map.feature(other).geometry, feature.geometry); });
    if (same != others.end())
      pairs.emplace_back(*same, MapFeatureNumber(i));
    else
      others.emplace_back(i);
  }
  return pairs;
}

std::vector<MapFeatureNumber> isolated_features(const SemanticMap& map) {
  std::unordered_map<Cell, Occupants, CellHash> occupants;
  for (const MapFeature& feature : map.features())
    for (const Cell& cell : cells_passed(feature.geometry)) {
      const auto [entry, is_new] = occupants.try_emplace(cell, Occupants{feature.id, feature.id});
      entry->second.lowest = std::min<std::string_view>(entry->second.lowest, feature.id);
      entry->second.highest = std::max<std::string_view>(entry->second.highest, feature.id);
    }
  std::vector<MapFeatureNumber> isolated;
  for (std::size_t i = 0; i < map.features().size(); ++i) {
    const std::string& id = map.features()[i].id;
    bool has_neighbour = false;
    for (const Cell& passed : cells_passed(map.features()[i].geometry))
      for_neighbours(passed, [&](const Cell& cell) {
        const auto found = occupants.find(cell);
        if (found != occupants.end() && (found->second.lowest != id || found->second.highest != id))
          has_neighbour = true;
      });
    if (!has_neighbour) isolated.emplace_back(i);
  }
  return isolated;
}

std::vector<MapFeatureNumber> backward_faces(const SemanticMap& map) {
  struct Met {
    int begins = 0, ends = 0;
  };
  struct Face {
    MapFeatureNumber number;
    Met *at_begin, *at_end;
  };
  NearPoints near_points;
  std::map<std::pair<int, std::string_view>, Met> met;  // by place and sensor
  std::vector<Face> faces;
  for (std::size_t i = 0; i < map.features().size(); ++i) {
    const MapFeature& feature = map.features()[i];
    const auto* face = std::get_if<Segment>(&feature.geometry);
    if (face == nullptr || feature.sensor.empty() || is_imported(map, feature.object)) continue;
    faces.push_back({MapFeatureNumber(i), &met[{near_points.place_of(face->begin), feature.sensor}],
                     &met[{near_points.place_of(face->end), feature.sensor}]});
    ++faces.back().at_begin->begins;
    ++faces.back().at_end->ends;
  }
  std::vector<MapFeatureNumber> backward;
  for (const Face& face : faces)
    if (face.at_begin->begins == 2 && face.at_begin->ends == 0 && face.at_end->ends == 2 && face.at_end->begins == 0)
      backward.push_back(face.number);
  return backward;
}

int count_shared_points(const SemanticMap& map) {
  std::unordered_map<std::string_view, std::pair<const std::string*, bool>>
      first_feature;  // and whether there is another
  first_feature.reserve(2 * map.features().size());
  for (const MapFeature& feature : map.features())
    for (const std::string& point : feature.points) {
      const auto [entry, is_new] = first_feature.try_emplace(point, &feature.id, false);
      if (*entry->second.first != feature.id) entry->second.second = true;
    }
  return static_cast<int>(std::ranges::count_if(first_feature, [](const auto& entry) { return entry.second.second; }));
}

}  // namespace opal
