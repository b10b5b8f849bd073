#pragma once

#include "benchmark/verdict_page/report_page.hpp"
#include "report/plot.hpp"

#include <tuple>

namespace opal::statistics {

/// The runs behind the pairs of a page.
class LinkedRuns {
 public:
  explicit LinkedRuns(const ReportPage& page);

  /// Where the run is shown; empty if nowhere.
  std::string of(const std::string& arm, const std::string& cluster, const std::string& query,
                 std::uint64_t seed) const;

 private:
  std::map<std::tuple<std::string, std::string, std::string, std::uint64_t>, std::string> links_;
};

}  // namespace opal::statistics
