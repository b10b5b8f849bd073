#pragma once

#include "area_walls.hpp"
#include "feature_classes.hpp"
#include "massive_walls.hpp"
#include "openings.hpp"

#include <opal/import_kit/class_tally.hpp>
#include <opal/import_kit/plan_import.hpp>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace opal::geojson_importer {

/// Lengths and names that decide what becomes of features.
struct ElementOptions {
  std::string radius_property;     ///< makes a round column of a point
  double circle_tolerance_m = 0;   ///< of a polygon that was drawn as a circle
  double max_column_radius_m = 0;  ///< larger circles stay polygons
  double door_width_m = 0;         ///< of a door that is a point without a width
};

/// Makes elements of a plan of features, one after the other; the walls around areas come at the end, when all openings
/// in them are known.
class PlanElements {
 public:
  /// @param source  stands for the file in messages.
  PlanElements(std::string source, const PlanImportOptions& plan, const ElementOptions& options)
      : source_(std::move(source)), plan_(plan), options_(options) {}

  /// @throws MapError if the feature is damaged and something should become of it.
  void add(const Feature& feature, const FeatureClasses& classes);
  /// Puts a feature into the report that nothing becomes of.
  void leave_out(const Feature& feature, const FeatureClasses& classes, const std::string& why, ImportStatus status);
  /// Puts walls around areas, cuts openings into walls, and doors into these.
  void finish();

  /// About areas and openings, for the report.
  std::vector<std::string> sentences() const;

  std::vector<PlanElement> elements;
  std::vector<ImportedElement> things;
  std::vector<std::string> names;  ///< of all classes that were seen
  ClassTally tally{"class"};
  int refitted = 0;  ///< circles that were drawn as polygons

 private:
  /// Lines are compared with each other before the plan is assembled, which would refuse them, too.
  void expect_near(const Feature& feature) const;
  std::string use(const Feature& feature, const std::string& type);
  std::string use_area(const Feature& feature, Area::Kind kind);
  std::string use_opening(const Feature& feature, const std::string& type);
  std::optional<double> radius_of(const Feature& feature) const;
  void add_polygon(const std::vector<Ring>& polygon, int solid, PlanElement& element);
  std::vector<AreaWall> thin_walls() const;
  void put_back(const std::vector<AreaWall>& walls);
  /// Of a wall that is drawn as lines; what is no thickness of a wall is told, and the wall stays thin.
  void note_width(const Feature& feature);
  /// Gives walls that were drawn as lines the thickness that they say.
  void widen();
  void put_in_doors(const std::vector<std::optional<Segment>>& places);
  /// Doors that lie in massive walls, out of which nothing is cut.
  void find_closed(const std::vector<std::optional<Segment>>& places);
  void report_opening(const Opening& opening, bool is_in_wall);

  std::string source_;
  const PlanImportOptions& plan_;
  ElementOptions options_;
  std::vector<Area> areas_;
  std::vector<std::size_t> element_of_area_;
  std::vector<Opening> openings_;
  std::vector<std::string> type_of_opening_;
  std::size_t area_edges_ = 0;
  int cut_ = 0, wall_less_ = 0, in_massive_ = 0;
  std::map<std::string, std::string> closed_;  ///< ids of doors, and of the massive walls that close them
  std::map<std::size_t, double> width_m_;      ///< of elements that are walls, drawn as lines
  std::vector<std::string> odd_widths_;        ///< ids of walls whose width is none
  std::vector<std::string> ringed_;            ///< ids of walls that were drawn as closed lines around rooms
};

}  // namespace opal::geojson_importer
