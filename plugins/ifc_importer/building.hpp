#pragma once

#include <opal/map/semantic_map.hpp>

#include <Eigen/Geometry>

#include <optional>
#include <string>
#include <vector>

namespace opal::ifc_importer {

using Point3 = Eigen::Vector3d;
using Transform3 = Eigen::Affine3d;

/// A planar face: an outer loop and perhaps holes; each loop closes itself.
using FaceLoops = std::vector<std::vector<Point3>>;
using Shell = std::vector<FaceLoops>;

/// A solid, in the building's coordinates [m], as the model describes it: no operand has been applied yet, since
/// cutting operands first and combining their flat cuts is exact where combining solids is not.
struct Body {
  enum class Kind { shells, half_space, unite, intersect, subtract };
  Kind kind = Kind::shells;
  std::vector<Shell> shells = {};   ///< closed each for itself or all together
  Point3 point = Point3::Zero();    ///< half_space: on its plane
  Point3 outward = Point3::Zero();  ///< half_space: away from its material
  std::vector<Body> operands = {};
};

struct Opening {
  std::string id;
  std::vector<Body> bodies;
};

struct Material {
  std::string name;        ///< in lower case; may be empty
  double thickness_m = 0;  ///< of a layer; 0: it is none
};

/// One thing of the model that has or should have a shape.
struct Element {
  std::string id;                    ///< GlobalId
  std::vector<std::string> classes;  ///< "IfcWallStandardCase", then what that is a kind of: "IfcWall", ...
  std::string name;
  std::string storey;                 ///< name of the level that holds it; may be empty
  std::string whole;                  ///< GlobalId of what it is a part of; may be empty
  std::string fills;                  ///< GlobalId of the opening that it fills; may be empty
  std::vector<std::string> words;     ///< its name and those of its type, in lower case: what they say about glass
  std::vector<Material> materials;    ///< in the order of its layers, if these are layers
  std::optional<double> thickness_m;  ///< of its material layers
  std::optional<Segment> axis;
  Point along = Point::UnitX();  ///< its own x axis, seen from above: a door's width runs along it
  std::vector<Body> bodies;
  std::vector<Opening> openings;
  std::vector<std::string> troubles;  ///< what of its geometry could not be read, and why

  const std::string& source_class() const { return classes.front(); }
  bool is_a(const std::string& name_of_class) const;
};

struct Level {
  std::string id, name;
  double elevation_m = 0;
};

struct Building {
  std::string schema;
  double unit_m = 1;  ///< length of the model's unit
  std::string unit_name;
  std::vector<Level> levels;         ///< from the lowest
  std::vector<Element> elements;     ///< in order of id
  std::vector<std::string> notes;    ///< sentences about the whole model
  std::optional<Point> first_far_m;  ///< the first point that was refused since it lies beyond 1000 km
  std::optional<double> north_rad;   ///< heading of true north in the model's coordinates
  std::optional<Georeference> georeference;
};

}  // namespace opal::ifc_importer
