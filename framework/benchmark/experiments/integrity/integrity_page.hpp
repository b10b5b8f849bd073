#pragma once

#include "benchmark/experiments/integrity/integrity_report.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace opal::experiments {

/// A drive that was repeated to be looked at.
struct ShownDrive {
  JudgedDrive drive;
  std::string picture;  ///< SVG
  std::string page;     ///< relative to the report; empty: there is none
};

/// Repeats a drive and leaves in a folder what is needed to look at it: drive.json, events.jsonl, page.html.
/// @throws Error if it cannot be driven, or something cannot be written.
ShownDrive repeat_drive(const DrawnDrive& drive, const CampaignRobots& robots, const std::filesystem::path& folder);

/// The report of a campaign as a page that stands alone.
/// @param command  that makes it again.
std::string integrity_page(const std::string& command, const std::vector<Stratum>& strata,
                           const std::vector<ShownDrive>& worst);

}  // namespace opal::experiments
