#include <opal/plugin/plugin.hpp>

#include <stdexcept>

namespace {

class ThrowingDetector final : public opal::FeatureDetector {
 public:
  explicit ThrowingDetector(const nlohmann::json&) {}
  std::vector<opal::Feature> detect(const opal::Scan&) const override {
    throw std::runtime_error("this detector fails on every scan");
  }
};

void register_types(opal::Registrar& registrar) {
  registrar.add<ThrowingDetector>({.name = "bad:throws_in_detect", .produces = {"bad:Thing"}});
}

}  // namespace

OPAL_PLUGIN("throws_in_detect", "1.2.3", register_types)
