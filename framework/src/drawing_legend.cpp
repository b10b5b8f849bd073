#include "drawing_layers.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace opal {
namespace {

constexpr double kSymbol_px = 30, kSymbolGap_px = 12, kRow_px = 24, kText_px = 13, kNote_px = 12,
                 kNoteRow_px = 19;
constexpr double kNotesGap_px = 18;

struct LegendRow {
  std::string label;
  std::function<void(DrawingCanvas&, const Point& middle_px)>
      symbol;  ///< at the middle of the symbol's place
};

auto stroke_symbol(const Color& color, double width_px, double dash_px = 0) {
  return [=](DrawingCanvas& canvas, const Point& middle_px) {
    const Point half(kSymbol_px / 2 - 2, 0);
    canvas.page_line(middle_px - half, middle_px + half, color, width_px, dash_px);
  };
}

/// A piece of the shape that the type's features have.
std::function<void(DrawingCanvas&, const Point&)> shape_symbol(const TypeInk& ink) {
  if (ink.shape == GeometryKind::segment) return stroke_symbol(ink.color, 2.2);
  const double radius_px = ink.shape == GeometryKind::circle ? 6 : 2.5;
  const Color fill = ink.shape == GeometryKind::circle ? ink.color.with_opacity(0.15) : ink.color;
  return [=](DrawingCanvas& canvas, const Point& middle_px) {
    canvas.page_disc(middle_px, radius_px, fill, ink.color);
  };
}

auto head_symbol(const Color& color, double size_px) {
  return [=](DrawingCanvas& canvas, const Point& middle_px) {
    canvas.page_arrow_head(middle_px, 0, size_px, color, ink::kPlot);
  };
}

void dots_symbol(DrawingCanvas& canvas, const Point& middle_px) {
  for (int k = -2; k <= 2; ++k)
    canvas.page_disc(middle_px + Point(5 * k, std::abs(k) - 1), kScanDot_px, ink::kScan,
                     ink::kScan.with_opacity(0));
}

void area_symbol(DrawingCanvas& canvas, const Point& middle_px) {
  const Point size(kSymbol_px - 4, 12);
  canvas.page_rectangle(middle_px - size / 2, size, ink::kFreeSpace.with_opacity(0.3));
}

std::string short_name(const std::string& type) {
  return type.rfind("opal:", 0) == 0 ? type.substr(5) : type;
}

std::string percent(double probability) {
  const double value = 100 * probability;
  return value > 99 && value < 100 ? "> 99 %" : std::to_string(std::lround(value)) + " %";
}

std::vector<LegendRow> map_rows(const SemanticMap& map) {
  std::vector<LegendRow> rows;
  for (const auto& [type, type_ink] : inks_of_types(map))
    rows.push_back(
        {short_name(type) + " (" + std::to_string(type_ink.objects) + ")", shape_symbol(type_ink)});
  return rows;
}

std::vector<LegendRow> legend_rows(const DrawingScene& scene) {
  std::vector<LegendRow> rows;
  if (scene.map) rows = map_rows(*scene.map);
  const auto add = [&](bool present, std::string label, auto symbol) {
    if (present) rows.push_back({std::move(label), std::move(symbol)});
  };
  add(!scene.free_space.empty(), "seen to be free", area_symbol);
  add(!scene.scan_points.empty(), "scan", dots_symbol);
  add(!scene.local_features.empty(), "local feature", stroke_symbol(ink::kLocalFeature, kLocalFeature_px));
  add(!scene.associations.empty(), "associated (" + std::to_string(scene.associations.size()) + ")",
      stroke_symbol(ink::kAssociation.with_opacity(0.45), kMatched_px));
  if (!scene.hypotheses.empty())
    add(true, "pose, " + percent(scene.hypotheses.front().probability),
        head_symbol(ink::kBest, kBestHead_px));
  add(scene.hypotheses.size() > 1, "other hypotheses (" + std::to_string(scene.hypotheses.size() - 1) + ")",
      head_symbol(rival_color(0.5), rival_head_px(0.5)));
  add(!scene.trajectory.empty(), "trajectory", stroke_symbol(ink::kTrajectory, kTrajectory_px));
  add(!scene.truth.empty(), "recorded truth", stroke_symbol(ink::kTruth, kTruth_px, kDash_px));
  return rows;
}

double round_length_m(double about_m) {
  const double power = std::pow(10, std::floor(std::log10(about_m)));
  for (const double factor : {5.0, 2.0})
    if (factor * power <= about_m) return factor * power;
  return power;
}

std::string length_text(double length_m) {
  const bool whole = length_m >= 1;
  return (whole ? std::to_string(std::lround(length_m)) : std::to_string(length_m).substr(0, 4)) + " m";
}

}  // namespace

double legend_width_px(DrawingCanvas& canvas, const DrawingScene& scene) {
  double width_px = 0;
  for (const LegendRow& row : legend_rows(scene))
    width_px = std::max(width_px, kSymbol_px + kSymbolGap_px + canvas.text_width_px(row.label, kText_px));
  for (const std::string& note : scene.notes)
    width_px = std::max(width_px, canvas.text_width_px(note, kNote_px));
  return width_px;
}

double legend_height_px(const DrawingScene& scene) {
  const double notes_px = static_cast<double>(scene.notes.size()) * kNoteRow_px;
  return static_cast<double>(legend_rows(scene).size()) * kRow_px +
         (notes_px > 0 ? kNotesGap_px + notes_px : 0);
}

void draw_legend(DrawingCanvas& canvas, const DrawingScene& scene, const Point& corner_px) {
  Point place_px = corner_px;
  for (const LegendRow& row : legend_rows(scene)) {
    row.symbol(canvas, place_px + Point(kSymbol_px / 2, kRow_px / 2));
    canvas.text(place_px + Point(kSymbol_px + kSymbolGap_px, kRow_px / 2 + 0.36 * kText_px), row.label,
                kText_px, ink::kText);
    place_px.y() += kRow_px;
  }
  place_px.y() += kNotesGap_px;
  for (const std::string& note : scene.notes) {
    canvas.text(place_px + Point(0, 0.7 * kNoteRow_px), note, kNote_px, ink::kFaintText);
    place_px.y() += kNoteRow_px;
  }
}

void draw_scale_bar(DrawingCanvas& canvas) {
  const PageFrame& frame = canvas.frame();
  const double length_m = round_length_m(0.2 * frame.plot_size_px.x() / frame.px_per_m);
  const double length_px = length_m * frame.px_per_m;
  const Point left_px = frame.plot_origin_px + Point(1, 14), right_px = left_px + Point(length_px, 0);
  canvas.page_line(left_px, right_px, ink::kText, 1.4);
  for (const Point& end_px : {left_px, right_px})
    canvas.page_line(end_px + Point(0, -4), end_px + Point(0, 4), ink::kText, 1.4);
  const std::string label = length_text(length_m);
  canvas.text(right_px + Point(8, 0.36 * kNote_px), label, kNote_px, ink::kText);
}

}  // namespace opal
