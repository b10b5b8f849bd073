#include <opal/map/view/map_view.hpp>

#include "common/geometry_box.hpp"
#include "map/view/map_size.hpp"
#include "map/view/support_lines.hpp"
#include "map/view/surface_grid.hpp"
#include "map/view/tile_cache.hpp"

#include <opal/common/error.hpp>

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>

namespace opal {
namespace {

namespace bg = boost::geometry;
using BoostPoint = bg::model::point<double, 2, bg::cs::cartesian>;
using Box = bg::model::box<BoostPoint>;
using Entry = std::pair<Box, MapFeatureNumber>;
using RTree = bg::index::rtree<Entry, bg::index::quadratic<16>>;

Box as_box(const Eigen::AlignedBox2d& box) { return {{box.min().x(), box.min().y()}, {box.max().x(), box.max().y()}}; }

std::vector<MapFeatureNumber> features_of(const SemanticMap& map, const std::string& sensor) {
  std::vector<MapFeatureNumber> numbers;
  for (std::size_t k = 0; k < map.features().size(); ++k)
    if (map.features()[k].sensor == sensor) numbers.emplace_back(k);
  if (numbers.empty()) throw ConfigError(map.name() + ": holds no feature that sensor '" + sensor + "' can perceive");
  numbers.shrink_to_fit();
  return numbers;
}

Eigen::AlignedBox2d bounds_of(const SemanticMap& map, const std::vector<MapFeatureNumber>& numbers) {
  Eigen::AlignedBox2d all;
  for (MapFeatureNumber number : numbers) all.extend(box_of(map.feature(number).geometry));
  return all;
}

std::vector<NumberedShape> shapes_of(const SemanticMap& map, const std::vector<MapFeatureNumber>& numbers) {
  std::vector<NumberedShape> shapes;
  for (MapFeatureNumber number : numbers) shapes.emplace_back(number, map.feature(number).geometry);
  return shapes;
}

SurfaceGrid grid_of(const SemanticMap& map, const std::vector<MapFeatureNumber>& numbers,
                    const Eigen::AlignedBox2d& bounds, const std::string& kept_in) {
  expect_small_enough(map, numbers, bounds.sizes());
  const TileLayout layout = TileLayout::around(bounds.min(), bounds.max());
  const auto features = static_cast<int>(map.features().size());
  return {layout, TileCache(kept_in).tiles_of(layout, shapes_of(map, numbers), features)};
}

constexpr int kMostSlack_cm = 50;

/// By distance plus kMostSlack_cm.
std::array<float, kMostSlack_cm + 256> likelihood_field_by_cm() {
  constexpr double sigma_cm = 20;
  std::array<float, kMostSlack_cm + 256> table{};
  for (int k = 0; k < kMostSlack_cm + 255; ++k) {
    const int cm = std::max(0, k - kMostSlack_cm);
    table[k] = static_cast<float>(std::exp(-0.5 * cm * cm / (sigma_cm * sigma_cm)));
  }
  return table;
}

Surface surface_of(const Geometry& geometry) {
  if (const auto* s = std::get_if<Segment>(&geometry)) return {s->begin, s->direction(), s->length_m()};
  if (const auto* c = std::get_if<Circle>(&geometry)) return {c->center, Point::Zero(), c->radius_m};
  return {};
}

struct Ray {
  Point origin;
  Point direction;  ///< unit
  double range_m;   ///< to the target
  double min_penetration_m;
};

// A walk along a ray goes as far as the distance in the grid allows, and looks for surfaces where it allows less than
// a step. The numbers of each step are looked up: a walk is a chain of steps each of which waits for the one before.
constexpr double kStep_m = 0.09;           // just below a cell
constexpr double kInCell_m = 0.071;        // half a cell's diagonal: how far the grid's distance may be off
constexpr std::uint8_t kPassable_cm = 12;  // from here on, more than kInCell_m + kStep_m / 2: no surface is in reach

/// By distance [cm].
constexpr std::array<double, 256> strides_m() {
  std::array<double, 256> strides{};
  for (int cm = 0; cm < 256; ++cm) {
    const double clearance = cm == 255 ? MapView::clearance_cap_m() : 0.01 * cm;
    strides[cm] = cm < kPassable_cm ? kStep_m : std::max(kStep_m, clearance - kInCell_m);
  }
  return strides;
}
constexpr std::array<double, 256> kStride_m = strides_m();

/// Range at which the ray passes through a face by more than the margin, or -1.
double meets_face(const Ray& ray, const Surface& face, bool& from_behind) {
  const double slope = face.normal().dot(ray.direction);
  if (std::abs(slope) < 0.02) return -1;  // grazing: the range is not defined well enough
  const double range = face.normal().dot(face.origin - ray.origin) / slope;
  if (range <= 0 || (ray.range_m - range) * std::abs(slope) < ray.min_penetration_m) return -1;
  const double along = face.direction.dot(ray.origin + range * ray.direction - face.origin);
  constexpr double kOvershoot_m = 0.03;
  if (along < -kOvershoot_m || along > face.size_m + kOvershoot_m) return -1;
  from_behind = slope > 0;
  return range;
}

/// The same for a circle; a beam that ends inside it, or merely scratches it, does not count.
double meets_circle(const Ray& ray, const Surface& circle) {
  const Point to_center = circle.origin - ray.origin;
  const double along = to_center.dot(ray.direction), aside = cross(ray.direction, to_center);
  if (along <= 0 || std::abs(aside) >= circle.size_m) return -1;
  const double half_chord = std::sqrt(circle.size_m * circle.size_m - aside * aside);
  const double range = along - half_chord;
  if (range <= 0 || ray.range_m - range < std::max(ray.min_penetration_m, half_chord)) return -1;
  return range;
}

}  // namespace

struct MapView::Index {
  Index(const SemanticMap& map, const std::string& sensor, const std::string& kept_in)
      : folder(kept_in),
        numbers(features_of(map, sensor)),
        bounds(bounds_of(map, numbers)),
        surfaces(grid_of(map, numbers, bounds, kept_in)) {
    std::vector<Entry> entries;
    by_number.resize(map.features().size());
    for (MapFeatureNumber number : numbers) {
      const Geometry& geometry = map.feature(number).geometry;
      surface(number) = surface_of(geometry);
      surface(number).object = map.feature(number).object;
      entries.emplace_back(as_box(box_of(geometry)), number);
    }
    tree = RTree(entries);
    number_lines(map);
  }

