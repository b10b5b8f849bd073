#pragma once

#include <opal/map/semantic_map.hpp>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace opal {

/// What a picture shows. Everything is in the `map` frame; what is empty is not drawn and not in the legend.
struct DrawingScene {
  std::string title;
  std::vector<std::string> notes;  ///< sentences below the legend, of any length

  std::shared_ptr<const SemanticMap> map;   ///< objects are coloured by type
  std::vector<std::array<Point, 2>> floor;  ///< where a robot can be: rectangles (corners min, max)
  bool coordinates = false;                 ///< a grid of metres, where there is room for it, with its coordinates
  std::vector<Geometry> unmapped;           ///< what stands there besides
  std::string unmapped_words = "stands there, not in the map";  ///< in the legend
  std::vector<Point> scan_points;
  std::vector<Point> free_space;  ///< outline of what the laser sees to be empty, in order

  /// What has been perceived: seen too little yet, seen often enough, associated with a mapped feature.
  enum class Perception { candidate, stable, matched };
  struct DrawnLocalFeature {
    Geometry geometry;
    Perception perception = Perception::stable;
  };
  std::vector<DrawnLocalFeature> local_features;
  std::string matched_words = "local feature, associated";  ///< in the legend: what is drawn as matched
  std::vector<std::vector<Point>> patterns;                 ///< places of the local features that make a pattern, each

  struct DrawnHypothesis {
    Pose2 T_map_base;
    double probability = 0;
  };
  std::vector<DrawnHypothesis> hypotheses;  ///< most probable first; the first is the best
  std::vector<Pose2> ended;                 ///< poses of hypotheses that did not survive

  struct DrawnAssociation {
    Geometry local;
    Geometry mapped;
  };
  std::vector<DrawnAssociation> associations;

  /// Where something speaks against the best hypothesis: a beam that passes through a wall.
  std::vector<std::array<Point, 2>> contradictions;
  std::string contradiction_words = "speaks against it";  ///< in the legend: what is drawn as a contradiction

  /// A place with a word for the legend: "goal".
  struct DrawnPlace {
    Point position;
    std::string label;
  };
  std::vector<DrawnPlace> places;

  std::vector<Point> trajectory;  ///< as estimated
  std::vector<Point> truth;       ///< as recorded by other means

  /// Corners (min, max) of what is shown [m]; if absent, all of map, trajectories and hypotheses (all points,
  /// if there are none of these).
  std::optional<std::array<Point, 2>> view;
};

/// Both show the same picture. @throws Error naming the file if it cannot be written.
OPAL_EXPORT void write_svg(const DrawingScene& scene, const std::string& path);
OPAL_EXPORT void write_png(const DrawingScene& scene, const std::string& path);

}  // namespace opal
