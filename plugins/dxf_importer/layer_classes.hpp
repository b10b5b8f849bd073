#pragma once

#include <map>
#include <string>

namespace opal::dxf_importer {

/// What layers become unless a deployment says otherwise, as ClassRules has it.
std::map<std::string, std::string> classes_of_layers();

}  // namespace opal::dxf_importer
