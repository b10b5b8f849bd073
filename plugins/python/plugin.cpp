#include "detector.hpp"
#include "pattern.hpp"
#include "scorer.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add<opal::python_classes::PythonDetector>(
      {.name = "opal:PythonDetector", .produces = {"opal:FoundByPython"}});
  registrar.add<opal::python_classes::PythonPattern>({.name = "opal:PythonPattern"});
  registrar.add<opal::python_classes::PythonScorer>({.name = "opal:PythonScorer"});
}

}  // namespace

OPAL_PLUGIN("python", "0.1.0", register_types)
