#pragma once

#include <opal/common/export.hpp>
#include "report/table.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace opal {

/// Something was said to be true with a probability, and was true or not.
struct Statement {
  std::string cluster;     ///< statements of one query are correlated
  double probability = 0;  ///< in [0, 1]
  bool came_true = false;
};

/// What a statement counts.
enum class Weighting {
  per_statement,  ///< all the same
  per_cluster,    ///< those of one cluster count 1 together: a long query counts no more than a short one
};

struct Interval {
  double low = 0, high = 0;
};

/// Statements of nearly the same probability.
struct ReliabilityBin {
  double from = 0, to = 0;  ///< probability; `to` belongs to it in the last bin only
  std::size_t statements = 0;
  std::size_t clusters = 0;   ///< that they are of
  double said = 0;            ///< mean probability
  double came_true = 0;       ///< share
  Interval came_true_within;  ///< 95 % (Wilson), of as many independent statements as there are clusters
};

/// How far probabilities can be trusted.
struct Calibration {
  std::size_t statements = 0, clusters = 0;
  std::vector<ReliabilityBin> bins;  ///< those that hold anything, lowest first
  double came_true = 0;              ///< share of all
  double brier = 0;                  ///< mean squared error = reliability - resolution + uncertainty + within_bins
  double reliability = 0;            ///< what wrong probabilities cost; 0 is perfect
  double resolution = 0;             ///< what telling cases apart brings
  double uncertainty = 0;            ///< of the outcomes themselves
  double within_bins = 0;            ///< what binning leaves out of the three (Murphy 1973)
  double log_loss = 0;               ///< mean [nat]; probabilities nearer to 0 or 1 than 10^-9 count as that
  double expected_error = 0;         ///< expected calibration error: mean |said - came true| over the bins
  Interval brier_within, log_loss_within, expected_error_within;  ///< 95 %, bootstrap over whole clusters
};

/// Bins end at 0.1, 0.2, ... 0.9, 0.95, 0.99, 0.999 and 1: what matters is how sure is sure.
/// @param resamples  of the bootstrap; the same seed gives the same intervals.
/// @throws ConfigError if there is no statement, or a probability is not in [0, 1].
OPAL_EXPORT Calibration calibration_of(std::span<const Statement> statements, Weighting weighting, int resamples = 1000,
                                       std::uint64_t seed = 1);

/// 95 % interval of a share (Wilson 1927). @param trials  more than 0; need not be whole.
OPAL_EXPORT Interval wilson_interval(double share, double trials);

OPAL_EXPORT nlohmann::ordered_json to_json(const Calibration& calibration);
/// For people: the bins as a table, and the scores in two lines.
OPAL_EXPORT Table table_of(const Calibration& calibration);
OPAL_EXPORT std::string scores_of(const Calibration& calibration);

}  // namespace opal
