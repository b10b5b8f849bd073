#pragma once

#include <string>
#include <vector>

namespace opal::benchmark {

/// A run that a page shows.
struct ViewedRun {
  std::string out;   ///< folder that holds events.jsonl, or the file itself
  std::string name;  ///< what the page calls it
};

/// Writes the page of `opal view` for one run, or for two of one log.
/// @return what a reader should know of it, in words: damaged ends, detail that was left out.
/// @throws opal::Error naming the file that is wrong.
std::vector<std::string> write_view_page(const std::vector<ViewedRun>& runs, const std::string& file);

}  // namespace opal::benchmark