  /// Wider than the lines that patterns are made of: evidence must not count one wall twice.
  void number_lines(const SemanticMap& map) {
    constexpr SupportLineOptions kSameWall{.min_length_m = 0, .angle_rad = 0.15, .offset_m = 0.2, .gap_m = 30};
    std::vector<MapFeatureNumber> faces;
    for (MapFeatureNumber number : numbers) {
      surface(number).line = WallLineNumber(number.number());
      if (std::holds_alternative<Segment>(map.feature(number).geometry)) faces.push_back(number);
    }
    for (const MappedFeature& line : support_lines(map, std::move(faces), kSameWall))
      for (MapFeatureNumber number : line.numbers) surface(number).line = surface(line.numbers.front()).line;
  }

  Surface& surface(MapFeatureNumber number) { return by_number[number.number()]; }
  const Surface& surface(MapFeatureNumber number) const { return by_number[number.number()]; }

  template <class Query>
  std::vector<MapFeatureNumber> numbers_of(const Query& query) const {
    std::vector<MapFeatureNumber> found;
    for (auto it = tree.qbegin(query); it != tree.qend(); ++it) found.push_back(it->second);
    return found;
  }

  std::string folder;  ///< of what is prepared
  std::vector<MapFeatureNumber> numbers;
  Eigen::AlignedBox2d bounds;
  SurfaceGrid surfaces;
  std::vector<Surface> by_number;
  RTree tree;
  std::array<float, kMostSlack_cm + 256> likelihood_field = likelihood_field_by_cm();
};

MapView::MapView(std::shared_ptr<const SemanticMap> map, const std::string& sensor, const std::string& kept_in)
    : map_(std::move(map)), index_(std::make_unique<const Index>(*map_, sensor, kept_in)) {}
MapView::~MapView() = default;

const SemanticMap& MapView::map() const { return *map_; }
const std::string& MapView::kept_in() const { return index_->folder; }
const MapFeature& MapView::feature(MapFeatureNumber number) const { return map_->feature(number); }
const Surface& MapView::surface(MapFeatureNumber number) const { return index_->surface(number); }
std::span<const MapFeatureNumber> MapView::features() const { return index_->numbers; }
std::array<Point, 2> MapView::bounds() const { return {index_->bounds.min(), index_->bounds.max()}; }

std::vector<MapFeatureNumber> MapView::within(const Point& p, double radius_m) const {
  constexpr double kRounding_m = 1e-9;  // of the box, for coordinates up to 1e6 m: what is near enough decides
  const Point radius = Point::Constant(radius_m + kRounding_m);
  const auto near_enough = [&](const Entry& e) { return distance_m(feature(e.second).geometry, p) <= radius_m; };
  const auto query = bg::index::intersects(as_box({p - radius, p + radius})) && bg::index::satisfies(near_enough);
  return index_->numbers_of(query);
}

MapFeatureNumber MapView::nearest_facing(const Point& p, const Point& view_direction) const {
  const auto faces_viewer = [&](MapFeatureNumber number) {
    if (!number.exists()) return false;
    const Surface& surface = index_->surface(number);
    return surface.is_circle() || !(surface.normal().dot(view_direction) >= 0);
  };
  const auto [first, second] = index_->surfaces.nearest(p);
  if (!faces_viewer(second))
    return faces_viewer(first) ? first : MapFeatureNumber();  // mostly: a wall's faces look either way
  if (!faces_viewer(first)) return second;
  return surface(second).distance_m(p) >= surface(first).distance_m(p) ? first : second;
}

double MapView::clearance_m(const Point& p) const {
  const auto cm = index_->surfaces.distance_cm(p);
  return cm == 255 ? clearance_cap_m() : 0.01 * cm;
}

float MapView::likelihood_field(const Point& p) const {
  return index_->likelihood_field[kMostSlack_cm + index_->surfaces.distance_cm(p)];
}

float MapView::likelihood_field_sum(std::span<const Point> points, const Point& position, double slack_m) const {
  const float* table =
      &index_->likelihood_field[std::clamp(kMostSlack_cm - static_cast<int>(100 * slack_m), 0, kMostSlack_cm)];
  float sum = 0;
  for (const Point& point : points) sum += table[index_->surfaces.distance_cm(position + point)];
  return sum;
}

float MapView::coarse_likelihood_field_sum(std::span<const Point> points, const Point& position) const {
  float sum = 0;
  for (const Point& point : points)
    sum += index_->likelihood_field[kMostSlack_cm + index_->surfaces.coarse_distance_cm(position + point)];
  return sum;
}

MapView::Crossing MapView::first_crossing(const Point& origin, const Point& target, double min_penetration_m) const {
  const Point way = target - origin;
  const double length = way.norm();
  if (!(length > 0)) return {};
  const Ray ray{origin, way / length, length, min_penetration_m};
  const SurfaceGrid& grid = index_->surfaces;
  const Point from = grid.in_cells(origin), along = ray.direction * (1 / cell_m());
  for (double range = 0; range < length;) {
    const std::uint8_t cm = grid.distance_cm_in_cells(from + range * along);
    if (cm < kPassable_cm) {
      Crossing first;
      for (MapFeatureNumber number : grid.nearest(origin + range * ray.direction)) {
        if (!number.exists()) continue;
        const Surface& surface = index_->surface(number);
        bool from_behind = false;
        const double meets = surface.is_circle() ? meets_circle(ray, surface) : meets_face(ray, surface, from_behind);
        // What it meets farther on is looked at when the walk gets there: something else may come first.
        const bool is_here = meets > 0 && meets <= range + kStep_m;
        if (is_here && (!first.feature.exists() || meets < first.range_m)) first = {number, meets, from_behind};
      }
      if (first.feature.exists()) return first;
    }
    range += kStride_m[cm];
  }
  return {};
}

}  // namespace opal
