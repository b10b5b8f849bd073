#pragma once

#include <opal/sensing/log_source.hpp>

#include <span>
#include <string>
#include <vector>

namespace opal {

/// The first scan of a laser that states its beam geometry; null if none does.
const RawScan* first_with_geometry(std::span<const LogRecord> records, const LaserModel& laser);

/// Holds what a log states of its laser against the description: the number of beams, their first angle and
/// increment. A description that takes its geometry from the log agrees with any log that states one.
/// @param described_in  what messages call the description: a file, and the place in it.
/// @param log           what they call the log.
/// @throws ConfigError that gives both numbers.
OPAL_EXPORT void check_log(std::span<const LogRecord> records, const LaserModel& laser, const std::string& log,
                           const std::string& described_in);

/// Lasers with what the log states of them (with_log_geometry), after check_log. One without a scan stays as it is
/// described: it may begin later, or have failed. It is left out if its geometry comes from its scans.
/// @throws ConfigError likewise, and where a laser has no scan while there are scans that none is described for, or
/// none at all of any described laser.
OPAL_EXPORT std::vector<LaserModel> lasers_of_log(std::span<const LogRecord> records, std::vector<LaserModel> described,
                                                  const std::string& log, const std::string& described_in);

/// The frames of described lasers that have no scan.
OPAL_EXPORT std::vector<std::string> silent_lasers(std::span<const LogRecord> records,
                                                   std::span<const LaserModel> described);

}  // namespace opal
