#pragma once

#include <opal/sensing/scan_pairing.hpp>

#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace opal {

/// Which part of a log is played, and what counts as odd in it.
struct ReplayOptions {
  double from_s = -std::numeric_limits<double>::infinity();  ///< records outside [from_s, to_s] are not looked at
  /// The end of the window, by the clock of the log.
  double to_s = std::numeric_limits<double>::infinity();
  PairingOptions pairing{};  ///< of scans with odometry
};

/// Turns the records of a log into samples, by increasing stamp within a timeline. Nothing in a log makes it fail:
/// what was odd is counted, and the next good record goes on.
class OPAL_EXPORT Replay {
 public:
  /// Plays a log from where its reader stands.
  Replay(std::unique_ptr<LogReader> reader, std::vector<LaserModel> lasers, const ReplayOptions& options = {});
  /// Plays records that were read before, e.g. many windows of one log. They must outlive the replay.
  Replay(std::span<const LogRecord> records, std::vector<LaserModel> lasers, const ReplayOptions& options = {});
  ~Replay();
  /// Takes over another replay, which must not be used any more.
  Replay(Replay&&) noexcept;
  /// Takes over another replay, which must not be used any more.
  Replay& operator=(Replay&&) noexcept;

  /// @return the next sample, or nullopt at the end. A scan waits until the odometry has passed it.
  std::optional<Sample> next();

  /// How often something odd was met so far, by cause: as ScanPairing::counts(), and the reader's own defects.
  std::map<std::string, int> counts() const;
  /// Share of the log already walked, in [0, 1].
  double progress() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// All remaining samples.
OPAL_EXPORT std::vector<Sample> read_all(Replay& replay);
/// All remaining records, in file order.
OPAL_EXPORT std::vector<LogRecord> read_all(LogReader& reader);

/// `laser` with the beam geometry of its first scan that states one, and with the mount that the log states for that
/// scan's frame; unchanged unless `laser.geometry_from_log`, and as far as the log states neither.
OPAL_EXPORT LaserModel with_log_geometry(const LaserModel& laser, std::span<const LogRecord> records);

}  // namespace opal
