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

}  // namespace opal
