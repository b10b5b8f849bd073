#include "map_tools/test_maps/plan_sketch.hpp"

#include "map_tools/test_maps/expected_number.hpp"
#include "map_tools/test_maps/grid_smoothing.hpp"
#include "map_tools/test_maps/plan_strokes.hpp"

#include <Eigen/Geometry>

#include <algorithm>

namespace opal {
namespace {

using Strokes = std::vector<Stroke>;

constexpr double kMargin_m = 1.5;  ///< of the sheet around what is drawn

constexpr ExpectedNumbers kExpectedOfSketch("plan sketch");

void expect_sense(const PlanSketch& sketch) {
  const auto& expect = kExpectedOfSketch;
  expect("cell", sketch.resolution_m, 0.01, 0.5, "m");
  expect("pen", sketch.pen_m, 0, 1, "m");
  expect("wobble", sketch.wobble_m, 0, 1, "m");
  expect("scale", sketch.scale_sigma, 0, 0.2, "");
  expect("turn", sketch.turn_sigma_rad, 0, 0.5, "rad");
  expect("skew", sketch.skew_sigma_rad, 0, 0.2, "rad");
  expect("furniture", sketch.furniture, 0, 100, "per 100 m2");
  expect("words", sketch.words, 0, 100, "per 100 m2");
  expect("blur", sketch.blur_m, 0, 1, "m");
  expect("dirt", sketch.dirt, 0, 0.2, "");
}

/// Places on the floor, and how large it is.
class FloorPlaces {
 public:
  explicit FloorPlaces(const SemanticMap& map) {
    constexpr double kCell_m = 0.2;
    const MapRaster raster = rasterized(map, {kCell_m, 0, true});
    for (int row = 0; row < raster.rows; ++row)
      for (int column = 0; column < raster.columns; ++column)
        if (raster.at(column, row) == MapRaster::Cell::free)
          cells_.push_back(raster.origin + kCell_m * Point(column + 0.5, row + 0.5));
    area_m2_ = kCell_m * kCell_m * static_cast<double>(cells_.size());
  }
  std::vector<Point> drawn(double per_100_m2, Random& random) const {
    std::vector<Point> places;
    const auto count = static_cast<std::size_t>(per_100_m2 * area_m2_ / 100 + random.share());
    for (std::size_t k = 0; k < count && !cells_.empty(); ++k) places.push_back(cells_[random.below(cells_.size())]);
    return places;
  }

 private:
  std::vector<Point> cells_;
  double area_m2_ = 0;
};

void append(Strokes& strokes, const Strokes& more) { strokes.insert(strokes.end(), more.begin(), more.end()); }

/// A hand is surer of a short line than of a long one.
void wobble(Stroke& stroke, double sigma_m, Random& random) {
  constexpr double kOfLength = 0.1;
  const double off_m = std::min(sigma_m, kOfLength * stroke.length_m());
  for (Point* end : {&stroke.begin, &stroke.end})
    for (int axis = 0; axis < 2; ++axis) (*end)[axis] += random.normal(off_m);
}

Strokes strokes_of(const SemanticMap& map, const PlanSketch& sketch, Random& random) {
  const FloorPlaces floor(map);
  Strokes strokes = wall_strokes(map, sketch.single_lines);
  append(strokes, column_strokes(map));
  append(strokes, door_strokes(map, random));
  append(strokes, furniture_strokes(floor.drawn(sketch.furniture, random), random));
  append(strokes, word_strokes(floor.drawn(sketch.words, random), random));
  for (Stroke& stroke : strokes) wobble(stroke, sketch.wobble_m, random);
  return strokes;
}

Eigen::AlignedBox2d extent_of(const Strokes& strokes) {
  Eigen::AlignedBox2d box;
  for (const Stroke& stroke : strokes) box.extend(stroke.begin).extend(stroke.end);
  return box;
}

/// About their middle: how a plan is not true to scale.
void distort(Strokes& strokes, const PlanSketch& sketch, Random& random) {
  const double wide = 1 + random.normal(sketch.scale_sigma), high = 1 + random.normal(sketch.scale_sigma);
  const double skew = random.normal(sketch.skew_sigma_rad), turn = random.normal(sketch.turn_sigma_rad);
  Eigen::Matrix2d stretch;
  stretch << wide, skew, 0, high;
  const Eigen::Matrix2d all = Eigen::Rotation2Dd(turn).toRotationMatrix() * stretch;
  const Point middle = extent_of(strokes).center();
  for (Stroke& stroke : strokes)
    stroke = {middle + all * (stroke.begin - middle), middle + all * (stroke.end - middle)};
}

class Sheet {
 public:
  Sheet(const Strokes& strokes, const PlanSketch& sketch) : sketch_(sketch) {
    const Eigen::AlignedBox2d drawn = extent_of(strokes);
    const Point size = (drawn.sizes() + Point::Constant(2 * kMargin_m)) / sketch.resolution_m;
    kExpectedOfSketch("cells", size.x() * size.y(), 1, 1e8);
    raster_.resolution_m = sketch.resolution_m;
    raster_.origin = drawn.min() - Point::Constant(kMargin_m);
    raster_.columns = static_cast<int>(size.x()) + 1;
    raster_.rows = static_cast<int>(size.y()) + 1;
    ink_.assign(static_cast<std::size_t>(raster_.columns) * raster_.rows, 0);
    for (const Stroke& stroke : strokes) draw(stroke);
  }

