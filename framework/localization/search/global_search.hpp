#pragma once

#include "localization/scoring/scorer_ensemble.hpp"
#include "localization/search/candidate_generation.hpp"

#include <opal/common/stage_times.hpp>
#include <opal/localization/search/pose_hint.hpp>
#include <opal/sensing/sample.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace opal {

/// A candidate that was moved to where the scan fits best there, and judged by it.
struct VerifiedCandidate {
  Candidate candidate;
  double nat = 0;  ///< log-likelihood ratio of the newest scan against clutter
  ScorerEnsemble::Verdict verdict = {};
};

/// Looks for places where the robot may be, over the whole map and without any pose: candidates by patterns, then
/// verified by the newest scan, coarse to fine.
class OPAL_EXPORT GlobalSearch {
 public:
  GlobalSearch(std::shared_ptr<const MapView> map, std::vector<Named<PatternTemplate>> templates,
               const ScorerEnsemble& ensemble, const SearchOptions& options)
      : map_(map), ensemble_(ensemble), options_(options), generator_(std::move(map), std::move(templates), options) {}

  /// What is known beside the scan.
  struct Context {
    const Sample& sample;               ///< the scans as they are
    const Observation& observation;     ///< of these scans
    bool under_constrained;             ///< patterns with a free parameter may be looked up, too
    bool keep_rejected;                 ///< somebody wants to know
    std::optional<PoseHint> hint = {};  ///< look here, too
  };
  struct Result {
    std::vector<VerifiedCandidate> candidates;  ///< best first, one per place
    std::vector<CandidateGenerator::LookedUp> looked_up;
    std::size_t places = 0;    ///< that passed the first filter
    std::size_t expected = 0;  ///< that the index predicted for all that was looked up
    struct Rejected {
      VerifiedCandidate candidate;
      std::string reason;
    };
    std::vector<Rejected> rejected;
  };
  /// @param times  associate_s and verify_s grow.
  Result search(const Context& context, StageTimes& times) const;

  /// A scan with fewer points tells no place.
  static constexpr std::size_t kFewestPoints = 15;

  /// Of a candidate: what proposed it.
  std::string pattern_name(TemplateNumber pattern) const {
    return pattern.exists() ? generator_.pattern_name(pattern) : "hint";
  }

 private:
  std::vector<SearchFeature> features_for(const Context& context) const;
  std::vector<Candidate> candidates_near(const PoseHint& hint, std::span<const Point> coarse) const;
  std::vector<Candidate> above_and_below_best(const std::vector<VerifiedCandidate>& found) const;
  std::vector<VerifiedCandidate> verified(std::vector<Candidate> candidates, const Context& context,
                                          Result& result) const;
  static Observation with_few_points(const Context& context);
  Hypothesis aligned(Candidate& candidate, const Observation& observation, double sigma_m) const;
  void keep_best(std::vector<VerifiedCandidate>& candidates, const Context& context, Result& result) const;

  std::shared_ptr<const MapView> map_;
  const ScorerEnsemble& ensemble_;
  SearchOptions options_;
  CandidateGenerator generator_;
};

}  // namespace opal
