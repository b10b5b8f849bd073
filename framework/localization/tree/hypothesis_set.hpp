#pragma once

#include "localization/scoring/place_comparison.hpp"
#include "localization/scoring/scorer_ensemble.hpp"
#include "localization/search/global_search.hpp"
#include "localization/search/retrospective_verification.hpp"
#include "map/view/feature_index.hpp"

#include "localization/alignment/pose_filter.hpp"
#include "localization/tree/association_tree.hpp"

#include <opal/localization/options/localizer_options.hpp>

#include <functional>
#include <vector>

namespace opal {

/// A hypothesis that is alive: a leaf of the association tree.
struct Live {
  Hypothesis hypothesis;
  NodeId leaf = {};     ///< in the tree; none: it has ended
  double scan_nat = 0;  ///< what the newest scan said
  int updates = 0;      ///< scans judged since it was spawned
  int not_on_map = 0;   ///< associations with nothing, along the branch
  int consecutive_not_on_map = 0;
  KeyframeId kidnapped_after = {};  ///< the robot was kidnapped after this keyframe, if it is right; none: it was not
  double inherited_nat = 0;         ///< part of its evidence that the best hypothesis had gathered by then
  double ridden_nat = 0;            ///< part of its evidence from before a ride: every storey has that
  double compared_nat = 0;          ///< taken off its evidence: another place explains better what tells the two apart
  PoseFilter pose;                  ///< what the scans since it was spawned say about where it is
  std::vector<Score> scores;        ///< of the newest scan, in the ensemble's order
};

/// How a hypothesis began.
struct Beginning {
  Origin origin = Origin::pattern;
  TemplateNumber pattern = {};  ///< the generator's template that it comes from, if it comes from one
  HypothesisId parent = {};     ///< the hypothesis that it branches from, if it does
};

/// Why a hypothesis ended.
struct Ending {
  std::string reason;             ///< in words
  HypothesisId merged_into = {};  ///< the hypothesis that is at the same place, if that is why
};

/// Hears what happens to hypotheses.
class OPAL_EXPORT HypothesisListener {
 public:
  virtual ~HypothesisListener() = default;
  virtual void spawned(const Live& live, const Beginning& beginning) = 0;
  virtual void ended(const Live& live, const Ending& ending) = 0;
  virtual void associated(const Live& live, std::span<const Association> pairs) = 0;
  virtual void dissociated(const Live& live, const std::vector<LocalFeatureId>& local_features,
                           const std::string& reason) = 0;
  /// A branch of `parent` was tried and did not fit.
  virtual void branch_rejected(const Live& parent, const Association& pair, const std::string& reason) = 0;
  /// A candidate of a search did not become a hypothesis.
  virtual void candidate_rejected(const VerifiedCandidate& candidate, const std::string& reason) = 0;
};

/// All hypotheses that are alive, and the tree that they are the leaves of. Best first after every public call.
class OPAL_EXPORT HypothesisSet {
 public:
  HypothesisSet(std::shared_ptr<const MapView> map, const ScorerEnsemble& ensemble, const LocalizerOptions& options,
                HypothesisListener& listener);

  /// Carries every hypothesis to the newest scan, aligns it with the map, and takes the scan's evidence.
  /// @param tempering_weight  how much of a new piece of evidence the scan is, in (0, 1].
  /// @param coarse   a few dozen points for the alignment search.
  /// @param window   half widths of that search (x and y [m], heading [rad]); zero: none.
  void track(const Observation& observation, double tempering_weight, std::span<const Point> coarse,
             const Eigen::Vector2d& window);

  /// Takes candidates that the coarse-to-fine filters let pass as new hypotheses; those at the place of an old one
  /// renew it.
  /// @param tempering_weight  of the scan, as for `track`.
  /// @param retrospective     by which they are verified; it learns where they were before.
  void spawn(std::vector<VerifiedCandidate> candidates, const Observation& observation, double tempering_weight,
             RetrospectiveVerification& retrospective);

  /// Keeps what the newest scan shows, and what the hypotheses are by it, for those that are spawned later.
  /// @param keyframe  of the scan.
  /// @param tempering_weight  of the scan, as for `track`.
  void remember(const Observation& observation, KeyframeId keyframe, double tempering_weight,
                RetrospectiveVerification& retrospective) const;

  /// Algorithm 2: every hypothesis says for each of these local features what it is on the map, or that it is not. The
  /// features that the map's index expects least often go first: they leave fewest branches.
  void grow(const std::vector<const LocalFeature*>& features, const LocalMap& local_map);

  /// Forgets associations whose local feature the local map has forgotten, and those that no longer fit: `grow`
  /// decides on these features anew.
  void forget(const LocalMap& local_map);

