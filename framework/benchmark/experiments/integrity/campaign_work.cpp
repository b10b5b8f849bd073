#include "benchmark/experiments/integrity/campaign_work.hpp"

#include "benchmark/ab/execution/child_process.hpp"
#include "benchmark/ab/execution/claim.hpp"
#include "benchmark/ab/records/journal.hpp"
#include "common/stage_clock.hpp"

#include <fmt/format.h>

#include <chrono>
#include <map>
#include <memory>

namespace opal::experiments {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kLongest_s = 900;  // of the wall clock: a drive that takes longer hangs

ab::CellResult result_of(const DrawnDrive& drive, const CampaignRobots& robots, const std::string& scratch) {
  const double start_s = process_cpu_s();
  ab::CellResult result;
  result.number = drive.number;
  result.values = values_of(run_drive(drive, world_of(drive, robots, scratch), robots));
  result.costs["cpu_s"] = process_cpu_s() - start_s;
  return result;
}

/// One drive under way.
class DriveProcess {
 public:
  DriveProcess(const DrawnDrive& drive, const CampaignRobots& robots, const std::string& scratch)
      : number_(drive.number), process_([=, &robots](const ab::ChildProcess::Say& say) {
          say(journal_line(result_of(drive, robots, scratch)));
        }) {}

  /// Waits a little. @return what became of it, once it has ended.
  std::optional<ab::CellResult> ended() {
    constexpr double kPatience_s = 0.02;
    std::string line;
    const ab::ChildProcess::Heard heard = process_.hear(line, kPatience_s);
    if (heard == ab::ChildProcess::Heard::line) return ab::parse_journal_line(line, "a drive's process");
    if (heard == ab::ChildProcess::Heard::end) return failed(process_.failure());
    if (std::chrono::duration<double>(Clock::now() - start_).count() < kLongest_s) return std::nullopt;
    process_.end();
    return failed(fmt::format("hung: no end after {} s", kLongest_s));
  }

 private:
  ab::CellResult failed(const std::string& failure) const {
    ab::CellResult result;
    result.number = number_;
    result.failure = failure.empty() ? "ended without a word" : failure;
    return result;
  }

  std::size_t number_;
  Clock::time_point start_ = Clock::now();
  ab::ChildProcess process_;
};

/// All that have ended, by number; a larger campaign has left some of higher numbers, too.
std::map<std::size_t, ab::CellResult> ended_drives(const ab::ResultFolder& folder) {
  std::map<std::size_t, ab::CellResult> results;
  for (const std::string& journal : folder.journals())
    ab::read_journal(journal, [&](const ab::CellResult& result, ab::JournalPlace) { results[result.number] = result; });
  return results;
}

std::vector<std::size_t> unfinished(const ab::ResultFolder& folder, std::size_t first, std::size_t end) {
  const std::map<std::size_t, ab::CellResult> ended = ended_drives(folder);
  std::vector<std::size_t> numbers;
  for (std::size_t number = first; number < end; ++number)
    if (!ended.contains(number)) numbers.push_back(number);
  return numbers;
}

JudgedDrive judged(const DrawnDrive& drive, const ab::CellResult& result) {
  JudgedDrive judged{drive, {}, 0, result.failure};
  if (!result.failure.empty()) return judged;
  judged.run = integrity_run_from(result.values);
  judged.cpu_s = result.costs.at("cpu_s");
  return judged;
}

}  // namespace

void drive_campaign(const Campaign& campaign, const CampaignRobots& robots, const ab::ResultFolder& folder,
                    const ab::Shard& shard, int jobs, const std::function<void(std::size_t, std::size_t)>& progress,
                    const std::stop_token& stop) {
  const std::size_t first = shard.first(campaign.size()), end = shard.end(campaign.size());
  const ab::Claim claim(folder.path(), first, end);
  const std::vector<std::size_t> numbers = unfinished(folder, first, end);
  ab::Journal journal(folder.journal(shard, 0));
  std::vector<std::unique_ptr<DriveProcess>> under_way;
  std::size_t next = 0, done = end - first - numbers.size();
  while (!stop.stop_requested() && (next < numbers.size() || !under_way.empty())) {
    while (under_way.size() < static_cast<std::size_t>(jobs) && next < numbers.size())
      under_way.push_back(std::make_unique<DriveProcess>(campaign.drive(numbers[next++]), robots, folder.path()));
    std::erase_if(under_way, [&](const auto& process) {
      const auto result = process->ended();
      if (result) journal.append(*result), ++done;
      return result.has_value();
    });
    progress(done, end - first);
  }
}

std::vector<JudgedDrive> judged_drives(const Campaign& campaign, const ab::ResultFolder& folder) {
  std::vector<JudgedDrive> drives;
  for (const auto& [number, result] : ended_drives(folder))
    if (number < campaign.size()) drives.push_back(judged(campaign.drive(number), result));
  return drives;
}

}  // namespace opal::experiments
