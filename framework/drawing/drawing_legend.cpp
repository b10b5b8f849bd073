#include "drawing/drawing_layers.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>

namespace opal {
namespace {

constexpr double kSymbol_px = 30, kSymbolGap_px = 12, kRow_px = 24, kText_px = 13, kNote_px = 12, kNoteRow_px = 17,
                 kNoteGap_px = 5, kNoteWidth_px = 380;
constexpr double kNotesGap_px = 18;

struct LegendRow {
  std::string label;
  std::function<void(DrawingCanvas&, const Point& middle_px)> symbol;  ///< at the middle of the symbol's place
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
  return
      [=](DrawingCanvas& canvas, const Point& middle_px) { canvas.page_disc(middle_px, radius_px, fill, ink.color); };
}

auto head_symbol(const Color& color, double size_px) {
  return [=](DrawingCanvas& canvas, const Point& middle_px) {
    canvas.page_arrow_head(middle_px, 0, size_px, color, ink::kPlot);
  };
}

void dots_symbol(DrawingCanvas& canvas, const Point& middle_px) {
  for (int k = -2; k <= 2; ++k)
    canvas.page_disc(middle_px + Point(5 * k, std::abs(k) - 1), kScanDot_px, ink::kScan, ink::kScan.with_opacity(0));
}

void area_symbol(DrawingCanvas& canvas, const Point& middle_px) {
  const Point size(kSymbol_px - 4, 12);
  canvas.page_rectangle(middle_px - size / 2, size, ink::kFreeSpace.with_opacity(0.3));
}

/// Of a wall, with its shaded side below.
void body_symbol(DrawingCanvas& canvas, const Point& middle_px) {
  const Point size(kSymbol_px - 4, 7);
  canvas.page_rectangle(middle_px - Point(size.x() / 2, 0), size, ink::kText.with_opacity(kBodyOpacity));
  stroke_symbol(ink::kText, 1.5)(canvas, middle_px);
}

void floor_symbol(DrawingCanvas& canvas, const Point& middle_px) {
  const Point size(kSymbol_px - 4, 12);
  canvas.page_rectangle(middle_px - size / 2, size, ink::kFloor);
}

std::string short_name(const std::string& type) { return type.rfind("opal:", 0) == 0 ? type.substr(5) : type; }

void ended_symbol(DrawingCanvas& canvas, const Point& middle_px) {
  const double half_px = kEndedHead_px / 2;
  canvas.page_arrow_head(middle_px, 0, kEndedHead_px, ink::kPlot, ink::kEnded);
  canvas.page_line(middle_px - Point(half_px, half_px), middle_px + Point(half_px, half_px), ink::kEnded, 1);
  canvas.page_line(middle_px - Point(half_px, -half_px), middle_px + Point(half_px, -half_px), ink::kEnded, 1);
}

auto perception_symbol(DrawingScene::Perception perception) {
  return stroke_symbol(stroke_of(perception).color, stroke_of(perception).width_px);
}

std::size_t count(const DrawingScene& scene, DrawingScene::Perception perception) {
  return static_cast<std::size_t>(std::count_if(scene.local_features.begin(), scene.local_features.end(),
                                                [&](const auto& feature) { return feature.perception == perception; }));
}

std::vector<LegendRow> map_rows(const SemanticMap& map) {
  std::vector<LegendRow> rows;
  for (const auto& [type, type_ink] : inks_of_types(map))
    rows.push_back({short_name(type) + " (" + std::to_string(type_ink.objects) + ")", shape_symbol(type_ink)});
  const auto& all = map.features();
  if (std::any_of(all.begin(), all.end(), [](const auto& f) { return std::holds_alternative<Segment>(f.geometry); }))
    rows.push_back({"grey: the side of a face that is not seen", body_symbol});
  return rows;
}

std::vector<LegendRow> legend_rows(const DrawingScene& scene) {
  std::vector<LegendRow> rows;
  if (scene.map) rows = map_rows(*scene.map);
  const auto add = [&](bool present, std::string label, auto symbol) {
    if (present) rows.push_back({std::move(label), std::move(symbol)});
  };
  add(!scene.floor.empty(), "where a robot can be", floor_symbol);
  add(!scene.unmapped.empty(), scene.unmapped_words, stroke_symbol(ink::kUnmapped, kUnmapped_px));
  add(!scene.free_space.empty(), "seen to be free", area_symbol);
  add(!scene.scan_points.empty(), "scan", dots_symbol);
  using Perception = DrawingScene::Perception;
  for (const auto& [perception, name] :
       {std::pair(Perception::candidate, std::string("local feature, seen too little yet")),
        std::pair(Perception::stable, std::string("local feature")),
        std::pair(Perception::matched, scene.matched_words)})
    if (const std::size_t found = count(scene, perception); found > 0)
      add(true, name + " (" + std::to_string(found) + ")", perception_symbol(perception));
  add(!scene.patterns.empty(),
      (scene.local_features.empty() ? "patterns (" : "patterns looked up (") + std::to_string(scene.patterns.size()) +
          ")",
      stroke_symbol(ink::kPattern, kPattern_px, kDash_px));
  add(!scene.associations.empty(), "mapped counterpart (" + std::to_string(scene.associations.size()) + ")",
      stroke_symbol(ink::kAssociation.with_opacity(0.45), kMatched_px));
  if (!scene.hypotheses.empty())
    add(true, "pose, " + percent(scene.hypotheses.front().probability), head_symbol(ink::kBest, kBestHead_px));
  add(scene.hypotheses.size() > 1, "other hypotheses (" + std::to_string(scene.hypotheses.size() - 1) + ")",
      head_symbol(alternative_color(0.5), alternative_head_px(0.5)));
  add(!scene.ended.empty(), "ended (" + std::to_string(scene.ended.size()) + ")", ended_symbol);
  add(!scene.contradictions.empty(),
      scene.contradiction_words + " (" + std::to_string(scene.contradictions.size()) + ")",
      stroke_symbol(ink::kContradiction, kContradiction_px, kDash_px));
  for (const auto& place : scene.places) add(true, place.label, draw_place);
  add(!scene.trajectory.empty(), "trajectory", stroke_symbol(ink::kTrajectory, kTrajectory_px));
  add(!scene.truth.empty(), "recorded truth", stroke_symbol(ink::kTruth, kTruth_px, kDash_px));
  return rows;
}

/// A space in every word that would not fit on a line, between characters (UTF-8).
std::string with_short_words(const std::string& sentence) {
  constexpr int kLongestWord = 48;
  std::string result;
  int characters = 0;
  for (const char c : sentence) {
    const bool begins_character = (static_cast<unsigned char>(c) & 0xC0) != 0x80;
    characters = c == ' ' ? 0 : characters + (begins_character ? 1 : 0);
    if (begins_character && characters > kLongestWord) {
      result += ' ';
      characters = 1;
    }
    result += c;
  }
  return result;
}

/// The words of a sentence in lines of bounded width.
std::vector<std::string> wrapped(DrawingCanvas& canvas, const std::string& sentence) {
  std::vector<std::string> lines;
  std::istringstream words(with_short_words(sentence));
  for (std::string word; words >> word;) {
    const std::string longer = lines.empty() ? word : lines.back() + ' ' + word;
    if (!lines.empty() && canvas.text_width_px(longer, kNote_px) <= kNoteWidth_px)
      lines.back() = longer;
    else
      lines.push_back(word);
  }
  return lines;
}

/// All notes; each begins a little lower than the line before.
std::vector<std::vector<std::string>> note_lines(DrawingCanvas& canvas, const DrawingScene& scene) {
  std::vector<std::vector<std::string>> notes;
  for (const std::string& note : scene.notes) notes.push_back(wrapped(canvas, note));
  return notes;
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
  for (const auto& note : note_lines(canvas, scene))
    for (const std::string& line : note) width_px = std::max(width_px, canvas.text_width_px(line, kNote_px));
  return width_px;
}

double legend_height_px(DrawingCanvas& canvas, const DrawingScene& scene) {
  double notes_px = 0;
  for (const auto& note : note_lines(canvas, scene))
    notes_px += static_cast<double>(note.size()) * kNoteRow_px + kNoteGap_px;
  return static_cast<double>(legend_rows(scene).size()) * kRow_px + (notes_px > 0 ? kNotesGap_px + notes_px : 0);
}

void draw_legend(DrawingCanvas& canvas, const DrawingScene& scene, const Point& corner_px) {
  Point place_px = corner_px;
  for (const LegendRow& row : legend_rows(scene)) {
    row.symbol(canvas, place_px + Point(kSymbol_px / 2, kRow_px / 2));
    canvas.text(place_px + Point(kSymbol_px + kSymbolGap_px, kRow_px / 2 + 0.36 * kText_px), row.label, kText_px,
                ink::kText);
    place_px.y() += kRow_px;
  }
  place_px.y() += kNotesGap_px;
  for (const auto& note : note_lines(canvas, scene)) {
    for (const std::string& line : note) {
      canvas.text(place_px + Point(0, 0.7 * kNoteRow_px), line, kNote_px, ink::kFaintText);
      place_px.y() += kNoteRow_px;
    }
    place_px.y() += kNoteGap_px;
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
