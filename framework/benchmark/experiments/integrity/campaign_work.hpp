#pragma once

#include "benchmark/ab/documents/cell_plan.hpp"
#include "benchmark/ab/records/result_folder.hpp"
#include "benchmark/experiments/integrity/campaign.hpp"
#include "benchmark/experiments/integrity/integrity_run.hpp"

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace opal::experiments {

/// A drive of a campaign and what became of it.
struct JudgedDrive {
  DrawnDrive drive;
  IntegrityRun run;
  double cpu_s = 0;     ///< of everything: building, map, driving, localizing
  std::string failure;  ///< empty: it was driven; else what happened, "crashed: signal 11 (SIGSEGV)"
};

/// Drives what is not driven yet of one part of a campaign, each drive in a process of its own. Each drive is in the
/// folder's journals as soon as it has ended.
/// @param progress  is told how many of the part are done. @param stop  ends the work; drives under way are dropped.
/// @throws Error if another program drives some of these, or nothing can be written.
void drive_campaign(const Campaign& campaign, const CampaignRobots& robots, const ab::ResultFolder& folder,
                    const ab::Shard& shard, int jobs, const std::function<void(std::size_t, std::size_t)>& progress,
                    const std::stop_token& stop);

/// All drives that have ended, by number. @throws Error naming a journal that is damaged.
std::vector<JudgedDrive> judged_drives(const Campaign& campaign, const ab::ResultFolder& folder);

}  // namespace opal::experiments
