#pragma once

#include <opal/deployment/deployment.hpp>
#include <opal/plugin/plugin_registry.hpp>
#include <opal/sensing/log_source.hpp>
#include "evaluation/ground_truth.hpp"
#include "evaluation/site.hpp"

#include <map>
#include <string>
#include <vector>

namespace opal::benchmark {

/// A log that a command plays, all of it.
struct RecordedLog {
  std::string file;
  std::vector<opal::LogRecord> records;
  std::map<std::string, int> defects;  ///< what was skipped, by cause
};

/// @throws opal::LogError naming the file if it cannot be read, or holds no scan.
/// @param deployment  says how its log sources are to read. @param words  NAME=VALUE, over these.
RecordedLog read_recorded_log(const opal::PluginRegistry& registry, const std::string& file,
                              const opal::Deployment& deployment, const std::vector<std::string>& words = {});

/// What a log has that is hardly what its maker wanted, as sentences: a robot that never moves, a laser that never sees
/// anything.
std::vector<std::string> doubts_of(const RecordedLog& log, const opal::LaserModel& laser);

/// @param file  of the queries, for the message.
/// @throws opal::ConfigError if a query has no scan of the log.
void expect_scans(const std::vector<opal::Query>& queries, const RecordedLog& log, const std::string& file);

/// @param file  of the truth, for the message.
/// @throws opal::ConfigError if the truth covers no scan of the log.
void expect_overlap(const opal::GroundTruth& truth, const RecordedLog& log, const std::string& file);

}  // namespace opal::benchmark