  void soil(Random& random) {
    if (!(sketch_.dirt > 0)) return;
    for (double& ink : ink_)
      if (random.chance(sketch_.dirt)) ink = 1 - ink;
  }

  /// What is half ink is ink.
  MapRaster scanned() {
    smooth_grid(ink_, raster_.columns, raster_.rows, sketch_.blur_m / raster_.resolution_m);
    raster_.cells.resize(ink_.size());
    std::transform(ink_.begin(), ink_.end(), raster_.cells.begin(),
                   [](double ink) { return ink >= 0.5 ? MapRaster::Cell::occupied : MapRaster::Cell::free; });
    return std::move(raster_);
  }

 private:
  /// All cells whose middle the pen passes over.
  void draw(const Stroke& stroke) {
    const double reach_m = std::max(sketch_.pen_m / 2, 0.51 * raster_.resolution_m);
    Eigen::AlignedBox2d box(stroke.begin.cwiseMin(stroke.end), stroke.begin.cwiseMax(stroke.end));
    const auto cell_of = [&](const Point& p) {
      return ((p - raster_.origin) / raster_.resolution_m).array().floor().cast<int>().eval();
    };
    const auto low = cell_of(box.min() - Point::Constant(reach_m)),
               high = cell_of(box.max() + Point::Constant(reach_m));
    for (int row = std::max(0, low.y()); row <= std::min(raster_.rows - 1, high.y()); ++row)
      for (int column = std::max(0, low.x()); column <= std::min(raster_.columns - 1, high.x()); ++column) {
        const Point middle = raster_.origin + raster_.resolution_m * Point(column + 0.5, row + 0.5);
        if (distance_m(Geometry(stroke), middle) <= reach_m)
          ink_[static_cast<std::size_t>(row) * raster_.columns + column] = 1;
      }
  }

  const PlanSketch& sketch_;
  MapRaster raster_;  ///< its cells only at the end
  std::vector<double> ink_;
};

}  // namespace

PlanSketch drawn_by_hand() { return {}; }

PlanSketch printed_and_scanned() {
  PlanSketch sketch;
  sketch.single_lines = false;
  sketch.wobble_m = 0;
  sketch.turn_sigma_rad = sketch.skew_sigma_rad = 0.004;
  sketch.blur_m = 0.04;
  sketch.dirt = 0.01;
  return sketch;
}

MapRaster sketched(const SemanticMap& map, const PlanSketch& sketch) {
  expect_sense(sketch);
  Random random(sketch.seed);
  Strokes strokes = strokes_of(map, sketch, random);
  distort(strokes, sketch, random);
  Sheet sheet(strokes, sketch);
  sheet.soil(random);
  return sheet.scanned();
}

}  // namespace opal
