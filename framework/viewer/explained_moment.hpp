#pragma once

#include "viewer/hypothesis_history.hpp"
#include "viewer/run_frame.hpp"

#include <map>
#include <optional>

namespace opal {

/// Everything that an explanation draws on: the newest frame, and what the frames before it leave to know.
struct ExplainedMoment {
  explicit ExplainedMoment(const RunHeader& of_run) : header(of_run) {}

  const RunHeader& header;
  RunFrame frame;
  HypothesisHistories histories;
  std::map<int, RecordedLocalFeature> local_features;  ///< alive, by id
  std::optional<RecordedSearch> search;                ///< the last one of the time line
  double searched_s = 0;
  double status_since_s = 0;
  double leads_since_s = 0;  ///< the best hypothesis is the best one since then

  void take(const RunFrame& next);

  /// @return nullptr if there is none.
  const RecordedHypothesis* best() const;

 private:
  void take_local_map();
};

}  // namespace opal
