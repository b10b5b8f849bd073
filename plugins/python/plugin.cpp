#include "detector.hpp"
#include "pattern.hpp"
#include "scorer.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  using Options = nlohmann::json;
  registrar.add({"opal:PythonDetector", /*consumes*/ {}, /*produces*/ {"opal:FoundByPython"}},
                [](const Options& options) -> std::unique_ptr<opal::FeatureDetector> {
                  return std::make_unique<PythonDetector>(options);
                });
  registrar.add({"opal:PythonPattern", /*consumes*/ {}, /*produces*/ {}},
                [](const Options& options) -> std::unique_ptr<opal::PatternTemplate> {
                  return std::make_unique<PythonPattern>(options);
                });
  registrar.add({"opal:PythonScorer", /*consumes*/ {}, /*produces*/ {}},
                [](const Options& options) -> std::unique_ptr<opal::HypothesisScorer> {
                  return std::make_unique<PythonScorer>(options);
                });
}

}  // namespace

OPAL_PLUGIN("python", "0.1.0", register_types)
