#include "quiet_detector.hpp"

#include <stdexcept>

namespace {

class OwnException : public std::exception {
 public:
  const char* what() const noexcept override { return "an exception of the plugin's own"; }
};

/// Options that are in range, but do not go together, are the ordinary reason for a factory to throw.
std::unique_ptr<opal::FeatureDetector> make(const nlohmann::json& options) {
  if (options.at("count") == 1) throw std::invalid_argument("count 1 does not go with anything");
  if (options.at("count") == 2) throw OwnException();
  if (options.at("count") == 3) throw 3;
  return std::make_unique<QuietDetector>();
}

void register_types(opal::Registrar& registrar) {
  registrar.add({"bad:throws_in_factory", {}, {"bad:Thing"}}, opal::Factory<opal::FeatureDetector>(make));
}

}  // namespace

OPAL_PLUGIN("throws_in_factory", "1.2.3", register_types)
