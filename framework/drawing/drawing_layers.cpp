#include "drawing/drawing_layers.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace opal {
namespace {

constexpr double kWall_px = 1.5;
/// The side of a face that cannot be seen is shaded this deep.
constexpr double kBody_m = 0.12;
constexpr double kMost_grid_lines = 14, kMost_coordinates = 40;

Color color_of(const std::string& type, std::size_t others) {
  if (type == "opal:Wall") return {0.22, 0.27, 0.34};
  if (type == "opal:Column") return {0.72, 0.36, 0.18};
  if (type == "opal:Door") return {0.08, 0.52, 0.58};
  if (type == "opal:Window") return {0.30, 0.60, 0.85};
  static const Color kOthers[] = {{0.55, 0.35, 0.60}, {0.45, 0.50, 0.15}, {0.75, 0.30, 0.45}, {0.35, 0.40, 0.65}};
  return kOthers[others % std::size(kOthers)];
}

const std::string& type_of(const SemanticMap& map, const MapFeature& feature) {
  return feature.object.exists() ? map.object(feature.object).type : feature.type;
}

/// The distance between grid lines: 1, 2 or 5 times a power of ten.
double grid_step_m(double extent_m, double most_lines) {
  const double least = extent_m / most_lines;
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= least) return factor * power;
  return 10 * power;
}

/// Multiples of a step within a range.
std::vector<double> ticks(double from, double to, double step) {
  std::vector<double> values;
  for (double k = std::ceil(from / step); k * step < to; ++k) values.push_back(k * step);
  return values;
}

void draw_grid(DrawingCanvas& canvas, bool coordinates) {
  constexpr double kText_px = 10;
  const PageFrame& frame = canvas.frame();
  const Point size_m = frame.plot_size_px / frame.px_per_m, min = frame.map_min, max = min + size_m;
  const double most = coordinates ? kMost_coordinates : kMost_grid_lines;
  const double step_m = std::max(coordinates ? 1.0 : 0.0, grid_step_m(size_m.maxCoeff(), most));
  for (const double x : ticks(min.x(), max.x(), step_m)) {
    canvas.line(std::array{Point(x, min.y()), Point(x, max.y())}, ink::kGrid, 0.6);
    if (coordinates)
      canvas.text(frame.to_page({x, min.y()}) + Point(2, -3), std::to_string(std::lround(x)), kText_px, ink::kText);
  }
  for (const double y : ticks(min.y(), max.y(), step_m)) {
    canvas.line(std::array{Point(min.x(), y), Point(max.x(), y)}, ink::kGrid, 0.6);
    if (coordinates)
      canvas.text(frame.to_page({min.x(), y}) + Point(2, -2), std::to_string(std::lround(y)), kText_px, ink::kText);
  }
}

void draw_floor(DrawingCanvas& canvas, const DrawingScene& scene) {
  for (const auto& [min, max] : scene.floor)
    canvas.polygon(std::array{min, Point(max.x(), min.y()), max, Point(min.x(), max.y())}, ink::kFloor);
}

void draw_body(DrawingCanvas& canvas, const Segment& face, const Color& color) {
  if (!(face.length_m() > 0)) return;
  const Point behind = -kBody_m * face.normal();
  canvas.polygon(std::array{face.begin, face.end, Point(face.end + behind), Point(face.begin + behind)},
                 color.with_opacity(kBodyOpacity));
}

void draw_map(DrawingCanvas& canvas, const SemanticMap& map) {
  const auto inks = inks_of_types(map);
  const auto color = [&](const MapFeature& f) { return inks.at(type_of(map, f)).color; };
  for (const MapFeature& feature : map.features())
    if (const auto* face = std::get_if<Segment>(&feature.geometry)) draw_body(canvas, *face, color(feature));
  for (const MapFeature& feature : map.features()) canvas.geometry(feature.geometry, color(feature), kWall_px);
}

