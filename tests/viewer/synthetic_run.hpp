#pragma once

#include <opal/localization/events/event_stream.hpp>

namespace opal::synthetic {

/// A synthetic run, as large as one likes: a robot drives round a hall and every event of docs/events.md
/// happens.
struct RunSize {
  int updates = 100;
  int hypotheses = 20;  ///< alive at a time
  int points = 60;      ///< per scan
  int time_lines = 1;
  unsigned seed = 1;
};

/// The same size is the same run.
void write_run(const RunSize& size, EventSink& events);

}  // namespace opal::synthetic
