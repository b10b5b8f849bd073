#pragma once

#include "drawing/drawing_canvas.hpp"

#include "drawing/drawing.hpp"

#include <map>
#include <string>

namespace opal {

/// The colours of a picture: ink on light paper, one hue per meaning.
namespace ink {
inline constexpr Color kPaper{0.985, 0.982, 0.972};
inline constexpr Color kPlot{1, 1, 1};
inline constexpr Color kText{0.16, 0.18, 0.22};
inline constexpr Color kFaintText{0.42, 0.45, 0.50};
inline constexpr Color kGrid{0.90, 0.91, 0.92};
inline constexpr Color kFloor{0.84, 0.93, 0.84};
inline constexpr Color kFreeSpace{0.36, 0.66, 0.93, 0.13};
inline constexpr Color kScan{0.88, 0.26, 0.16, 0.85};
inline constexpr Color kUnmapped{0.72, 0.55, 0.38};
inline constexpr Color kLocalFeature{0.10, 0.42, 0.82};
inline constexpr Color kAssociation{0.05, 0.62, 0.38};
inline constexpr Color kBest{0.02, 0.50, 0.30};
inline constexpr Color kAlternative{0.93, 0.55, 0.08};
inline constexpr Color kEnded{0.45, 0.47, 0.52};
inline constexpr Color kContradiction{0.78, 0.10, 0.10};
inline constexpr Color kPattern{0.62, 0.12, 0.52};
inline constexpr Color kPlace{0.80, 0.05, 0.30};
inline constexpr Color kTrajectory{0.48, 0.23, 0.68};
inline constexpr Color kTruth{0.16, 0.18, 0.22, 0.75};
}  // namespace ink

inline constexpr double kScanDot_px = 1.3, kLocalFeature_px = 2.2, kUnmapped_px = 1.4, kAssociation_px = 1.2,
                        kMatched_px = 7;
inline constexpr double kTrajectory_px = 1.6, kTruth_px = 1.1, kDash_px = 4, kBestHead_px = 17;
inline constexpr double kEndedHead_px = 10, kContradiction_px = 1.3, kPattern_px = 1.1;

/// One colour per object type of a map, and how many objects have it.
struct TypeInk {
  Color color;
  int objects = 0;
  GeometryKind shape = GeometryKind::segment;  ///< of its features
};
std::map<std::string, TypeInk> inks_of_types(const SemanticMap& map);

/// Size of an alternative's arrow head, and how opaque it is: the more probable, the more.
double alternative_head_px(double probability);
Color alternative_color(double probability);

/// The side of a face that cannot be seen is shaded.
inline constexpr double kBodyOpacity = 0.16;
/// A place that is named: a cross in a ring.
void draw_place(DrawingCanvas& canvas, const Point& center_px);

/// How a local feature looks.
struct Stroke {
  Color color;
  double width_px = 0;
};
Stroke stroke_of(DrawingScene::Perception perception);

/// "98 %"
std::string percent(double probability);

void draw_layers(DrawingCanvas& canvas, const DrawingScene& scene);
/// Legend and notes in a column that starts here.
void draw_legend(DrawingCanvas& canvas, const DrawingScene& scene, const Point& corner_px);
/// Below the plot.
void draw_scale_bar(DrawingCanvas& canvas);
double legend_width_px(DrawingCanvas& canvas, const DrawingScene& scene);
double legend_height_px(DrawingCanvas& canvas, const DrawingScene& scene);

}  // namespace opal
