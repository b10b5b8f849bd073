#pragma once

#include "benchmark/runs/bench_place.hpp"

#include "evaluation/kidnapping.hpp"
#include "evaluation/kidnapping_sequence.hpp"

#include <stop_token>

/// Kidnaps the robot of a recorded place again and again.
struct KidnappingRuns {
  opal::benchmark::RunRecord all;  ///< stamps of rows are those of the recording; queries are the sequences
  std::vector<opal::KidnappingVerdict> verdicts;
  bool is_cut = false;  ///< a stop was asked for; what had begun then is left out
};

/// The truth serves to choose the cuts and to judge; the localizer never sees it.
KidnappingRuns run_kidnappings(opal::Localizer& localizer, const opal::benchmark::BenchPlace& place,
                               const opal::GroundTruth& truth, const opal::KidnappingSequenceOptions& options,
                               const std::stop_token& stop);
