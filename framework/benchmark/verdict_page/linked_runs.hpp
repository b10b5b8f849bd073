#pragma once

#include "benchmark/verdict_page/report_page.hpp"

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

/// An element in a link, or just the element if there is no target.
std::string linked(const std::string& target, const std::string& element);

}  // namespace opal::statistics
