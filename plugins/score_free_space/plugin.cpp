#include "scorer.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add({"opal:FreeSpace", /*consumes*/ {}, /*produces*/ {}},
                [](const nlohmann::json& options) -> std::unique_ptr<opal::HypothesisScorer> {
                  return std::make_unique<FreeSpaceScorer>(options);
                });
}

}  // namespace

OPAL_PLUGIN("score_free_space", "0.1.0", register_types)
