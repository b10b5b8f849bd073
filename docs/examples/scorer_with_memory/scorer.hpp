#pragma once

#include <opal/localization/scoring/hypothesis_scorer.hpp>

#include <nlohmann/json.hpp>

#include <map>

/// By mapped object: the returns that ended on it, 1 for all returns of one scan. Only objects that were seen are in
/// it, so that a copy is cheap.
struct SeenObjects final : opal::ScorerMemory {
  std::unique_ptr<opal::ScorerMemory> copy() const override { return std::make_unique<SeenObjects>(*this); }
  std::map<opal::MapObjectNumber, double> scans;
};

/// A likelihood field of objects that pays for what is new. A wrong place often has one wall that fits, and sees it
/// again in every scan. The right place meets one fitting object after the other.
class NewObjectsScorer final : public opal::HypothesisScorer {
 public:
  explicit NewObjectsScorer(const nlohmann::json& options);
  std::unique_ptr<opal::ScorerMemory> new_memory(const opal::MapView& map) const override;
  opal::Score score(const opal::Hypothesis& hypothesis, const opal::Observation& observation, const opal::MapView& map,
                    const opal::ScorerMemory* memory) const override;
  void remember(opal::ScorerMemory& memory, const opal::ScorerMemory& seen, double weight) const override;
  void fade(opal::ScorerMemory& memory, double weight) const override;
  bool judges_associations() const override { return false; }

 private:
  /// The objects that one scan shows if the hypothesis is right.
  SeenObjects seen_now(const opal::Hypothesis& hypothesis, const opal::Observation& observation,
                       const opal::MapView& map) const;
  /// Evidence of a whole scan of returns on this object.
  double worth_nat(opal::MapObjectNumber object, const SeenObjects& before) const;

  double new_nat_, known_nat_, astray_nat_, sigma_m_, enough_scans_, forget_;
};