/// Names of sheets, above their upper left corners; where the picture ends there, inside of it.
void draw_storeys(DrawingCanvas& canvas, const SemanticMap& map) {
  constexpr double kText_px = 13;
  const PageFrame& frame = canvas.frame();
  for (const MapStorey& storey : map.origin().storeys) {
    const Point corner = frame.to_page({storey.bounds[0].x(), storey.bounds[1].y()}) + Point(0, -4);
    const double room_px = frame.plot_size_px.x() - canvas.text_width_px(storey.label(), kText_px, true);
    const Point inside(std::min(corner.x(), frame.plot_origin_px.x() + room_px),
                       std::max(corner.y(), frame.plot_origin_px.y() - frame.plot_size_px.y() + kText_px));
    canvas.text(inside, storey.label(), kText_px, ink::kText, true);
  }
}

/// Where a short line can show which mapped geometry a local one is taken for.
Point nearest_on(const Geometry& geometry, const Point& p) {
  if (const auto* s = std::get_if<Segment>(&geometry)) {
    const double length_m = s->length_m();
    if (!(length_m > 0)) return s->begin;
    return s->begin + std::clamp((p - s->begin).dot(s->direction()), 0.0, length_m) * s->direction();
  }
  return anchor_of(geometry);
}

void draw_associations(DrawingCanvas& canvas, const DrawingScene& scene) {
  for (const auto& pair : scene.associations)
    canvas.geometry(pair.mapped, ink::kAssociation.with_opacity(0.30), kMatched_px);
}

void draw_association_lines(DrawingCanvas& canvas, const DrawingScene& scene) {
  if (scene.hypotheses.empty()) return;
  const Point robot = scene.hypotheses.front().T_map_base.position();
  for (const auto& pair : scene.associations) {
    const Point local = anchor_of(pair.local);
    canvas.line(std::array{robot, local, nearest_on(pair.mapped, local)}, ink::kAssociation.with_opacity(0.55),
                kAssociation_px);
  }
}

void draw_local_features(DrawingCanvas& canvas, const DrawingScene& scene) {
  for (const auto& feature : scene.local_features) {
    const Stroke stroke = stroke_of(feature.perception);
    canvas.geometry(feature.geometry, stroke.color, stroke.width_px);
  }
}

void draw_unmapped(DrawingCanvas& canvas, const DrawingScene& scene) {
  for (const Geometry& geometry : scene.unmapped) canvas.geometry(geometry, ink::kUnmapped, kUnmapped_px);
}

void draw_patterns(DrawingCanvas& canvas, const DrawingScene& scene) {
  for (const std::vector<Point>& members : scene.patterns) {
    canvas.line(members, ink::kPattern.with_opacity(0.7), kPattern_px, kDash_px);
    canvas.dots(members, ink::kPattern, kScanDot_px + 1);
  }
}

void draw_ended(DrawingCanvas& canvas, const DrawingScene& scene) {
  for (const Pose2& pose : scene.ended) {
    canvas.arrow_head(pose, kEndedHead_px, ink::kPlot.with_opacity(0.6), ink::kEnded);
    canvas.cross(pose.position(), kEndedHead_px / 2, ink::kEnded, 1);
  }
}

/// Numbers beside the few hypotheses that matter.
void draw_probabilities(DrawingCanvas& canvas, const DrawingScene& scene) {
  constexpr std::size_t kMost = 6;
  constexpr double kLeast = 0.01, kText_px = 11;
  if (scene.hypotheses.size() < 2) return;
  for (std::size_t k = 0; k < std::min(kMost, scene.hypotheses.size()); ++k) {
    const auto& hypothesis = scene.hypotheses[k];
    if (!(hypothesis.probability >= kLeast) || !hypothesis.T_map_base.position().allFinite()) continue;
    const Point at_px = canvas.frame().to_page(hypothesis.T_map_base.position());
    canvas.text(at_px + Point(kBestHead_px / 2 + 3, -5), percent(hypothesis.probability), kText_px, ink::kText, k == 0);
  }
}

void draw_hypotheses(DrawingCanvas& canvas, const DrawingScene& scene) {
  for (std::size_t k = scene.hypotheses.size(); k-- > 0;) {
    const auto& hypothesis = scene.hypotheses[k];
    if (k == 0)
      canvas.arrow_head(hypothesis.T_map_base, kBestHead_px, ink::kBest, ink::kPlot);
    else
      canvas.arrow_head(hypothesis.T_map_base, alternative_head_px(hypothesis.probability),
                        alternative_color(hypothesis.probability), ink::kPlot.with_opacity(0.8));
  }
}

}  // namespace

