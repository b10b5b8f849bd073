#pragma once

#include "benchmark/experiments/integrity/campaign_work.hpp"
#include "benchmark/statistics/interval.hpp"
#include "report/table.hpp"

#include <span>
#include <string>
#include <vector>

namespace opal::experiments {

/// Drives that have something in common.
struct Stratum {
  std::string aspect, value;  ///< "map", "redrawn"; all drives: "all", ""
  std::vector<const JudgedDrive*> drives;

  std::size_t false_drives() const;  ///< those that called a wrong pose localized for longer than a second, or failed
  /// Share of the false drives, 95 % interval; drives through one building count as a cluster.
  statistics::Interval false_share() const;
};

/// All drives first; then by what the robot has and what happens: each aspect in turn.
std::vector<Stratum> strata_of(std::span<const JudgedDrive> drives);

/// "At most 2.9 of 1,000 drives call a wrong pose localized ...": what a campaign has shown.
std::string bound_sentence(const Stratum& all);

/// One row a stratum.
Table strata_table(const std::vector<Stratum>& strata);
/// One row a drive.
Table drive_rows(std::span<const JudgedDrive> drives);

/// Drives that failed, or called a wrong pose localized: the worst first.
std::vector<JudgedDrive> worst_drives(std::span<const JudgedDrive> drives, std::size_t most);

/// Sentence, counts and bounds as a document.
nlohmann::ordered_json summary_json(const CampaignRequest& request, const std::vector<Stratum>& strata);

}  // namespace opal::experiments
