// As if built with wider vector instructions than the framework.
#include "quiet_detector.hpp"

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add({"bad:wrong_alignment", {}, {"bad:Thing"}}, make_quiet_detector);
}

const opal::PluginDescriptor opal_descriptor_{opal::kAbiTag, 2 * EIGEN_MAX_ALIGN_BYTES, "wrong_alignment", "1.2.3",
                                              register_types};
}  // namespace

BOOST_DLL_ALIAS_SECTIONED(opal_descriptor_, opal_plugin_v1, opal_v1)
