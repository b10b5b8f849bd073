// A plugin that does what it says; the descriptions it is tested with say other things.
#include "quiet_detector.hpp"

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add({"bad:other_description", {}, {"bad:Thing"}}, make_quiet_detector);
}

}  // namespace

OPAL_PLUGIN("other_description", "1.2.3", register_types)
