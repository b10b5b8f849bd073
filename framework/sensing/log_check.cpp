#include "sensing/log_check.hpp"

#include "common/phrases.hpp"

#include <opal/common/error.hpp>
#include <opal/sensing/replay.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

namespace opal {
namespace {

const RawScan* scan_of(const LogRecord& record, const LaserModel& laser) {
  const auto* raw = std::get_if<RawScan>(&record);
  return raw && (laser.frame.empty() || raw->frame == laser.frame) ? raw : nullptr;
}

/// Most scans have as many beams; a line that was cut has fewer.
int usual_beams(std::span<const LogRecord> records, const LaserModel& laser) {
  std::map<int, int> scans_by_beams;
  for (const LogRecord& record : records)
    if (const RawScan* raw = scan_of(record, laser)) ++scans_by_beams[static_cast<int>(raw->ranges_m.size())];
  const auto most = std::max_element(scans_by_beams.begin(), scans_by_beams.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == scans_by_beams.end() ? 0 : most->first;
}

/// `opal simulate` and recorded places have a description of the laser beside the log.
std::string description_beside(const std::string& log) {
  const std::size_t ending = log.rfind(".log");
  const std::string description = log.substr(0, ending) + ".info.json";
  return ending != std::string::npos && std::filesystem::exists(description) ? ", or take it with --info " + description
                                                                             : "";
}

std::string frames_in(std::span<const LogRecord> records) {
  std::set<std::string> frames;
  for (const LogRecord& record : records)
    if (const auto* raw = std::get_if<RawScan>(&record)) frames.insert("\"" + raw->frame + "\"");
  return listed(frames);
}

bool has_scan_of(std::span<const LogRecord> records, const LaserModel& laser) {
  return usual_beams(records, laser) > 0;
}

bool are_all_described(std::span<const LogRecord> records, const std::vector<LaserModel>& described) {
  return std::all_of(records.begin(), records.end(), [&](const LogRecord& record) {
    const auto is_its = [&](const LaserModel& laser) { return scan_of(record, laser) != nullptr; };
    return !std::holds_alternative<RawScan>(record) || std::any_of(described.begin(), described.end(), is_its);
  });
}

}  // namespace

const RawScan* first_with_geometry(std::span<const LogRecord> records, const LaserModel& laser) {
  for (const LogRecord& record : records)
    if (const RawScan* raw = scan_of(record, laser); raw && raw->angle_min_rad && raw->angle_increment_rad) return raw;
  return nullptr;
}

void check_log(std::span<const LogRecord> records, const LaserModel& laser, const std::string& log,
               const std::string& described_in) {
  const RawScan* stated = first_with_geometry(records, laser);
  if (laser.geometry_from_log && stated) return;
  const int beams = usual_beams(records, laser);
  if (beams > 0 && beams != laser.beams)
    throw ConfigError(
        fmt::format("{}: the laser has {} beams, but the scans of {} have {}; describe the laser that recorded "
                    "the log (beams, angle_min_rad, angle_increment_rad){}",
                    described_in, laser.beams, log, beams, description_beside(log)));
  if (!stated) return;
  // Half a beam at either end: what is more turns the scan, or bends it.
  const double off_first_rad = std::abs(wrap_angle(*stated->angle_min_rad - laser.angle_min_rad));
  const double off_span_rad = std::abs(*stated->angle_increment_rad - laser.angle_increment_rad) * (laser.beams - 1);
  const double half_a_beam_rad = std::abs(laser.angle_increment_rad) / 2;
  if (off_first_rad <= half_a_beam_rad && off_span_rad <= 2 * half_a_beam_rad) return;
  throw ConfigError(
      fmt::format("{}: beams begin at {:.3f} degrees and are {:.4f} degrees apart, but {} states {:.3f} and {:.4f}; "
                  "correct them, or set geometry_from_log",
                  described_in, degrees(laser.angle_min_rad), degrees(laser.angle_increment_rad), log,
                  degrees(*stated->angle_min_rad), degrees(*stated->angle_increment_rad)));
}

std::vector<LaserModel> lasers_of_log(std::span<const LogRecord> records, std::vector<LaserModel> described,
                                      const std::string& log, const std::string& described_in) {
  const bool are_several = described.size() > 1;
  const std::vector<std::string> silent = silent_lasers(records, described);
  const bool may_be_silent = silent.size() < described.size() && are_all_described(records, described);
  std::vector<LaserModel> lasers;
  for (std::size_t k = 0; k < described.size(); ++k) {
    const std::string place = described_in + (are_several ? "/" + std::to_string(k) : "");
    const bool is_silent = std::ranges::find(silent, described[k].frame) != silent.end();
    if (is_silent && !may_be_silent)
      throw ConfigError(fmt::format("{}: {} has no scan of frame \"{}\"; its scans have: {}", place, log,
                                    described[k].frame, frames_in(records)));
    if (is_silent && described[k].geometry_from_log) continue;
    check_log(records, described[k], log, place);
    lasers.push_back(with_log_geometry(described[k], records));
  }
  return lasers;
}

std::vector<std::string> silent_lasers(std::span<const LogRecord> records, std::span<const LaserModel> described) {
  std::vector<std::string> silent;
  for (const LaserModel& laser : described)
    if (!laser.frame.empty() && !has_scan_of(records, laser)) silent.push_back(laser.frame);
  return silent;
}

}  // namespace opal
