#pragma once

#include <span>
#include <string>
#include <vector>

namespace opal {

/// How exactly records say what happened (framework/viewer/page/README.md).
struct PageDetail {
  double unit_m = 0.001, unit_rad = 0.0005, unit_nat = 0.01;  ///< steps of hypothesis rows
  double scan_unit_m = 0.005;
  int scan_stride = 1;                    ///< every n-th point of scan and free space; 0: neither
  int most_scores = 5;                    ///< hypotheses per update whose scores are kept
  int most_hypotheses = 1'000'000;        ///< hypotheses per update that are kept, best first
  std::vector<std::string> reduced = {};  ///< sentences: what is left out
};

/// From everything to what is left when a run is very long.
std::span<const PageDetail> page_details();

}  // namespace opal
