#pragma once

#include "tests/kit/temporary_folder.hpp"

#include <opal/map/map_importer.hpp>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace opal {

/// "#12".
inline std::string ref(int number) { return "#" + std::to_string(number); }

/// A small building, written as an IFC4 file. All lengths in metres; bodies stand from z = 0 to 3 m.
class DrawnBuilding {
 public:
  /// @param T_world_building  where the building stands; @param unit  "m", "mm" or "ft".
  explicit DrawnBuilding(const Pose2& T_world_building = Pose2(), const std::string& unit = "m");

  /// A box whose middle and heading are given, `length_m` along it. @return number of the instance.
  int add_box(const std::string& type, const std::string& name, const Pose2& pose, double length_m, double width_m,
              const std::string& further_arguments = "$", double height_m = 3);
  int add_wall(const std::string& name, const Pose2& pose, double length_m, double thickness_m);
  /// A wall below the ground, from -depth_m to 0.
  int add_footing(const std::string& name, const Pose2& pose, double length_m, double thickness_m, double depth_m);
  int add_column(const std::string& name, const Point& center, double radius_m);
  /// An opening through a wall with a door in it: two jambs of 5 cm and a leaf.
  void add_door(int wall, const std::string& name, const Pose2& pose, double width_m, double wall_thickness_m);
  /// A thing without a body whose parts have been added before.
  void add_whole(const std::string& type, const std::string& name, const std::vector<int>& parts);
  void add_storey(const std::string& name, double elevation_m);
  /// A thing whose body is this representation item.
  int add_item(const std::string& type, const std::string& name, int item) {
    return add_thing(type, name, shape({item}), "$");
  }
  /// An extrusion of a profile, upwards from z = 0 to 3 m.
  int extruded(int profile, const Pose2& pose = Pose2()) { return extruded(profile, axes(pose), 3); }
  /// Any instance; @return its number.
  int add(const std::string& type, const std::string& arguments);
  /// The geometric context, to which a map conversion refers.
  int context() const { return context_; }

  std::string text(const std::string& schema = "IFC4") const;
  /// GlobalId of a thing by its name.
  static std::string id(const std::string& name);

 private:
  std::string number(double metres) const;
  int point(double x_m, double y_m, double z_m);
  int direction(double x, double y, double z);
  int placement(const Pose2& pose, int relative_to);
  int axes(const Pose2& pose, double z_m = 0);
  int box_solid(const Pose2& pose, double length_m, double width_m, double height_m);
  int extruded(int profile, int position, double height_m);
  int shape(const std::vector<int>& solids);
  int add_thing(const std::string& type, const std::string& name, int shape, const std::string& further_arguments,
                const Pose2& pose = Pose2());

  double unit_m_ = 1;
  std::string lines_;
  int last_ = 0;
  int context_ = 0, site_ = 0;
  std::vector<int> things_;
  std::string storeys_;
};

/// A text in a file of its own, which goes away with this.
struct IfcFile : TemporaryFile {
  explicit IfcFile(const std::string& text) : TemporaryFile("drawn.ifc", text) {}
};

std::shared_ptr<const MapImporter> ifc_importer(const nlohmann::json& options = nlohmann::json::object());
/// With `z_m` 1 unless the options say otherwise.
MapImport import_text(const std::string& text, nlohmann::json options = nlohmann::json::object());
MapImport import(const DrawnBuilding& building, const nlohmann::json& options = nlohmann::json::object());

const ImportedElement& element(const MapImport& imported, const std::string& name);
/// Positions of the features of an object that a sensor perceives, of one kind.
std::vector<const MapFeature*> features_of(const SemanticMap& map, const std::string& name, GeometryKind kind,
                                           bool seen = true);
std::vector<const MapFeature*> all_of(const SemanticMap& map, GeometryKind kind);

}  // namespace opal
