#pragma once

#include <opal/common/geometry.hpp>

#include <cairo.h>

#include <memory>
#include <span>
#include <string>

namespace opal {

struct Color {
  double red = 0, green = 0, blue = 0;
  double opacity = 1;
  Color with_opacity(double value) const { return {red, green, blue, value}; }
};

/// Where the plane is on the page: metres to pixels, y up to y down.
struct PageFrame {
  Point map_min = Point::Zero();         ///< [m], shown at the lower left corner of the plot
  Point plot_origin_px = Point::Zero();  ///< that corner on the page
  Point plot_size_px = Point::Zero();
  double px_per_m = 1;

  Point to_page(const Point& p) const {
    const Point d = (p - map_min) * px_per_m;
    return {plot_origin_px.x() + d.x(), plot_origin_px.y() - d.y()};
  }
};

/// Draws on a cairo context: geometry in metres, widths and text in pixels. What is not finite is left out.
class DrawingCanvas {
 public:
  DrawingCanvas(cairo_surface_t* surface, const PageFrame& frame);

  const PageFrame& frame() const { return frame_; }
  void clip_to_plot();
  void unclip();

  void line(std::span<const Point> points, const Color& color, double width_px, double dash_px = 0);
  void segment(const Segment& segment, const Color& color, double width_px);
  void polygon(std::span<const Point> points, const Color& fill);
  void circle(const Circle& circle, const Color& fill, const Color& outline, double width_px);
  void dots(std::span<const Point> points, const Color& color, double radius_px);
  /// An arrow head of some size in pixels that points along a pose's heading.
  void arrow_head(const Pose2& pose, double size_px, const Color& fill, const Color& outline);
  /// A diagonal cross of some size in pixels.
  void cross(const Point& center, double half_px, const Color& color, double width_px);
  /// Any geometry: lines for segments, rims for circles, small marks for points and corners.
  void geometry(const Geometry& geometry, const Color& color, double width_px);

  // In page coordinates.
  void page_rectangle(const Point& corner_px, const Point& size_px, const Color& fill);
  void page_line(const Point& from_px, const Point& to_px, const Color& color, double width_px, double dash_px = 0);
  void page_polygon(std::span<const Point> corners_px, const Color& fill);
  void page_disc(const Point& center_px, double radius_px, const Color& fill, const Color& outline);
  void page_arrow_head(const Point& center_px, double heading_rad, double size_px, const Color& fill,
                       const Color& outline);
  void text(const Point& baseline_px, const std::string& text, double size_px, const Color& color, bool bold = false);
  double text_width_px(const std::string& text, double size_px, bool bold = false);

 private:
  struct Release {
    void operator()(cairo_t* context) const { cairo_destroy(context); }
  };
  void set(const Color& color);
  void trace(std::span<const Point> points);
  void stroke(const Color& color, double width_px, double dash_px = 0);

  std::unique_ptr<cairo_t, Release> cairo_;
  PageFrame frame_;
};

}  // namespace opal
