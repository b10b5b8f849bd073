#include "benchmark/runs/recorded_log.hpp"

#include "session/session.hpp"

#include <opal/common/error.hpp>
#include <opal/sensing/replay.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace opal::benchmark {
namespace {

template <class Take>
void for_each_scan(const RecordedLog& log, const Take& take) {
  for (const opal::LogRecord& record : log.records)
    if (const auto* scan = std::get_if<opal::RawScan>(&record)) take(*scan);
}

bool holds_scan(const RecordedLog& log) {
  return std::ranges::any_of(
      log.records, [](const opal::LogRecord& record) { return std::holds_alternative<opal::RawScan>(record); });
}

/// Of all scans, whatever order they have.
struct Span {
  double begin_s = 0, end_s = 0;
  std::size_t scans = 0;
  std::string text() const { return fmt::format("{:.1f} to {:.1f} s", begin_s, end_s); }
};

Span span_of(const RecordedLog& log) {
  Span span;
  for_each_scan(log, [&](const opal::RawScan& scan) {
    span.begin_s = span.scans == 0 ? scan.stamp_s : std::min(span.begin_s, scan.stamp_s);
    span.end_s = span.scans == 0 ? scan.stamp_s : std::max(span.end_s, scan.stamp_s);
    ++span.scans;
  });
  return span;
}

std::vector<opal::Pose2> odometry_of(const RecordedLog& log) {
  std::vector<opal::Pose2> poses;
  for (const opal::LogRecord& record : log.records) {
    if (const auto* odometry = std::get_if<opal::OdometryRecord>(&record)) poses.push_back(odometry->T_odom_base);
    if (const auto* scan = std::get_if<opal::RawScan>(&record); scan && scan->T_odom_base)
      poses.push_back(*scan->T_odom_base);
  }
  return poses;
}

bool stands_still(const std::vector<opal::Pose2>& poses) {
  return std::ranges::all_of(poses, [&](const opal::Pose2& pose) {
    return distance_m(pose, poses.front()) == 0 && pose.heading_rad() == poses.front().heading_rad();
  });
}

std::size_t returns_in(const RecordedLog& log, double no_return_m) {
  std::size_t count = 0;
  for_each_scan(log, [&](const opal::RawScan& scan) {
    count += static_cast<std::size_t>(std::ranges::count_if(
        scan.ranges_m, [&](float range_m) { return range_m > 0 && opal::is_below(range_m, no_return_m); }));
  });
  return count;
}

/// What is so far or farther: how much of all readings, and how many different ranges.
struct Beyond {
  double share = 0;
  std::set<int> different_cm;
};

Beyond beyond(const RecordedLog& log, double limit_m) {
  Beyond beyond;
  double readings = 0, far = 0;
  for_each_scan(log, [&](const opal::RawScan& scan) {
    readings += static_cast<double>(scan.ranges_m.size());
    for (const float range_m : scan.ranges_m) {
      if (!std::isfinite(range_m) || opal::is_below(range_m, limit_m)) continue;
      ++far;
      beyond.different_cm.insert(static_cast<int>(std::min(100.0 * range_m, 1e9)));
    }
  });
  beyond.share = readings > 0 ? far / readings : 0;
  return beyond;
}

/// A laser says few different things where nothing returns. Empty: that is so.
std::string doubt_of_limits(const RecordedLog& log, const opal::LaserModel& laser) {
  constexpr std::size_t kManyDifferent = 100;
  const bool ends_before = laser.range_max_m < laser.no_return_m;
  const double least_share = ends_before ? 0.4 : 0.02;  // hits that are far may be left out, not most of them
  const double limit_m = ends_before ? laser.range_max_m : laser.no_return_m;
  const Beyond far = beyond(log, limit_m);
  if (far.share < least_share || far.different_cm.size() < kManyDifferent) return "";
  return fmt::format(
      "{:.0f} of 100 readings are {}, {:g} m, or farther, and they have {} different ranges up to {:.2f} m: "
      "they look like returns",
      100 * far.share, ends_before ? "range_max_m" : "no_return_m", limit_m, far.different_cm.size(),
      0.01 * *far.different_cm.rbegin());
}

}  // namespace

RecordedLog read_recorded_log(const opal::PluginRegistry& registry, const std::string& file,
                              const opal::Deployment& deployment, const std::vector<std::string>& words) {
  const auto reader = session::open_log(registry, file, deployment, words);
  RecordedLog log{file, opal::read_all(*reader), reader->defects()};
  if (holds_scan(log)) return log;
  std::string found = fmt::format("{} records of odometry or mounts", log.records.size());
  for (const auto& [cause, count] : log.defects) found += fmt::format(", {} times '{}'", count, cause);
  throw opal::LogError(file + ": no scan that can be read; found " + found + ", expected scans of a planar laser");
}

std::vector<std::string> doubts_of(const RecordedLog& log, const opal::LaserModel& laser) {
  constexpr std::size_t kFewest = 10;  // scans that say something about a log
  std::vector<std::string> doubts;
  const Span span = span_of(log);
  if (span.scans < kFewest) return doubts;
  const std::vector<opal::Pose2> odometry = odometry_of(log);
  if (odometry.empty())
    doubts.emplace_back("holds no odometry, expected poses of the wheels' odometry");
  else if (stands_still(odometry))
    doubts.push_back(fmt::format("odometry never moves in {} scans, expected a robot that drives", span.scans));
  if (returns_in(log, laser.no_return_m) == 0)
    doubts.push_back(
        fmt::format("no beam of {} scans returns from nearer than no_return_m, {:g} m; expected ranges in metres",
                    span.scans, laser.no_return_m));
  else if (std::string doubt = doubt_of_limits(log, laser); !doubt.empty())
    doubts.push_back(std::move(doubt));
  return doubts;
}

void expect_scans(const std::vector<opal::Query>& queries, const RecordedLog& log, const std::string& file) {
  for (const opal::Query& query : queries) {
    bool is_covered = false;
    for_each_scan(log, [&](const opal::RawScan& scan) {
      is_covered = is_covered || (scan.stamp_s >= query.start_s && scan.stamp_s <= query.end_s);
    });
    if (!is_covered)
      throw opal::ConfigError(file + ": query '" + query.id + "' " +
                              fmt::format("from {:.1f} to {:.1f} s", query.start_s, query.end_s) + " has no scan of " +
                              log.file + ", expected times from " + span_of(log).text());
  }
}

void expect_overlap(const opal::GroundTruth& truth, const RecordedLog& log, const std::string& file) {
  bool is_covered = false;
  for_each_scan(log, [&](const opal::RawScan& scan) {
    is_covered = is_covered || truth.T_map_laser_at(scan.stamp_s).has_value();
  });
  if (is_covered) return;
  const Span covered{truth.poses().front().stamp_s, truth.poses().back().stamp_s, truth.poses().size()};
  throw opal::ConfigError(file + ": covers " + covered.text() + " and no scan of " + log.file +
                          ", expected times from " + span_of(log).text());
}

}  // namespace opal::benchmark
