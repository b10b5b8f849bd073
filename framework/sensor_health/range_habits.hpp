#pragma once

#include <opal/sensing/scan.hpp>

#include <map>
#include <optional>
#include <vector>

namespace opal {

/// What the ranges of many scans have in common, seen from different poses.
class OPAL_EXPORT RangeHabits {
 public:
  void add(const Scan& scan);
  void clear() { *this = {}; }

  int scans() const { return scans_; }
  /// Share of all beams that were a hit; 1 before the first scan.
  double usable_share() const;
  /// Share of the scans in which several beams have the very same range, the farthest of the scan, and that range.
  struct Repeated {
    double range_m = 0;
    double scan_share = 0;     ///< of the scans
    double beam_share = 0;     ///< of the beams in these scans
    double farther_share = 0;  ///< of the scans: their farthest range is 1 % farther, or more
  };
  /// None if no range is like that in five scans.
  std::optional<Repeated> repeated_farthest() const;

 private:
  struct Seen {
    int scans = 0;
    double beam_share = 0;
  };
  int scans_ = 0;
  double beams_ = 0, hits_ = 0;
  std::map<double, Seen> repeated_;  ///< the farthest range of a scan that several beams have, by range [m]
  std::vector<double> farthest_m_;   ///< of each scan
};

}  // namespace opal
