#include "quiet_detector.hpp"

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add({"bad:returns_null", {}, {"bad:Thing"}},
                [](const nlohmann::json&) { return std::unique_ptr<opal::FeatureDetector>(); });
}

}  // namespace

OPAL_PLUGIN("returns_null", "1.2.3", register_types)
