#pragma once

#include <opal/common/export.hpp>
#include <opal/sensing/log_source.hpp>
#include <opal/sensing/sample.hpp>

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace opal {

/// What counts as odd in what a robot says, and how long a scan waits.
struct PairingOptions {
  double gap_s = 2.0;            ///< records farther apart than this are counted as a gap
  double odometry_wait_s = 1.0;  ///< a scan takes odometry that is at most this much older or newer, if it is
                                 ///< not between two odometry records
  double clock_reset_s = 1.0;    ///< a sensor's stamp that steps back by more than this starts a new timeline
  double max_speed_mps = 3.0;    ///< odometry that moves farther than this speed makes plausible,
  double max_turn_radps = 6.0;   ///< or turns more,
  double jump_m = 1.0;           ///< by more than this, has jumped. Lost records and coarse stamps look like jumps:
  double jump_rad = 1.5;         ///< in the csail and belgioioso logs true motion exceeds the speeds by 0.4 m, 0.6 rad
  bool bridge_jumps = true;      ///< a jump is taken for a new odometry frame in which the robot stands still
  double laser_wait_s = 0.2;     ///< a scan waits for those of other lasers that are due by at most this much
  std::size_t most_waiting = 256;  ///< scans; when one more comes, the oldest leaves with the odometry that there is
};

/// Pairs scans with the odometry at their stamps, as records come: late, doubled, out of order or not at all. A scan
/// waits until the odometry has passed the end of its sweep; then every return is moved to where it was at the scan's
/// stamp (LaserModel::sweep_s). Of several lasers, scans that begin within half an interval of each other make one
/// sample; nobody waits for a laser that has fallen silent. Nothing in the records makes it fail: what was odd is
/// counted, and the next good record goes on. Memory is bounded by PairingOptions::most_waiting.
class OPAL_EXPORT ScanPairing {
 public:
  /// @param lasers  that the scans come from, told apart by LaserModel::frame; a single one without a frame takes all.
  /// @param options  what counts as odd, and how long a scan waits.
  explicit ScanPairing(std::vector<LaserModel> lasers, const PairingOptions& options = {});
  ~ScanPairing();
  /// Takes over another pairing, which must not be used any more.
  ScanPairing(ScanPairing&&) noexcept;
  /// Takes over another pairing, which must not be used any more.
  ScanPairing& operator=(ScanPairing&&) noexcept;

  /// The next record, in the order of arrival.
  void take(const LogRecord& record);
  /// No more records will come: what still waits may leave.
  void finish();
  /// @return the next sample, by increasing stamp within a timeline; nullopt if none is ready.
  std::optional<Sample> next();

  /// How often something odd was met so far, by cause: "clock reset", "odometry stamp steps back", "scan stamp steps
  /// back", "scan out of order" (put in order), "repeated odometry stamp", "repeated scan stamp", "doubled scan" (left
  /// out), "gap", "odometry jump", "scan without odometry" (left out), "scan without a valid beam" (passed on), "too
  /// many scans wait for odometry", "scan of a laser that is not described" (left out), "time_increment ...".
  const std::map<std::string, int>& counts() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace opal
