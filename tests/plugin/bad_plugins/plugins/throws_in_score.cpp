#include <opal/plugin/plugin.hpp>

#include <stdexcept>

namespace {

class ThrowingScorer final : public opal::HypothesisScorer {
 public:
  explicit ThrowingScorer(const nlohmann::json&) {}
  opal::Score score(const opal::Hypothesis&, const opal::Observation&, const opal::MapView&,
                    const opal::ScorerMemory*) const override {
    throw std::runtime_error("this scorer fails on every hypothesis");
  }
};

void register_types(opal::Registrar& registrar) { registrar.add<ThrowingScorer>({.name = "bad:throws_in_score"}); }

}  // namespace

OPAL_PLUGIN("throws_in_score", "1.2.3", register_types)