std::map<std::string, TypeInk> inks_of_types(const SemanticMap& map) {
  std::map<std::string, TypeInk> inks;
  for (const MapFeature& feature : map.features()) {
    const GeometryKind kind = kind_of(feature.geometry);
    TypeInk& type_ink = inks.try_emplace(type_of(map, feature), TypeInk{{}, 0, kind}).first->second;
    if (kind == GeometryKind::segment) type_ink.shape = kind;  // a wall's corners are not what it looks like
  }
  for (const MapObject& object : map.objects())
    if (!object.features.empty()) ++inks.at(object.type).objects;
  std::size_t others = 0;
  for (auto& [type, type_ink] : inks) type_ink.color = color_of(type, others++);
  return inks;
}

double alternative_head_px(double probability) { return 9 + 6 * std::sqrt(std::clamp(probability, 0.0, 1.0)); }

Stroke stroke_of(DrawingScene::Perception perception) {
  if (perception == DrawingScene::Perception::candidate) return {ink::kLocalFeature.with_opacity(0.45), 1.1};
  if (perception == DrawingScene::Perception::matched) return {ink::kAssociation, kLocalFeature_px};
  return {ink::kLocalFeature.with_opacity(0.8), kLocalFeature_px};
}

std::string percent(double probability) {
  const double value = 100 * probability;
  return value > 99 && value < 100 ? "> 99 %" : std::to_string(std::lround(value)) + " %";
}

Color alternative_color(double probability) {
  return ink::kAlternative.with_opacity(0.3 + 0.7 * std::sqrt(std::clamp(probability, 0.0, 1.0)));
}

void draw_place(DrawingCanvas& canvas, const Point& center_px) {
  constexpr double kRing_px = 6, kCross_px = 4;
  canvas.page_disc(center_px, kRing_px, ink::kPlot.with_opacity(0.6), ink::kPlace);
  for (const double side : {-kCross_px, kCross_px})
    canvas.page_line(center_px + Point(-kCross_px, side), center_px + Point(kCross_px, -side), ink::kPlace, 1.4);
}

/// Where the estimate jumps nobody has driven.
void draw_trajectory(DrawingCanvas& canvas, std::span<const Point> trajectory) {
  constexpr double kJump_m = 2;  // farther than a robot drives from one scan to the next
  std::size_t begin = 0;
  for (std::size_t k = 1; k <= trajectory.size(); ++k) {
    if (k < trajectory.size() && !((trajectory[k] - trajectory[k - 1]).norm() > kJump_m)) continue;
    canvas.line(trajectory.subspan(begin, k - begin), ink::kTrajectory, kTrajectory_px);
    begin = k;
  }
}

void draw_layers(DrawingCanvas& canvas, const DrawingScene& scene) {
  canvas.clip_to_plot();
  draw_floor(canvas, scene);
  draw_grid(canvas, scene.coordinates);
  if (!scene.free_space.empty()) canvas.polygon(scene.free_space, ink::kFreeSpace);
  draw_associations(canvas, scene);
  if (scene.map) draw_map(canvas, *scene.map);
  draw_unmapped(canvas, scene);
  canvas.line(scene.truth, ink::kTruth, kTruth_px, kDash_px);
  draw_trajectory(canvas, scene.trajectory);
  draw_local_features(canvas, scene);
  draw_patterns(canvas, scene);
  draw_association_lines(canvas, scene);
  for (const auto& line : scene.contradictions) canvas.line(line, ink::kContradiction, kContradiction_px, kDash_px);
  canvas.dots(scene.scan_points, ink::kScan, kScanDot_px);
  draw_ended(canvas, scene);
  draw_hypotheses(canvas, scene);
  draw_probabilities(canvas, scene);
  if (scene.map) draw_storeys(canvas, *scene.map);
  for (const auto& place : scene.places)
    if (place.position.allFinite()) draw_place(canvas, canvas.frame().to_page(place.position));
  canvas.unclip();
}

}  // namespace opal
