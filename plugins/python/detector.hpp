#pragma once

#include "python_object.hpp"

#include <opal/plugin/self_describing.hpp>
#include <opal/sensing/feature_detector.hpp>

namespace opal::python_classes {

/// A detector that is a class of Python: `detect(self, scan)` gives a list of opal.Feature.
class PythonDetector final : public FeatureDetector, public SelfDescribing {
 public:
  explicit PythonDetector(const nlohmann::json& options) : object_(options, "detect") {}
  std::vector<Feature> detect(const Scan& scan) const override;
  TypeInfo type_info() const override { return object_.type_info(); }

 private:
  PythonObject object_;
};

}  // namespace opal::python_classes
