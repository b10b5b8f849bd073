#pragma once

#include "building.hpp"

#include <map>
#include <string>

namespace opal::ifc_importer {

/// What becomes of a thing.
struct Treatment {
  enum class Kind {
    solid,    ///< a LiDAR sees it
    filling,  ///< door, window: what is wide of it is movable or glass, the rest a frame
    glass,    ///< it is there, and no LiDAR sees it
    left_out,
  };
  Kind kind = Kind::left_out;
  std::string type;    ///< of the map's object: "opal:Wall"
  std::string reason;  ///< why it is left out, or not seen
};

/// How things of each class are treated: as walls are, or doors; left out if they are movable or nothing is known about
/// them; or as a deployment wants it.
class Classes {
 public:
  /// @param overrides  {"IfcFurniture": "opal:Furniture", "IfcStair": "leave_out", "IfcPlate": "glass"}: by the thing's
  /// class, or what that is a kind of. @throws MapError for a class that is not known or a word that says nothing.
  explicit Classes(const std::map<std::string, std::string>& overrides);

  Treatment of(const Element& element) const;

 private:
  std::map<std::string, Treatment> by_class_;
  std::map<std::string, Treatment> overrides_;
};

}  // namespace opal::ifc_importer
