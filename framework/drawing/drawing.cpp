#include "drawing/drawing.hpp"

#include "drawing/drawing_layers.hpp"
#include "drawing/picture_file.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace opal {
namespace {

constexpr double kPlotWidth_px = 1300, kPlotHeight_px = 900, kLeastPlotHeight_px = 260;
constexpr double kMargin_px = 28, kTitleRow_px = 40, kTitle_px = 18, kScaleRow_px = 16;
/// What the plot shows at least, and beyond the content on every side.
constexpr double kLeastExtent_m = 2, kBorder_m = 0.8;
/// A picture of a larger world would show nothing: such points are mistakes.
constexpr double kLargestCoordinate_m = 1e5;

/// The smallest rectangle around what it is shown.
class Extent {
 public:
  void add(const Point& p) {
    if (!p.allFinite() || p.cwiseAbs().maxCoeff() > kLargestCoordinate_m) return;
    box_.extend(p);
  }
  void add(const Geometry& geometry) {
    if (const auto* segment = std::get_if<Segment>(&geometry)) {
      add(segment->begin);
      add(segment->end);
    } else if (const auto* circle = std::get_if<Circle>(&geometry)) {
      add(Point(circle->center - Point::Constant(circle->radius_m)));
      add(Point(circle->center + Point::Constant(circle->radius_m)));
    } else {
      add(anchor_of(geometry));
    }
  }
  bool empty() const { return box_.isEmpty(); }
  std::array<Point, 2> corners() const {
    if (empty()) return {Point::Constant(-kLeastExtent_m), Point::Constant(kLeastExtent_m)};
    const Point missing = (Point::Constant(kLeastExtent_m) - box_.sizes()).cwiseMax(0.0) / 2;
    const Point border = missing + Point::Constant(kBorder_m);
    return {Point(box_.min() - border), Point(box_.max() + border)};
  }

 private:
  Eigen::AlignedBox2d box_;
};

std::array<Point, 2> view_of(const DrawingScene& scene) {
  if (scene.view && (*scene.view)[0].allFinite() && ((*scene.view)[1] - (*scene.view)[0]).minCoeff() > 0)
    return *scene.view;
  Extent extent;
  if (scene.map)
    for (const MapFeature& feature : scene.map->features()) extent.add(feature.geometry);
  for (const Point& p : scene.trajectory) extent.add(p);
  for (const Point& p : scene.truth) extent.add(p);
  for (const auto& hypothesis : scene.hypotheses) extent.add(hypothesis.T_map_base.position());
  if (extent.empty()) {
    for (const Point& p : scene.scan_points) extent.add(p);
    for (const auto& feature : scene.local_features) extent.add(feature.geometry);
  }
  return extent.corners();
}

struct Page {
  PageFrame frame;
  Point size_px;
  Point legend_px;
};

Page lay_out(const DrawingScene& scene) {
  const auto [min, max] = view_of(scene);
  const CairoSurface measuring(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1));
  DrawingCanvas canvas(measuring.get(), {});
  const Point extent_m = max - min;
  Page page;
  page.frame.map_min = min;
  page.frame.px_per_m = std::min(kPlotWidth_px / extent_m.x(), kPlotHeight_px / extent_m.y());
  page.frame.plot_size_px = extent_m * page.frame.px_per_m;
  const double top_px = kMargin_px + (scene.title.empty() ? 0 : kTitleRow_px);
  // A long, low plot is given room below, so that the legend fits beside it.
  const double rows_px = std::max({page.frame.plot_size_px.y(), legend_height_px(canvas, scene), kLeastPlotHeight_px});
  page.frame.map_min.y() -= (rows_px - page.frame.plot_size_px.y()) / 2 / page.frame.px_per_m;
  page.frame.plot_size_px.y() = rows_px;
  page.frame.plot_origin_px = {kMargin_px, top_px + rows_px};

  const double legend_width = legend_width_px(canvas, scene);
  const double title_width = canvas.text_width_px(scene.title, kTitle_px, true);
  page.legend_px = {kMargin_px + page.frame.plot_size_px.x() + kMargin_px, top_px};
  const double width_px = legend_width > 0 ? page.legend_px.x() + legend_width : page.legend_px.x() - kMargin_px;
  page.size_px = {std::ceil(std::max(width_px, kMargin_px + title_width) + kMargin_px),
                  std::ceil(top_px + rows_px + kScaleRow_px + kMargin_px)};
  return page;
}

void draw(const DrawingScene& scene, const Page& page, cairo_surface_t* surface) {
  DrawingCanvas canvas(surface, page.frame);
  canvas.page_rectangle(Point::Zero(), page.size_px, ink::kPaper);
  const PageFrame& frame = page.frame;
  canvas.page_rectangle(frame.plot_origin_px - Point(0, frame.plot_size_px.y()), frame.plot_size_px, ink::kPlot);
  if (!scene.title.empty()) canvas.text({kMargin_px, kMargin_px + kTitle_px}, scene.title, kTitle_px, ink::kText, true);
  draw_layers(canvas, scene);
  draw_scale_bar(canvas);
  draw_legend(canvas, scene, page.legend_px);
}

}  // namespace

void write_svg(const DrawingScene& scene, const std::string& path) {
  const Page page = lay_out(scene);
  write_svg_picture(path, page.size_px, [&](cairo_surface_t* surface) { draw(scene, page, surface); });
}

void write_png(const DrawingScene& scene, const std::string& path) {
  const Page page = lay_out(scene);
  write_png_picture(path, page.size_px, [&](cairo_surface_t* surface) { draw(scene, page, surface); });
}

}  // namespace opal
