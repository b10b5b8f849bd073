#pragma once

#include <opal/sensing/replay.hpp>
#include "evaluation/ground_truth.hpp"
#include "evaluation/site.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace opal {

/// A robot that is picked up and put down elsewhere, made of one recorded drive: the drive breaks off in one window and
/// goes on in another one.
struct KidnappingSequence {
  std::string id;
  Query before;        ///< up to the cut
  Query after;         ///< from the cut on
  double apart_m = 0;  ///< between the two places at the cut
};

struct KidnappingSequenceOptions {
  int count = 0;  ///< 0: as many as there are queries
  std::uint64_t seed = 1;
  double least_apart_m = 5;
  double before_m = 8;  ///< driving before the cut, at least, where the window has it
  double after_m = 20;  ///< and after it
};

/// Draws pairs of windows and a cut in each of them. The same queries, truth and options give the same sequences.
/// @param name  begins the ids.
/// @throws ConfigError if the windows hold no two places that are far enough apart.
OPAL_EXPORT std::vector<KidnappingSequence> draw_kidnapping_sequences(const std::string& name,
                                                                      std::span<const Query> queries,
                                                                      const GroundTruth& truth,
                                                                      const KidnappingSequenceOptions& options);

/// What the localizer is given, and when each of it was recorded.
struct KidnappingLog {
  std::vector<Sample> samples;
  std::vector<double> recorded_s;  ///< stamps by which the truth of each sample is to be looked up
  std::size_t cut = 0;             ///< the first sample after the cut
};

/// Joins two recordings as if nothing had happened: odometry stands still over the cut, and the stamps go on with the
/// recording's usual step. Samples of either may be in any odometry frame.
OPAL_EXPORT KidnappingLog with_kidnapping(std::span<const Sample> before, std::span<const Sample> after);

}  // namespace opal
