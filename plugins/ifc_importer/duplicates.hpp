#pragma once

#include "storey_cut.hpp"

#include <map>
#include <string>
#include <vector>

namespace opal::ifc_importer {

/// Things of one kind at the same place, to the millimetre.
struct Duplicates {
  std::map<std::string, std::string> kept;              ///< id of the first of them, by id of each other
  std::map<std::string, std::vector<std::string>> ids;  ///< the others, by id of the first
};

/// Parts of one thing are no duplicates of each other's wholes; glass and doors count as solids do.
Duplicates find_duplicates(const std::vector<ElementCut>& cuts);

}  // namespace opal::ifc_importer
