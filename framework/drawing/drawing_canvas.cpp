#include "drawing/drawing_canvas.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace opal {
namespace {

constexpr double kFullTurn = 2 * std::numbers::pi;
constexpr double kCornerMark_px = 1.2;

bool finite(const Point& p) { return p.allFinite(); }

/// Bytes that are no UTF-8 (a file name may hold any) become replacement characters: cairo would draw nothing
/// any more.
std::string printable(const std::string& text) {
  using nlohmann::json;
  return json::parse(json(text).dump(-1, ' ', false, json::error_handler_t::replace)).get<std::string>();
}

}  // namespace

DrawingCanvas::DrawingCanvas(cairo_surface_t* surface, const PageFrame& frame)
    : cairo_(cairo_create(surface)), frame_(frame) {
  cairo_set_line_cap(cairo_.get(), CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(cairo_.get(), CAIRO_LINE_JOIN_ROUND);
}

void DrawingCanvas::clip_to_plot() {
  cairo_save(cairo_.get());
  cairo_rectangle(cairo_.get(), frame_.plot_origin_px.x(), frame_.plot_origin_px.y() - frame_.plot_size_px.y(),
                  frame_.plot_size_px.x(), frame_.plot_size_px.y());
  cairo_clip(cairo_.get());
}

void DrawingCanvas::unclip() { cairo_restore(cairo_.get()); }

void DrawingCanvas::set(const Color& c) { cairo_set_source_rgba(cairo_.get(), c.red, c.green, c.blue, c.opacity); }

void DrawingCanvas::trace(std::span<const Point> points) {
  bool pen_down = false;
  for (const Point& p : points) {
    if (!finite(p)) continue;
    const Point q = frame_.to_page(p);
    if (pen_down)
      cairo_line_to(cairo_.get(), q.x(), q.y());
    else
      cairo_move_to(cairo_.get(), q.x(), q.y());
    pen_down = true;
  }
}

void DrawingCanvas::stroke(const Color& color, double width_px, double dash_px) {
  cairo_set_dash(cairo_.get(), &dash_px, dash_px > 0 ? 1 : 0, 0);
  cairo_set_line_width(cairo_.get(), width_px);
  set(color);
  cairo_stroke(cairo_.get());
}

void DrawingCanvas::line(std::span<const Point> points, const Color& color, double width_px, double dash_px) {
  trace(points);
  stroke(color, width_px, dash_px);
}

void DrawingCanvas::segment(const Segment& segment, const Color& color, double width_px) {
  line(std::array{segment.begin, segment.end}, color, width_px);
}

void DrawingCanvas::polygon(std::span<const Point> points, const Color& fill) {
  trace(points);
  set(fill);
  cairo_fill(cairo_.get());
}

void DrawingCanvas::circle(const Circle& circle, const Color& fill, const Color& outline, double width_px) {
  if (!finite(circle.center) || !(circle.radius_m >= 0)) return;
  const Point center = frame_.to_page(circle.center);
  cairo_new_sub_path(cairo_.get());
  cairo_arc(cairo_.get(), center.x(), center.y(), circle.radius_m * frame_.px_per_m, 0, kFullTurn);
  set(fill);
  cairo_fill_preserve(cairo_.get());
  stroke(outline, width_px);
}

void DrawingCanvas::dots(std::span<const Point> points, const Color& color, double radius_px) {
  // A stroke of no length with round caps is a dot: the shortest description there is, in SVG too.
  for (const Point& p : points) {
    if (!finite(p)) continue;
    const Point q = frame_.to_page(p);
    cairo_move_to(cairo_.get(), q.x(), q.y());
    cairo_close_path(cairo_.get());
  }
  stroke(color, 2 * radius_px);
}

void DrawingCanvas::arrow_head(const Pose2& pose, double size_px, const Color& fill, const Color& outline) {
  if (finite(pose.position()) && std::isfinite(pose.heading_rad()))
    page_arrow_head(frame_.to_page(pose.position()), pose.heading_rad(), size_px, fill, outline);
}

void DrawingCanvas::cross(const Point& center, double half_px, const Color& color, double width_px) {
  if (!finite(center)) return;
  const Point at = frame_.to_page(center), rising(half_px, -half_px), falling(half_px, half_px);
  page_line(at - rising, at + rising, color, width_px);
  page_line(at - falling, at + falling, color, width_px);
}

void DrawingCanvas::geometry(const Geometry& geometry, const Color& color, double width_px) {
  if (const auto* s = std::get_if<Segment>(&geometry))
    segment(*s, color, width_px);
  else if (const auto* c = std::get_if<Circle>(&geometry))
    circle(*c, color.with_opacity(0.15 * color.opacity), color, width_px);
  else
    dots(std::array{anchor_of(geometry)}, color, kCornerMark_px + width_px / 2);
}

void DrawingCanvas::page_rectangle(const Point& corner_px, const Point& size_px, const Color& fill) {
  cairo_rectangle(cairo_.get(), corner_px.x(), corner_px.y(), size_px.x(), size_px.y());
  set(fill);
  cairo_fill(cairo_.get());
}

void DrawingCanvas::page_line(const Point& from_px, const Point& to_px, const Color& color, double width_px,
                              double dash_px) {
  cairo_move_to(cairo_.get(), from_px.x(), from_px.y());
  cairo_line_to(cairo_.get(), to_px.x(), to_px.y());
  stroke(color, width_px, dash_px);
}

void DrawingCanvas::page_polygon(std::span<const Point> corners_px, const Color& fill) {
  for (const Point& corner : corners_px) cairo_line_to(cairo_.get(), corner.x(), corner.y());
  cairo_close_path(cairo_.get());
  set(fill);
  cairo_fill(cairo_.get());
}

void DrawingCanvas::page_disc(const Point& center_px, double radius_px, const Color& fill, const Color& outline) {
  cairo_new_sub_path(cairo_.get());
  cairo_arc(cairo_.get(), center_px.x(), center_px.y(), radius_px, 0, kFullTurn);
  set(fill);
  cairo_fill_preserve(cairo_.get());
  stroke(outline, 1);
}

void DrawingCanvas::page_arrow_head(const Point& center_px, double heading_rad, double size_px, const Color& fill,
                                    const Color& outline) {
  const Pose2 T_page_head(center_px, -heading_rad);  // the page's y axis points down
  const std::array corners{Point(0.65, 0), Point(-0.45, 0.42), Point(-0.22, 0), Point(-0.45, -0.42)};
  for (const Point& corner : corners) {
    const Point q = T_page_head * Point(size_px * corner);
    cairo_line_to(cairo_.get(), q.x(), q.y());
  }
  cairo_close_path(cairo_.get());
  set(fill);
  cairo_fill_preserve(cairo_.get());
  stroke(outline, 1);
}

void DrawingCanvas::text(const Point& baseline_px, const std::string& text, double size_px, const Color& color,
                         bool bold) {
  cairo_select_font_face(cairo_.get(), "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo_.get(), size_px);
  set(color);
  cairo_move_to(cairo_.get(), baseline_px.x(), baseline_px.y());
  cairo_show_text(cairo_.get(), printable(text).c_str());
  cairo_new_path(cairo_.get());
}

double DrawingCanvas::text_width_px(const std::string& text, double size_px, bool bold) {
  cairo_select_font_face(cairo_.get(), "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo_.get(), size_px);
  cairo_text_extents_t extents{};
  cairo_text_extents(cairo_.get(), printable(text).c_str(), &extents);
  return extents.x_advance;
}

}  // namespace opal
