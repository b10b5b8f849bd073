#include "viewer/words/explained_moment.hpp"

namespace opal {

void ExplainedMoment::take(const RunFrame& frame) {
  if (state.empty() || frame.starts || frame.status != state.frame().status) status_since_s = frame.time_s;
  if (frame.starts) search.reset();
  state.apply(frame);
  if (!frame.search) return;
  search = frame.search;
  searched_s = frame.time_s;
}

bool same_place(const Pose2& a, const Pose2& b) {
  constexpr double kSamePlace_m = 0.7, kSamePlace_rad = 0.2;
  return distance_m(a, b) < kSamePlace_m && angle_between_rad(a, b) < kSamePlace_rad;
}

}  // namespace opal
