#pragma once

namespace opal {

/// CPU time per stage of one update [s], in pipeline order.
struct StageTimes {
  double detect_s = 0, local_map_s = 0, associate_s = 0, verify_s = 0, track_s = 0, status_s = 0;
  double total_s() const { return detect_s + local_map_s + associate_s + verify_s + track_s + status_s; }
};

}  // namespace opal
