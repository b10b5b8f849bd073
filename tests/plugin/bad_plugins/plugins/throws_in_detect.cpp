#include <opal/plugin/plugin.hpp>

#include <stdexcept>

namespace {

class ThrowingDetector final : public opal::FeatureDetector {
 public:
  std::vector<opal::Feature> detect(const opal::Scan&) const override {
    throw std::runtime_error("this detector fails on every scan");
  }
};

void register_types(opal::Registrar& registrar) {
  registrar.add({"bad:throws_in_detect", {}, {"bad:Thing"}},
                [](const nlohmann::json&) { return std::make_unique<ThrowingDetector>(); });
}

}  // namespace

OPAL_PLUGIN("throws_in_detect", "1.2.3", register_types)
