#include "quiet_detector.hpp"

#include <stdexcept>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add({"bad:throws_in_registration", {}, {"bad:Thing"}}, make_quiet_detector);
  throw std::runtime_error("no licence found");
}

}  // namespace

OPAL_PLUGIN("throws_in_registration", "1.2.3", register_types)
