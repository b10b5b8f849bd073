#pragma once

#include "viewer/run_frame.hpp"

#include <map>
#include <optional>
#include <vector>

namespace opal {

/// What the frames so far said about one hypothesis.
struct HypothesisHistory {
  std::optional<RecordedBirth> birth;  ///< absent if the stream does not tell
  double born_s = 0;
  std::map<int, int> pairs;  ///< local feature -> position in RunHeader::features, or -1 for "not on the map"
  double highest_probability = 0;
  double highest_s = 0;           ///< when that was
  std::optional<double> led_s;    ///< when it was last the best one
};

/// A hypothesis that ended, and not because another one is at the same place.
struct FallenHypothesis {
  HypothesisHistory history;
  RecordedEnd end;
  double fell_s = 0;
  bool beside_best = false;  ///< it stood where the best one stands: no rival
};

/// Follows the hypotheses of one time line, frame by frame. Of those that ended it keeps the few that mattered most.
class HypothesisHistories {
 public:
  void take(const RunFrame& frame);

  /// @return nullptr if there is no such hypothesis.
  const HypothesisHistory* alive(int hypothesis) const;
  /// Former best ones first, the latest first; then by the highest probability they ever had.
  const std::vector<FallenHypothesis>& fallen() const { return fallen_; }

 private:
  void take_birth(const RecordedBirth& birth, double time_s);
  void take_end(const RecordedEnd& end, const RunFrame& frame);
  void take_estimate(const RunFrame& frame);

  std::map<int, HypothesisHistory> alive_;
  std::vector<FallenHypothesis> fallen_;
};

/// What the localizer's status takes for one place (status.cpp): such hypotheses share their probability.
bool same_place(const Pose2& a, const Pose2& b);

}  // namespace opal
