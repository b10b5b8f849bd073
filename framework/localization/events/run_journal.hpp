#pragma once

#include "localization/decision/status.hpp"
#include "localization/events/run_events.hpp"
#include "localization/tree/hypothesis_set.hpp"

#include <opal/common/stage_times.hpp>
#include <opal/localization/events/event_stream.hpp>
#include <opal/sensor_health/sensor_finding.hpp>

#include <unordered_map>

namespace opal {

/// Writes the event stream of a localizer (docs/events.md). Where nobody listens, every call returns at once.
class OPAL_EXPORT RunJournal final : public HypothesisListener {
 public:
  RunJournal(EventSink& events, std::shared_ptr<const MapView> map, const ScorerEnsemble& ensemble,
             const GlobalSearch& search)
      : events_(events), map_(std::move(map)), ensemble_(ensemble), search_(search) {}

  bool listening() const { return events_.listening(); }

  /// Begins an update.
  /// @param observation  what hypotheses are judged by; must outlive the update.
  void keyframe(const Sample& sample, KeyframeId keyframe, const Observation& observation);
  /// What the drive says of the sensor; the estimates that follow write what is not fine.
  void sensor(const std::vector<SensorFinding>& findings);
  void searched(std::span<const CandidateGenerator::LookedUp> looked_up, std::size_t proposed);
  void estimate(const PoseEstimate& estimate, const std::vector<Live>& alive, const StatusEstimator::Belief& belief);
  /// Ends an update.
  void cost(const StageTimes& times, double total_s);
  /// The localizer was reset.
  void reset();
  /// It was reset because somebody asked to forget everything: a new time line.
  void forgot() { events_.write(start_event("after all was forgotten")); }

  void spawned(const Live& live, const Beginning& beginning) override;
  void ended(const Live& live, const Ending& ending) override;
  void associated(const Live& live, std::span<const Association> pairs) override;
  void dissociated(const Live& live, const std::vector<LocalFeatureId>& local_features,
                   const std::string& reason) override;
  void branch_rejected(const Live& parent, const Association& pair, const std::string& reason) override;
  void candidate_rejected(const VerifiedCandidate& candidate, const std::string& reason) override;

 private:
  using Json = nlohmann::ordered_json;
  /// A local feature as it was last written.
  struct Written {
    Geometry geometry;
    bool stable = false;
    std::size_t measurements = 0;
    bool alive = true;
  };

  Json event(const char* kind) const;
  void local_features(const LocalMap& local_map);
  void status_change(const PoseEstimate& estimate);
  Json pairs_json(std::span<const Association> pairs) const;
  Json scores_json(const Live& live) const;
  Json findings_json(const Live& live) const;
  Json hypothesis_json(const Live& live, double probability) const;
  Pose2 T_map_base(const Live& live) const;

  EventSink& events_;
  std::shared_ptr<const MapView> map_;
  const ScorerEnsemble& ensemble_;
  const GlobalSearch& search_;
  double stamp_s_ = 0;
  KeyframeId keyframe_;
  const Observation* observation_ = nullptr;  ///< of the update that is under way
  std::unordered_map<LocalFeatureId, Written> written_;
  std::optional<Status> reported_;
  Json sensor_ = Json::array();  ///< words of findings that are not fine
  Json rejected_;                ///< candidates of the search that is under way
};

}  // namespace opal
