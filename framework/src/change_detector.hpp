#pragma once

#include <opal/association.hpp>

#include <optional>

namespace opal {

/// Asks after every scan whether the robot has been carried away: a cumulative sum test (Page 1954) of "the best
/// hypothesis was right up to some scan, and no scan since then was taken where it says" against "it is right".
class ChangeDetector {
 public:
  explicit ChangeDetector(const AssociationOptions& options) : options_(options) {}

  /// @param keyframe   number of the scan, increasing.
  /// @param scan_nat   what it says for the best hypothesis.
  /// @param gathered_nat  what the best hypothesis has gathered, this scan included.
  /// @param novelty    how much of a new piece of evidence the scan is, in (0, 1].
  /// @param established  it had been believed before the scan; suspicion begins with nothing else.
  void add(int keyframe, double scan_nat, double gathered_nat, double novelty, bool established);
  void reset();

  /// Evidence that the robot has been carried away at the time that explains it best [nat], at least 0.
  double suspicion_nat() const { return suspicion_nat_; }
  /// The probability of that, its prior included.
  double probability() const;
  /// Whether a scan that says this would be reason enough to look at it.
  bool alarming(double scan_nat) const;

  /// The time that explains it best.
  struct Break {
    int keyframe = 0;  ///< the last one before
    double nat = 0;    ///< what a hypothesis starts with that takes over from the best one then, the price of being
                       ///< carried away, and to this place of all places, included
  };
  /// Where there is reason to search the whole map anew.
  std::optional<Break> suspected() const;

 private:
  AssociationOptions options_;
  double suspicion_nat_ = 0;
  Break last_good_;
};

}  // namespace opal
