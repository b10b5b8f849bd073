#pragma once

#include "python_object.hpp"

#include <opal/plugin/self_describing.hpp>
#include <opal/sensing/feature_detector.hpp>

/// A detector that is a class of Python: `detect(self, scan)` gives a list of opal.Feature.
class PythonDetector final : public opal::FeatureDetector, public opal::SelfDescribing {
 public:
  explicit PythonDetector(const nlohmann::json& options) : object_(options, "detect") {}
  std::vector<opal::Feature> detect(const opal::Scan& scan) const override;
  opal::TypeInfo type_info() const override { return object_.type_info(); }

 private:
  PythonObject object_;
};
