#include "benchmark/verdict_page/linked_runs.hpp"

namespace opal::statistics {

LinkedRuns::LinkedRuns(const ReportPage& page) {
  if (!page.link) return;
  for (const ResultRow& row : page.table) links_[{row.arm, row.cluster, row.query, row.seed}] = page.link(row);
}

std::string LinkedRuns::of(const std::string& arm, const std::string& cluster, const std::string& query,
                           std::uint64_t seed) const {
  const auto found = links_.find({arm, cluster, query, seed});
  return found == links_.end() ? "" : found->second;
}

}  // namespace opal::statistics