  /// Where a robot at a pose may be instead; frame `map`.
  using Elsewhere = std::function<std::vector<Pose2>(const Pose2& T_map_base)>;
  /// The robot may have been carried to a few known places, and odometry did not show it. Each hypothesis that has such
  /// places shares its weight alike with those there, or with new ones. What they have gathered goes along.
  void carry(const Elsewhere& elsewhere, const Pose2& T_local_base);

  /// The best hypothesis is right and the robot was kidnapped: ends those by which it was not. What is left has
  /// gathered nothing before that.
  /// @return what was taken off everybody's evidence [nat].
  double settle();

  void clear();
  const std::vector<Live>& alive() const { return alive_; }
  const AssociationTree& tree() const { return tree_; }

 private:
  std::vector<Association> choices_for(const Live& live, const LocalFeature& feature) const;
  std::vector<const LocalFeature*> rarest_first(std::vector<const LocalFeature*> features) const;
  void branch(const LocalFeature& feature, const LocalMap& local_map);
  /// @return the worst error [m] if an association is an outlier under the new registration, else nothing.
  std::optional<double> register_anew(Live& live, const LocalMap& local_map) const;
  /// Whether a child goes on as its parent, as the first one does, or is a hypothesis of its own.
  enum class Identity { of_parent, own };
  /// @return false if the choice does not fit.
  bool grow_child(const Live& parent, const Association& choice, Identity identity, const LocalMap& local_map,
                  Live& child);
  /// The hypothesis that is where the candidate is, or none.
  Live* at_place_of(const Candidate& candidate, const Pose2& T_local_base);
  /// Moves an old hypothesis to where a candidate at its place has it, if that is clearly better aligned; both are
  /// judged as if they had met nothing yet.
  void renew(Live& old, const Pose2& T_map_local, ScorerEnsemble::Verdict verdict,
             const Observation& observation) const;
  /// What a hypothesis starts with that is spawned now.
  struct Spawned {
    RetrospectiveVerification::Verdict past;
    double nat = 0;  ///< of the scans before, the newest one, and being spawned
  };
  /// @param hypothesis  that has met nothing yet. @param verdict  on the newest scan.
  Spawned in_retrospect(Hypothesis hypothesis, const ScorerEnsemble::Verdict& verdict, const Observation& observation,
                        double tempering_weight, const RetrospectiveVerification& retrospective) const;
  /// Adds it to those that are alive. @param from  the hypothesis that it comes from, if it comes from one.
  void insert(Live live, Spawned spawned, Candidate candidate, HypothesisId from = {});
  /// How much more the best hypothesis would have if it were spawned now [nat], >= 0. retrospective verification takes
  /// scans in larger pieces than tracking did, and what is seen for the first time counts most: that is no merit of who
  /// comes late.
  double surplus_in_retrospect(const Observation& observation, double tempering_weight,
                               const RetrospectiveVerification& retrospective) const;
  /// A hypothesis at the newest scan.
  struct Moved {
    Pose2 predicted;  ///< T_map_base by dead reckoning
    Alignment scan;   ///< with the map, from there
  };
  /// Carries all to the newest scan; each then stands where the scan fits best.
  std::vector<Moved> align_all(const Observation& observation, std::span<const Point> coarse,
                               const Eigen::Vector2d& window);
  Alignment align(const Pose2& predicted, const Observation& observation) const;
  Pose2 search_alignment(const Pose2& predicted, std::span<const Point> coarse, const Eigen::Vector2d& window) const;
  /// @return an id that no hypothesis has had.
  HypothesisId new_id();
  void end(Live& live, const std::string& reason, HypothesisId merged_into = {});
  /// Where the robot stands by each of them, best first.
  std::vector<PlaceComparison::Place> places(const Pose2& T_local_base) const;
  /// Holds the best places against each other: who explains less of what tells them apart loses evidence.
  void compare(const Observation& observation, double tempering_weight);
  /// The same by what was seen before, for those that come late.
  void compare_in_retrospect(const Pose2& T_local_base, const RetrospectiveVerification& retrospective);
  /// Takes off everybody's evidence what comparisons say against it.
  void take_comparisons();
  void merge(const Pose2& T_local_base);
  void merge_similar();
  void prune();
  void prune_surplus();

  std::shared_ptr<const MapView> map_;
  FeatureIndex index_;
  const ScorerEnsemble& ensemble_;
  TrackingOptions tracking_;
  GrowthOptions growth_;
  HypothesesOptions options_;
  AskedLead lead_;  ///< by the status
  HypothesisListener& listener_;
  PlaceComparison comparison_;
  AssociationTree tree_;
  std::vector<Live> alive_;
  HypothesisId next_id_{0};
};

}  // namespace opal
