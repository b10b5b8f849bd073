// A scorer that does on purpose what scorers must not do, in some cells only.
#include <opal/plugin/plugin.hpp>

#include <chrono>
#include <cstdlib>
#include <stdexcept>
#include <thread>
#include <vector>

namespace {

void misbehave(const std::string& how) {
  if (how == "crash") std::abort();
  if (how == "leave") std::_Exit(3);
  if (how == "throw") throw std::runtime_error("not today");
  while (how == "hang") std::this_thread::sleep_for(std::chrono::seconds(1));
  static std::vector<std::vector<char>> eaten;
  while (how == "eat") eaten.emplace_back(10u << 20, 'x');
}

class FaultyScorer final : public opal::HypothesisScorer {
 public:
  explicit FaultyScorer(const nlohmann::json& options) : how_(options.at("how")), after_(options.at("after")) {
    if (after_ == 0) misbehave(how_);
  }
  opal::Score score(const opal::Hypothesis&, const opal::Observation&, const opal::MapView&,
                    const opal::ScorerMemory*) const override {
    if (++asked_ == after_) misbehave(how_);
    return {};
  }

 private:
  std::string how_;
  int after_;
  mutable int asked_ = 0;
};

void register_types(opal::Registrar& registrar) { registrar.add<FaultyScorer>({.name = "faulty:Scorer"}); }

}  // namespace

OPAL_PLUGIN("faulty", "0.0.1", register_types)
