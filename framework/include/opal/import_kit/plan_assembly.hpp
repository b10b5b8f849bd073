#pragma once

#include <opal/map/semantic_map.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace opal {

/// From which sides a line of a plan is seen.
enum class PlanSides {
  solid,    ///< outline of something massive: from outside
  to_find,  ///< a line that somebody drew: one face of a wall if the other one lies beside it, else a wall of its own
  both      ///< a thin wall
};

/// Straight strokes from point to point.
struct PlanLine {
  std::vector<Point> points;             ///< [m], in order; frame `map`
  bool closed = false;                   ///< the last point is joined to the first, which is not repeated
  PlanSides sides = PlanSides::to_find;  ///< from where it is seen
  int solid = 0;  ///< outlines of one element with the same number are one thing; inside each other: holes
};

/// One element of a drawn plan or of a collection of areas: what becomes one object. In the `map` frame.
struct PlanElement {
  std::string id;                        ///< of the object: unique
  std::string type;                      ///< "opal:Wall"
  std::string sensor = "PlanarLidar2D";  ///< that perceives it; empty: it is kept as drawn and hides nothing
  std::vector<PlanLine> lines = {};      ///< straight strokes of the element
  std::vector<Circle> circles = {};      ///< round columns of the element
};

/// Lengths that decide how strokes become faces.
struct PlanOptions {
  double join_m = 0.01;               ///< points nearer than this are one
  double max_wall_thickness_m = 0.6;  ///< lines side by side that are nearer than this have wall between them
  double min_face_m = 0.05;           ///< shorter faces are left out
  double min_corner_arm_m = 0.1;      ///< both faces of a corner are at least so long
};

/// What became of one element.
struct PlanOutcome {
  /// What may become of an element.
  enum class Status {
    mapped,  ///< it has features
    merged,  ///< its lines run where another element's do, which has the features
    hidden,  ///< it lies inside of walls
    empty    ///< it has nothing that is long enough for a feature
  };
  std::string id;                  ///< of the element
  Status status = Status::mapped;  ///< what became of it
  std::string with;                ///< merged: id of the object whose faces run where its lines do
};

/// How the sides were found, in metres of line, and what was put together.
struct PlanTally {
  double outlines_m = 0;   ///< one-sided: massive on one side by an outline or a round column
  double pairs_m = 0;      ///< one-sided: with the wall's other face beside it, or as the end of such a wall
  double two_sided_m = 0;  ///< seen from both sides, since nothing said which
  double hidden_m = 0;     ///< inside of walls and where things touch: not mapped
  double repeated_m = 0;   ///< drawn more than once, mapped once
  int short_faces = 0;     ///< left out: shorter than min_face_m
  double short_m = 0;      ///< length of these together
  int corners = 0;         ///< added where faces meet at an angle

  /// The same in sentences, in reading order; what does not occur is left out.
  std::vector<std::string> sentences(const PlanOptions& options) const;
};

/// A map made of a plan, and how it came about.
struct PlanAssembly {
  std::shared_ptr<const SemanticMap> map;  ///< the elements that have features, and those kept as drawn
  std::vector<PlanOutcome> outcomes;       ///< one per element, in the order given
  PlanTally tally;                         ///< in metres of line
};

/// Makes a map of the elements of a plan: finds the visible side of every line, cuts lines where they meet, removes
/// what lies inside of walls, joins what is collinear, merges what was drawn twice, and adds corners where faces meet
/// at an angle. Ends nearer than join_m share their Point. Same elements in the same order: same map.
///
/// Massive is what a solid outline says, closed lines that enclose something thin (mean thickness, twice area by
/// perimeter, up to max_wall_thickness_m), and what lies between parallel lines that are near each other and side by
/// side for at least their distance. What lies between two such walls is a niche if it is at least 0.3 m wide and both
/// walls are thinner than that: it is not massive. A line with something massive on one side is a face; on both:
/// hidden; on none: two faces.
///
/// @param source    stands for the file in error messages.
/// @param name      of the map.
/// @param elements  all that the plan holds; ids must differ.
/// @param options   lengths that decide how strokes become faces.
/// @param origin    of the map.
/// @throws MapError naming the source and the element, for coordinates that are no numbers or beyond 1e6 m, and for
/// more than
///   400,000 strokes or 4,000,000 crossings.
PlanAssembly assemble_plan(const std::string& source, const std::string& name, const std::vector<PlanElement>& elements,
                           const PlanOptions& options = {}, const MapOrigin& origin = {});

/// The circle that a closed line was drawn for: at least 12 points, all within `tolerance_m` of it and going around it
/// once without a gap of more than 60 degrees. (An octagon is an octagon.)
std::optional<Circle> circle_drawn_by(const std::vector<Point>& closed_line, double tolerance_m);

/// Points along an arc, both ends included, such that no chord is farther than `tolerance_m` from the arc.
/// @param circle       the arc is a part of its rim.
/// @param from_rad     direction from the centre to where the arc begins.
/// @param sweep_rad    counter-clockwise if positive; at most a full turn.
/// @param tolerance_m  largest distance between chord and arc.
std::vector<Point> arc_points(const Circle& circle, double from_rad, double sweep_rad, double tolerance_m);

}  // namespace opal
