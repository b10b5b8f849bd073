#pragma once

#include <opal/sensing/scan.hpp>

#include <deque>
#include <map>
#include <optional>

namespace opal {

/// What the ranges of the newest scans have in common, seen from different poses. What a laser did long ago does not
/// hide what it does now.
class OPAL_EXPORT RangeHabits {
 public:
  static constexpr int kScans = 300;  ///< that are looked at: 30 m of driving, as the sensor monitor takes them

  void add(const Scan& scan);
  void clear() { *this = {}; }

  /// How many are looked at now, at most kScans.
  int scans() const { return static_cast<int>(newest_.size()); }
  /// Share of all beams that were a hit; 1 before the first scan.
  double usable_share() const;
  /// Share of the scans in which several beams have the very same range, the farthest of the scan, and that range.
  struct Repeated {
    double range_m = 0;
    double scan_share = 0;     ///< of the scans
    double beam_share = 0;     ///< of the beams in these scans
    double farther_share = 0;  ///< of the scans with a hit: their farthest range is 1 % farther, or more
  };
  /// None if no range is like that in five scans.
  std::optional<Repeated> repeated_farthest() const;

 private:
  struct ScanRanges {
    int beams = 0, hits = 0;
    double farthest_m = 0;
    int so_far = 0;  ///< beams that have the farthest range
    bool repeats() const;
  };
  void count(const ScanRanges& ranges, int sign);

  std::deque<ScanRanges> newest_;
  int beams_ = 0, hits_ = 0;
  std::map<double, int> repeated_;  ///< scans, by the farthest range that several of their beams have [m]
};

}  // namespace opal
