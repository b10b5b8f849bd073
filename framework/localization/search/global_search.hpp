#pragma once

#include "localization/scoring/scorer_ensemble.hpp"
#include "localization/search/candidate_generation.hpp"

#include <opal/common/stage_times.hpp>
#include <opal/sensing/pose_hint.hpp>
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

/// Where patterns with a free parameter are looked up, too. They have many candidates each.
enum class UnderConstrained {
  never,
  nothing_else,  ///< where no pattern is seen that fixes the pose: otherwise the map would not be searched at all
  nothing_good   ///< where those that fix the pose find nothing good, too
};

/// Looks for places where the robot may be, over the whole map and without any pose: candidates by patterns, then
/// verified by the newest scan, coarse to fine. A large map has more places than there is time for between two scans:
/// a search goes on over as many scans as it takes.
class OPAL_EXPORT GlobalSearch {
 public:
  GlobalSearch(std::shared_ptr<const MapView> map, std::vector<Named<PatternTemplate>> templates,
               const ScorerEnsemble& ensemble, const SearchOptions& options)
      : map_(map), ensemble_(ensemble), options_(options), generator_(std::move(map), std::move(templates), options) {}

  /// The newest scans.
  struct Scene {
    const Sample& sample;            ///< as they are
    const Observation& observation;  ///< of them
    bool keep_rejected = false;      ///< somebody wants to know
  };
  struct Result {
    std::vector<VerifiedCandidate> candidates;  ///< best first, one per place
    std::vector<CandidateGenerator::LookedUp> looked_up;
    std::size_t places = 0;  ///< that passed the first filter
    struct Rejected {
      VerifiedCandidate candidate;
      std::string reason;
    };
    std::vector<Rejected> rejected;
  };

  /// A search that has begun.
  class Ongoing;
  /// What is looked for is what these scans show.
  /// @param under_constrained  where patterns with a free parameter are looked up, too.
  /// @param times  generate_s grows.
  Ongoing begin(const Scene& scene, UnderConstrained under_constrained, StageTimes& times) const;
  /// Looks at as many places as there is time for at a scan.
  /// @param scene  the newest scans, by which candidates are verified; poses are the robot's there.
  /// @param times  generate_s and search_s grow.
  /// @return what was found, once all places have been looked at; nothing before.
  std::optional<Result> go_on(Ongoing& search, const Scene& scene, StageTimes& times) const;
  /// Places about a hint, at once.
  /// @param times  generate_s and search_s grow.
  Result look_near(const PoseHint& hint, const Scene& scene, StageTimes& times) const;

  /// A scan with fewer points tells no place.
  static constexpr std::size_t kFewestPoints = 15;

  /// @param pattern  of a candidate that comes from one.
  const std::string& pattern_name(TemplateNumber pattern) const { return generator_.pattern_name(pattern); }

 private:
  std::vector<SearchFeature> features_for(const Observation& seen) const;
  bool look_up(Ongoing& search) const;
  /// The patterns with a free parameter, where those that fix the pose found nothing good.
  bool ask_more(Ongoing& search, StageTimes& times) const;
  std::vector<Candidate> propose(Ongoing& search, const Scene& scene) const;
  void add_verified(std::vector<Candidate> candidates, const Scene& scene, Result& result) const;
  /// One candidate per place, and what is above and below them.
  Result finished(Result result, const Scene& scene) const;
  std::vector<Candidate> candidates_near(const PoseHint& hint, std::span<const Point> coarse) const;
  std::vector<Candidate> above_and_below_best(const std::vector<VerifiedCandidate>& found) const;
  std::vector<VerifiedCandidate> verified(std::vector<Candidate> candidates, const Scene& scene, Result& result) const;
  static Observation with_few_points(const Scene& scene);
  Hypothesis aligned(Candidate& candidate, const Observation& observation, double sigma_m) const;
  void keep_best(std::vector<VerifiedCandidate>& candidates, const Scene& scene, Result& result) const;

  std::shared_ptr<const MapView> map_;
  const ScorerEnsemble& ensemble_;
  SearchOptions options_;
  CandidateGenerator generator_;
};

class GlobalSearch::Ongoing {
  friend GlobalSearch;
  Ongoing(CandidateGenerator::Inquiry first) : inquiry(std::move(first)) {}

  Pose2 T_local_base;                   ///< where it began
  std::vector<SearchFeature> features;  ///< base_link frame, there
  std::vector<Point> coarse;            ///< points, base_link frame, there
  CandidateGenerator::Inquiry inquiry;
  bool may_ask_more = false;  ///< for patterns with a free parameter, after this inquiry
  Result result;              ///< of inquiries before
};

}  // namespace opal
