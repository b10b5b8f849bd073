#include "quiet_detector.hpp"

extern "C" void opal_test_function_that_nobody_defines();

namespace {

void register_types(opal::Registrar& registrar) {
  opal_test_function_that_nobody_defines();
  registrar.add({"bad:undefined_symbol", {}, {"bad:Thing"}}, make_quiet_detector);
}

}  // namespace

OPAL_PLUGIN("undefined_symbol", "1.2.3", register_types)
