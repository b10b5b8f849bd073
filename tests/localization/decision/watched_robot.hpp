#pragma once

#include "localization/decision/kidnap_detector.hpp"

namespace opal::kidnapping {

inline constexpr double kGood_nat = 2, kBad_nat = -1;
inline constexpr double kDetectorMemory = 0.99;

/// A robot with one hypothesis, scan after scan.
struct Watch {
  void see(double scan_nat, double match_share = 1, bool established = true, const MapAgreement& agreement = {}) {
    gathered_nat = kDetectorMemory * gathered_nat + scan_nat;
    keyframe = keyframe.next();
    detector.add(
        {keyframe, tempering_weight, match_share, agreement, scan_nat, gathered_nat, established, kidnapped_after});
  }
  void see_good(int scans) {
    for (int k = 0; k < scans; ++k) see(kGood_nat);
  }
  void see_bad(int scans) {
    for (int k = 0; k < scans; ++k) see(kBad_nat);
  }
  /// The scan continues nothing and fits nowhere, nor do those after it.
  void be_kidnapped(int scans_after) {
    see(kBad_nat, 0);
    see_bad(scans_after);
  }
  /// Another hypothesis is the best one from now on, by which the robot was kidnapped just now.
  void take_over() { kidnapped_after = keyframe; }
  KidnapDetector detector{KidnappingOptions{}, kDetectorMemory};
  KeyframeId keyframe{0};
  double tempering_weight = 1;
  double gathered_nat = 0;
  KeyframeId kidnapped_after;
};

}  // namespace opal::kidnapping
