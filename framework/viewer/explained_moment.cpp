#include "viewer/explained_moment.hpp"

#include <algorithm>

namespace opal {

void ExplainedMoment::take(const RunFrame& next) {
  const bool anew = next.starts.has_value();
  if (anew || next.status != frame.status) status_since_s = next.time_s;
  if (anew || next.best != frame.best) leads_since_s = next.time_s;
  if (anew) search.reset();
  frame = next;
  histories.take(frame);
  take_local_map();
  if (!frame.search) return;
  search = frame.search;
  searched_s = frame.time_s;
}

void ExplainedMoment::take_local_map() {
  if (frame.starts) local_features.clear();
  for (int id : frame.gone) local_features.erase(id);
  for (const RecordedLocalFeature& feature : frame.changed) local_features[feature.id] = feature;
}

const RecordedHypothesis* ExplainedMoment::best() const {
  const auto it = std::find_if(frame.hypotheses.begin(), frame.hypotheses.end(),
                               [&](const RecordedHypothesis& h) { return h.id == frame.best; });
  return it == frame.hypotheses.end() ? nullptr : &*it;
}

}  // namespace opal
