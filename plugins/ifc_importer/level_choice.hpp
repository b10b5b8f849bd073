#pragma once

#include "building.hpp"
#include "classes.hpp"
#include "import_options.hpp"

namespace opal::ifc_importer {

/// Where to cut.
struct LevelChoice {
  double height_m = 0;
  std::string storey;    ///< name of the level; empty if the height was given and lies below all levels
  std::string sentence;  ///< how it was chosen
};

/// A model without storeys is cut above its lowest wall, unless a height is given.
/// @throws MapError if there is no such storey, or nothing says where to cut.
LevelChoice choose_level(const Building& building, const Classes& classes, const ImportOptions& options,
                         const std::string& file);

/// "; there: 4 IfcBuildingElementProxy, left out (--set classes.IfcBuildingElementProxy=opal:Wall puts them in)" of the
/// things that the plane at a height meets and that their classes leave out; without a height, of all that have a body.
/// Empty if there are none.
std::string left_out_at(const Building& building, const Classes& classes, std::optional<double> height_m);

/// How many things of each class the plane at a height meets.
std::map<std::string, int> counts_at(const Building& building, double height_m);

}  // namespace opal::ifc_importer
