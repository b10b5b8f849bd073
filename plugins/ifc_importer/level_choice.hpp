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

/// @throws MapError if there is no such storey, or nothing says where to cut.
LevelChoice choose_level(const Building& building, const Classes& classes, const ImportOptions& options,
                         const std::string& file);

/// How many things of each class the plane at a height meets.
std::map<std::string, int> counts_at(const Building& building, double height_m);

}  // namespace opal::ifc_importer
