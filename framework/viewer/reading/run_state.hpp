#pragma once

#include "viewer/reading/run_frame.hpp"

#include <map>
#include <optional>

namespace opal {

/// A hypothesis from spawn to end, as far as the frames that were applied tell.
struct TracedHypothesis {
  HypothesisId id = {};
  HypothesisId parent = {};
  std::string origin;    ///< as RecordedSpawn
  double spawned_s = 0;  ///< time since the start of the time line
  KeyframeId spawned_keyframe = {};
  std::vector<Association> pairs;  ///< associations that hold now (at the end, if it has ended), oldest first

  // Newest, or the last there were.
  Pose2 T_map_base;
  double log_likelihood = 0;
  double scan_nat = 0;
  double probability = 0;
  std::vector<RecordedTerm> scores;

  double highest_probability = 0;
  double highest_s = 0;         ///< when it had that
  std::optional<double> led_s;  ///< when it was last the best one
};

struct EndedHypothesis {
  TracedHypothesis life;
  RecordedEnd end;
  double end_s = 0;
  KeyframeId end_keyframe = {};
};

/// What holds after some updates of a time line: frames are applied in order, a frame that starts a time line
/// clears it.
class RunState {
 public:
  /// Whether the points where the robot was are kept. They are what grows with the run.
  enum class Paths { kept, left_out };
  explicit RunState(Paths paths = Paths::kept) : paths_(paths) {}

  void apply(const RunFrame& frame);

  /// The newest frame; everything about it alone is there. @pre a frame was applied
  const RunFrame& frame() const { return frame_; }
  bool empty() const { return frames_ == 0; }
  std::size_t frames() const { return frames_; }  ///< of this time line
  const std::string& time_line() const { return time_line_; }

  /// Those that exist now, by id.
  const std::map<LocalFeatureId, RecordedLocalFeature>& local_features() const { return local_features_; }
  /// Those that are alive now, by id.
  const std::map<HypothesisId, TracedHypothesis>& alive() const { return alive_; }
  /// The best one; null if there is none.
  const TracedHypothesis* best() const;
  /// Those that have ended, oldest first. When there are very many, those that were never likely are
  /// forgotten.
  const std::vector<EndedHypothesis>& ended() const { return ended_; }

  const std::vector<Point>& trajectory() const { return trajectory_; }  ///< of the best ones [m], map frame
  const std::vector<Point>& truth() const { return truth_; }

  static constexpr std::size_t kMostEnded = 2000;

 private:
  void apply_local_features();
  void insert(const RecordedSpawn& spawn);
  void grow(const RecordedGrowth& growth);
  void lose(const RecordedLoss& loss);
  void end(const RecordedEnd& end);
  void take_estimate();
  void keep_alive_only_listed();
  void forget_unlikely();
  TracedHypothesis& traced(HypothesisId id);

  RunFrame frame_;
  std::size_t frames_ = 0;
  std::string time_line_;
  std::map<LocalFeatureId, RecordedLocalFeature> local_features_;
  std::map<HypothesisId, TracedHypothesis> alive_;
  std::vector<EndedHypothesis> ended_;
  Paths paths_;
  std::vector<Point> trajectory_, truth_;
};

}  // namespace opal
