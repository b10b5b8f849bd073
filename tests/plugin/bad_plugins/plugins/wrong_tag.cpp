#include "quiet_detector.hpp"

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add({"bad:wrong_tag", {}, {"bad:Thing"}}, make_quiet_detector);
}

const opal::PluginDescriptor opal_descriptor_{"api=1 gxx_abi=1002", EIGEN_MAX_ALIGN_BYTES, "wrong_tag", "1.2.3",
                                              register_types};
}  // namespace

BOOST_DLL_ALIAS_SECTIONED(opal_descriptor_, opal_plugin_v1, opal_v1)
