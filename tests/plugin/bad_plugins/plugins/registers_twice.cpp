#include "quiet_detector.hpp"

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add({"bad:registers_twice", {}, {"bad:Thing"}}, make_quiet_detector);
  registrar.add({"bad:registers_twice", {}, {"bad:Thing"}}, make_quiet_detector);
}

}  // namespace

OPAL_PLUGIN("registers_twice", "1.2.3", register_types)
