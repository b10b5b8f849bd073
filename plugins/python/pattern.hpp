#pragma once

#include "python_object.hpp"

#include <opal/patterns/pattern_template.hpp>
#include <opal/plugin/self_describing.hpp>

namespace opal::python_classes {

/// A pattern template that is a class of Python: `slots`, `reach_m`, and `match(self, features)`.
class PythonPattern final : public PatternTemplate, public SelfDescribing {
 public:
  explicit PythonPattern(const nlohmann::json& options);
  PatternShape shape() const override { return shape_; }
  std::optional<PatternInstance> match(std::span<const Feature* const> features) const override;
  TypeInfo type_info() const override { return object_.type_info(); }

 private:
  PythonObject object_;
  PatternShape shape_;
};

}  // namespace opal::python_classes
