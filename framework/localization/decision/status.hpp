#pragma once

#include "localization/decision/map_agreement.hpp"
#include "localization/decision/map_doubt.hpp"
#include "localization/tree/hypothesis_set.hpp"

#include <opal/localization/decision/pose_estimate.hpp>
#include <opal/localization/options/localizer_options.hpp>

#include <algorithm>
#include <limits>

namespace opal {

/// What the newest scan tells beside the hypotheses' evidence.
struct Circumstances {
  double tempering_weight = 1;  ///< how much of a new piece of evidence the scan was, in (0, 1]
  double kidnapped = 0;         ///< probability that the robot has been kidnapped from all hypotheses
  double unmapped_walls_m = 0;  ///< straight walls around the robot that the best hypothesis does not find on the map
  bool is_broken = false;       ///< the scan shows hardly anything of what was seen before, or that was a long way ago
  MapAgreement agreement{};     ///< of the map with the scan, at the best hypothesis
};

/// Turns hypotheses into one answer with a status.
class OPAL_EXPORT StatusEstimator {
 public:
  /// @param evidence_memory  as TrackingOptions.
  StatusEstimator(const StatusOptions& options, double evidence_memory)
      : options_(options), evidence_memory_(evidence_memory), map_doubt_(options.localized_most_weight) {}

  /// @param alive         best first.
  /// @param T_local_base  newest pose in the local frame.
  PoseEstimate estimate(const std::vector<Live>& alive, const Pose2& T_local_base, double stamp_s,
                        const Circumstances& now);
  /// The newest estimate, carried on to another pose in the local frame.
  PoseEstimate at(double stamp_s, const Pose2& T_local_base) const;

  /// Probabilities behind the newest estimate.
  struct Belief {
    std::vector<double> hypotheses;  ///< in the order of `alive`
    double none = 1;                 ///< that it is none of these
    std::string why;                 ///< the status is what it is, in words
  };
  const Belief& belief() const { return belief_; }

  /// While `why`, a sentence, is not empty, nothing is called localized, and nothing is evidence: the sensor
  /// description is wrong.
  void contradict(const std::string& why) { contradict(why, Evidence::spoilt); }
  /// While `why`, a sentence, is not empty, nothing is called localized: the odometry counts nothing, and scans alone
  /// tell where the robot goes. Evidence stays. New evidence as of a new place has to confirm it afterwards.
  void suspend(const std::string& why) { contradict(why, Evidence::stays); }
  /// That the map does not explain what the robot sees, in words; empty: it does. No status depends on it.
  std::string map_doubt() const { return map_doubt_.words(); }

  /// Takes this much off what "none of these" has gathered, but leaves it at least `least_nat`: hypotheses begin anew.
  void settle(double nat, double least_nat) { none_nat_ = std::max(none_nat_ - nat, least_nat); }

  double probability() const { return last_.probability; }  ///< of the best place
  bool localized() const { return last_.status == Status::localized; }
  /// The best place has the probability that `localized` asks for, if not for long enough yet.
  bool believed() const { return localized() || held_.weight > 0; }
  void reset();

 private:
  enum class Evidence { stays, spoilt };
  void contradict(const std::string& why, Evidence evidence) {
    contradiction_ = why;
    evidence_ = evidence;
    if (why.empty()) return;
    map_doubt_.clear();
    drive_agreement_.clear();
  }
  void believe(const std::vector<Live>& alive);
  void weigh(const std::vector<Live>& alive, const Pose2& T_local_base, PoseEstimate& estimate);
  /// A status, and why it is what it is, in words.
  struct Judgement {
    Status status;
    std::string why;
  };
  Judgement judge(const Live& best, const Pose2& T_local_base, const PoseEstimate& estimate, const Circumstances& now);
  /// Takes what the newest scan says of the best place. @param same  it is the one of before.
  void gather(const Live& best, const PoseEstimate& estimate, const Circumstances& now, bool same);
  /// @return for how many pieces of new evidence the required probability has to hold.
  double weight_asked(double unmapped_walls_m) const;
  double lead_asked_nat() const { return options_.lead().nat(lead_.own_nat); }
  void reckon_with(double kidnapped, PoseEstimate& estimate);
  /// How the map may be wrong, if no evidence is enough; empty: it is not that wrong.
  std::string why_not_this_map() const;
  /// The required probability has held for so long, and no longer.
  std::string why_held(double asked, double unmapped_walls_m) const;
  /// The place is known, the pose not well enough; empty if it is.
  std::string why_vague(const Eigen::Matrix3d& covariance) const;
  /// What has been seen since the place has the required probability says nothing for it.
  std::string why_not_for() const;
  /// The required probability has not held at all. @param same  the best place is the one of before.
  std::string why_unsure(bool same, double probability) const;
  Status while_contradicted(const PoseEstimate& estimate) const;

  StatusOptions options_;
  double evidence_memory_;
  PoseEstimate last_;
  Belief belief_;
  std::string contradiction_;            ///< of the sensor description by the drive; empty: none
  Evidence evidence_ = Evidence::stays;  ///< while there is a contradiction
  Pose2 T_map_local_;
  double none_nat_ = 0;  ///< log weight of "none of these"
  /// Sum of tempering weights since a scan broke off from those before, or odometry did.
  double unbroken_ = std::numeric_limits<double>::infinity();
  /// What has been seen since the required probability holds at one place.
  struct Held {
    double weight = 0;  ///< sum of tempering weights
    double nat = 0;     ///< evidence for this place
  };
  Held held_;
  bool was_localized_ = false;
  double mean_scan_nat_ = 0;             ///< of the best hypothesis, over the newest scans
  MeanAgreement agreement_;              ///< since the best place is the same
  MeanAgreement drive_agreement_{0.95};  ///< over about twenty pieces, whichever place was the best
  MapDoubt map_doubt_;
  /// Of the best place over the best one elsewhere, in evidence.
  struct Lead {
    double nat = std::numeric_limits<double>::infinity();
    double own_nat = 0;  ///< evidence of the best place, of which a share is asked for
  };
  Lead lead_;
};

}  // namespace opal
