#pragma once

#include <opal/plugin/plugin.hpp>

#include <memory>

namespace {

/// Finds nothing: what a plugin offers that is bad in other ways.
class QuietDetector : public opal::FeatureDetector {
 public:
  std::vector<opal::Feature> detect(const opal::Scan&) const override { return {}; }
};

[[maybe_unused]] std::unique_ptr<opal::FeatureDetector> make_quiet_detector(const nlohmann::json&) {
  return std::make_unique<QuietDetector>();
}

}  // namespace
