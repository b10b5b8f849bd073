#include "building.hpp"

#include <algorithm>

namespace opal::ifc_importer {

bool Element::is_a(const std::string& name_of_class) const {
  return std::find(classes.begin(), classes.end(), name_of_class) != classes.end();
}

}  // namespace opal::ifc_importer
