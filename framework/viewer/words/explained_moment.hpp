#pragma once

#include "viewer/reading/run_state.hpp"

#include <optional>

namespace opal {

/// Everything that an explanation draws on: the newest frame, and what the frames before it leave to know.
struct ExplainedMoment {
  explicit ExplainedMoment(const RunHeader& of_run) : header(of_run) {}

  void take(const RunFrame& frame);

  const RunHeader& header;
  RunState state{RunState::Paths::left_out};
  std::optional<RecordedSearch> search;  ///< the last one of the time line
  double searched_s = 0;
  double status_since_s = 0;
};

}  // namespace opal
