#include "detector.hpp"
#include "pattern.hpp"
#include "scorer.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add<PythonDetector>({.name = "opal:PythonDetector", .produces = {"opal:FoundByPython"}});
  registrar.add<PythonPattern>({.name = "opal:PythonPattern"});
  registrar.add<PythonScorer>({.name = "opal:PythonScorer"});
}

}  // namespace

OPAL_PLUGIN("python", "0.1.0", register_types)
