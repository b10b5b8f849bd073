#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add({"bad:no_factory", {}, {"bad:Thing"}}, opal::Factory<opal::FeatureDetector>());
}

}  // namespace

OPAL_PLUGIN("no_factory", "1.2.3", register_types)
