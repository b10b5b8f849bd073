#pragma once

#include <string>
#include <vector>

namespace opal::cli {

/// What commands that play a log leave in their folder, all of them: whatever an earlier one left goes when another
/// begins.
inline std::vector<std::string> run_products() {
  return {"events.jsonl", "trajectory.tum",  "results.csv",    "alternatives.csv", "kidnappings.csv",
          "summary.json", "first_scan.svg",  "first_scan.png", "picture.svg",      "picture.png",
          "view.html",    "deviations.json", "deviations.txt", "deviations.svg"};
}

}  // namespace opal::cli
