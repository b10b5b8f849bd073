#pragma once

#include "viewer/encoding/record_text.hpp"
#include "viewer/encoding/thinned_path.hpp"
#include "viewer/reading/run_frame.hpp"
#include "viewer/reading/run_state.hpp"

#include <cstddef>
#include <span>

namespace opal {

// The members of a record that say what a frame says, as framework/viewer/page/README.md has them.

void write_mapped_feature(const RunHeader::Feature& feature, RecordText& record);
void write_local_features(const std::vector<RecordedLocalFeature>& changed, const std::vector<LocalFeatureId>& gone,
                          RecordText& record);
/// What holds after a frame, for a reader that begins with it: the time line, the hypotheses, and the way before.
void write_restatement(const RunState& state, const ThinnedPath& path, RecordText& record);
/// All local features that hold.
std::vector<RecordedLocalFeature> features_of(const RunState& state);
/// How the hypothesis tree changed: spawned, grown, lost, tried, ended.
void write_tree(const RunFrame& frame, RecordText& record);
void write_search(const RecordedSearch& search, RecordText& record);
/// Probabilities of the hypotheses that have rows, and the scores of the best few.
void write_beliefs(std::span<const RecordedHypothesis> hypotheses, std::size_t most_scores, RecordText& record);
/// The estimate, truth and cost.
void write_answer(const RunFrame& frame, RecordText& record);

}  // namespace opal
