#pragma once

#include <opal/live/health.hpp>
#include <opal/localization/localizer.hpp>
#include <opal/sensing/scan_pairing.hpp>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace opal {

/// What is known after a scan.
struct LiveAnswer {
  std::uint64_t number = 0;  ///< counts the answers from 1; 0: there is none yet
  double stamp_s = 0;        ///< of the newest scan that it rests on
  PoseEstimate estimate;     ///< at that stamp; frame `map`
  /// From odometry, as it was received, to the map; it holds until the next answer. Meaningless without a pose.
  Pose2 T_map_odom;
  std::string why;                    ///< why the status is what it is, in words
  std::vector<HealthFinding> health;  ///< what is not fine
  double latency_s = 0;               ///< from the arrival of the scan to the answer
  double waited_s = 0;                ///< part of it: for the odometry at the scan, and for other lasers' scans
};

/// When streams of records count as ill, and how many records wait.
struct LiveOptions {
  PairingOptions pairing{};        ///< of scans with odometry, and of several lasers
  double silent_after_s = 1;       ///< a sensor that says nothing for longer, and for five of its intervals, is silent
  double missing_after_s = 3;      ///< a sensor that has said nothing since the first record is missing
  double late_s = 0.5;             ///< records arrive later than this after their stamps: doubtful
  double early_s = 0.1;            ///< records arrive earlier than this before their stamps: two clocks differ
  double told_for_s = 3;           ///< what was odd in the records is told for so long
  std::size_t most_queued = 2000;  ///< records (hints, too); when one more comes, the oldest one is dropped and counted
};

/// Localizes in a thread of its own. Records may come from any thread, early, late, doubled, out of order or not at
/// all. Whoever gives records waits for nobody, and nobody who reads answers is waited for. Memory is bounded.
class OPAL_EXPORT LiveLocalizer {
 public:
  /// @param parts  of the localizer. @param options  bounds and limits.
  /// @param events  told from the localizing thread; may be null, else it must outlive the localizer.
  explicit LiveLocalizer(LocalizerParts parts, const LiveOptions& options = {}, EventSink* events = nullptr);
  /// Ends the thread after the record that it works on.
  ~LiveLocalizer();
  LiveLocalizer(const LiveLocalizer&) = delete;
  LiveLocalizer& operator=(const LiveLocalizer&) = delete;

  /// A record that has arrived now.
  /// @param record  odometry, a scan (RawScan::frame tells of which laser), a mount (left out: parts have them), or
  ///                what somebody says: it holds from the next scan on.
  /// @param now_s  by the clock that stamps are made with, by which late stamps are noticed; NaN: not known.
  void take(LogRecord record, double now_s = std::numeric_limits<double>::quiet_NaN());
  /// The robot may be here. It is one more place to look at, and is believed only as far as scans support it.
  void hint(const PoseHint& hint) { take(HintRecord{0, hint}); }
  /// As if nothing had been seen.
  void reset() { take(ForgetRecord{}); }

  /// The newest answer; its number is 0 before the first one. Health is as of now.
  LiveAnswer newest() const;
  /// Waits for an answer with a higher number.
  /// @return nullopt if there is none within `timeout_s`.
  std::optional<LiveAnswer> newer_than(std::uint64_t number, double timeout_s) const;
  /// Waits until all records that were taken so far have been worked on. @return false if the time is up.
  bool drain(double timeout_s) const;
  /// How often something odd was met, by cause: those of ScanPairing, "dropped from a full queue".
  std::map<std::string, int> counts() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace opal
