#include "tests/localization/decision/watched_robot.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::kidnapping;

namespace {

constexpr double kTemperingWeight = 0.1;
constexpr double kUsualShare = 0.9;

/// A robot that stands so close to each place before that ten scans are one piece of evidence.
Watch slow_robot(const KidnappingOptions& options) {
  Watch watch;
  watch.detector = KidnapDetector(options, kDetectorMemory);
  watch.tempering_weight = kTemperingWeight;
  return watch;
}

void see_usual(Watch& watch, int scans, double scan_nat) {
  for (int k = 0; k < scans; ++k) watch.see(scan_nat, kUsualShare);
}

}  // namespace

TEST_CASE("a scan that says less than half and shows less than usual again is a kidnapping, where that is asked for") {
  struct Case {
    double doubted_share, scan_nat, match_share;
    bool is_suspected, is_broken;
  };
  const Case seen = GENERATE(Case{0.75, kBad_nat, 0.6, true, true}, Case{0.75, 0.4 * kGood_nat, 0.6, true, true},
                             Case{0.75, 0.6 * kGood_nat, 0.6, false, false}, Case{0.75, kBad_nat, 0.7, false, false},
                             Case{0, kBad_nat, 0.6, false, false});
  CAPTURE(seen.doubted_share, seen.scan_nat, seen.match_share);
  KidnappingOptions options;
  options.doubted_share = seen.doubted_share;
  Watch watch = slow_robot(options);
  see_usual(watch, 60, kGood_nat);
  watch.see(seen.scan_nat, seen.match_share);
  CHECK(watch.detector.is_broken() == seen.is_broken);
  see_usual(watch, 5, kBad_nat);
  CHECK(watch.detector.suspected().has_value() == seen.is_suspected);
}

TEST_CASE("fair scans after a break do not hide a kidnapping before they are enough new evidence") {
  struct Case {
    double doubted_weight;
    int fair_scans;
    bool is_suspected;
  };
  const Case seen =
      GENERATE(Case{0, 1, true}, Case{0, 3, false}, Case{2, 3, true}, Case{2, 15, true}, Case{2, 25, false});
  CAPTURE(seen.doubted_weight, seen.fair_scans);
  KidnappingOptions options;
  options.doubted_weight = seen.doubted_weight;
  Watch watch = slow_robot(options);
  see_usual(watch, 60, kGood_nat);
  const KeyframeId last_good = watch.keyframe;
  watch.see(0.4 * kGood_nat, 0);
  see_usual(watch, seen.fair_scans, kGood_nat);
  see_usual(watch, 5, kBad_nat);
  const auto takeover = watch.detector.suspected();
  REQUIRE(takeover.has_value() == seen.is_suspected);
  if (takeover && seen.doubted_weight > 0) CHECK(takeover->keyframe == last_good);
}

TEST_CASE("a detector that is reset has forgotten the break") {
  KidnappingOptions options;
  options.doubted_weight = 2;
  Watch watch = slow_robot(options);
  see_usual(watch, 60, kGood_nat);
  watch.see(0.4 * kGood_nat, 0);
  watch.detector.reset();
  see_usual(watch, 5, kGood_nat);
  see_usual(watch, 5, kBad_nat);
  CHECK_FALSE(watch.detector.suspected());
}
