#pragma once

#include <opal/sensing/lines/line_extraction.hpp>

namespace opal {

/// How far a hit may lie from its line [m].
inline double line_tolerance_m(const LineExtractionOptions& options, double range_m) {
  return options.tolerance_m + options.tolerance_per_m * range_m;
}

/// The straight pieces of all chains, three hits or more each, chain after chain (Pavlidis and Horowitz
/// 1974).
std::vector<Run> split_and_merged(const ScanChains& chains, const LineExtractionOptions& options);

}  // namespace opal
