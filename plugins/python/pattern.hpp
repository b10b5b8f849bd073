#pragma once

#include "python_object.hpp"

#include <opal/patterns/pattern_template.hpp>
#include <opal/plugin/self_describing.hpp>

/// A pattern template that is a class of Python: `slots`, `reach_m`, and `match(self, features)`.
class PythonPattern final : public opal::PatternTemplate, public opal::SelfDescribing {
 public:
  explicit PythonPattern(const nlohmann::json& options);
  opal::PatternShape shape() const override { return shape_; }
  std::optional<opal::PatternInstance> match(std::span<const opal::Feature* const> features) const override;
  opal::TypeInfo type_info() const override { return object_.type_info(); }

 private:
  PythonObject object_;
  opal::PatternShape shape_;
};
