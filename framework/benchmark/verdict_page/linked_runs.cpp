#include "benchmark/verdict_page/linked_runs.hpp"

#include "report/html_text.hpp"

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

std::string linked(const std::string& target, const std::string& element) {
  return target.empty() ? element : "<a href=\"" + html_text(target) + "\">" + element + "</a>";
}

}  // namespace opal::statistics
