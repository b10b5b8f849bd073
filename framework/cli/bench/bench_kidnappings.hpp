#pragma once

#include "benchmark/runs/bench_place.hpp"

#include "evaluation/kidnapping.hpp"
#include "evaluation/kidnapping_sequence.hpp"

#include <stop_token>

namespace opal::cli {

/// Kidnaps the robot of a recorded place again and again.
struct KidnappingRuns {
  benchmark::RunRecord all;  ///< stamps of rows are those of the recording; queries are the sequences
  std::vector<KidnappingVerdict> verdicts;
  bool is_cut = false;  ///< a stop was asked for; what had begun then is left out
};

/// The truth serves to choose the cuts and to judge; the localizer never sees it.
KidnappingRuns run_kidnappings(Localizer& localizer, const benchmark::BenchPlace& place, const GroundTruth& truth,
                               const KidnappingSequenceOptions& options, const std::stop_token& stop);

}  // namespace opal::cli
