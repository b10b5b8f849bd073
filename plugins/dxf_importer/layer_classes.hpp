#pragma once

#include <opal/import_kit/class_rules.hpp>

#include <map>
#include <optional>
#include <string>

namespace opal::dxf_importer {

/// What layers become unless a deployment says otherwise, as ClassRules has it.
std::map<std::string, std::string> classes_of_layers();

/// What layers become: first as a deployment says; then symbols, axes, furniture and what is to be demolished stay out,
/// whatever they are drawn beside; then as classes_of_layers() says. Words beside a code say more than the code.
class LayerClasses {
 public:
  /// @param given  the option `classes`.
  explicit LayerClasses(const nlohmann::json& given) : given_(given, {}), built_in_({}, classes_of_layers()) {}

  /// An object type, ClassRules::kLeaveOut, or nothing if no rule fits.
  std::optional<std::string> class_of(const std::string& layer) const;

 private:
  ClassRules given_, built_in_;
};

}  // namespace opal::dxf_importer
