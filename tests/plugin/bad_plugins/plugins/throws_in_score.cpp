#include <opal/plugin/plugin.hpp>

#include <stdexcept>

namespace {

class ThrowingScorer final : public opal::HypothesisScorer {
 public:
  opal::Score score(const opal::Hypothesis&, const opal::Observation&, const opal::MapView&,
                    const opal::ScorerMemory*) const override {
    throw std::runtime_error("this scorer fails on every hypothesis");
  }
};

void register_types(opal::Registrar& registrar) {
  registrar.add({"bad:throws_in_score", {}, {}},
                [](const nlohmann::json&) { return std::make_unique<ThrowingScorer>(); });
}

}  // namespace

OPAL_PLUGIN("throws_in_score", "1.2.3", register_types)
