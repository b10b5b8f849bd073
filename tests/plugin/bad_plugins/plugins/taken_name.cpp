// Offers a type of its own, and one that another plugin offers too.
#include "quiet_detector.hpp"

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add({"bad:taken_name", {}, {"bad:Thing"}}, make_quiet_detector);
  registrar.add({"bad:good", {}, {"bad:Thing"}}, make_quiet_detector);
}

}  // namespace

OPAL_PLUGIN("taken_name", "1.2.3", register_types)
