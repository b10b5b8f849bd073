#pragma once

#include "benchmark/runs/run_record.hpp"

#include "evaluation/ground_truth.hpp"

#include <optional>
#include <string>
#include <vector>

namespace opal::benchmark {

/// What became of one window of a log, for a line of text.
struct WindowAnswer {
  std::string window;
  ReplayProgress whole;
  std::optional<ReplayProgress> localized_after;
  opal::PoseEstimate at_end;
  std::string why;              ///< the status at the end is what it is
  std::optional<double> off_m;  ///< of the pose at the end from the recorded truth
};

/// @param truth  of the laser, if it is recorded.
WindowAnswer answer_of(const std::string& window, const RunRecord& record, const std::string& why,
                       const std::optional<opal::GroundTruth>& truth);

/// "localized after 2.3 m and 11.5 s", with ", but no longer at the end"; "never localized in 13.0 m and 59.1 s"
std::string localized_text(const WindowAnswer& answer);
/// Whether it may be the map of another building: after a long drive the robot is not localized.
bool doubts_map(const WindowAnswer& answer);
/// One line: the window, when it was localized, the status and the pose at the end.
std::string line_of(const WindowAnswer& answer);
/// "5 of 5 queries localized, after 0.4 m (median)"
std::string summary_of(const std::vector<WindowAnswer>& answers);

}  // namespace opal::benchmark
