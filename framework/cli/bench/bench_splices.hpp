#pragma once

#include "benchmark/runs/bench_place.hpp"

#include "evaluation/kidnapping.hpp"
#include "evaluation/splice.hpp"

/// Kidnaps the robot of a recorded place again and again.
struct SplicedRuns {
  RunRecord all;  ///< stamps of rows are those of the recording; queries are the splices
  std::vector<opal::KidnappingVerdict> verdicts;
};

/// The truth serves to choose the cuts and to judge; the localizer never sees it.
SplicedRuns run_splices(opal::Localizer& localizer, const BenchPlace& place, const opal::GroundTruth& truth,
                        const opal::SpliceOptions& options);
