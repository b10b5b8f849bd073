#include "tests/localization/decision/watched_robot.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using namespace opal;
using namespace opal::kidnapping;

TEST_CASE("a hypothesis that was never believed is no place to be kidnapped from") {
  Watch watch;
  for (int k = 0; k < 20; ++k) watch.see(kBad_nat, 0, false);
  CHECK_FALSE(watch.detector.suspected());
  CHECK(watch.detector.probability() < 0.01);
}

TEST_CASE("good scans raise no suspicion, even one that continues nothing") {
  Watch watch;
  watch.see_good(10);
  watch.see(kGood_nat, 0);
  watch.see_good(1);
  CHECK_FALSE(watch.detector.suspected());
  CHECK(watch.detector.probability() < 0.01);
}

TEST_CASE("one bad scan that continues those before it is no reason to search") {
  Watch watch;
  watch.see_good(10);
  watch.see_bad(1);
  CHECK_FALSE(watch.detector.suspected());
  CHECK(watch.detector.probability() < 0.01);
}

TEST_CASE("who is put into a room of the same shape is kidnapped: the map explains far less of it at once") {
  constexpr MapAgreement kSound{0.9, 0.05}, kOtherRoom{0.45, 0.5};
  Watch watch;
  for (int k = 0; k < 20; ++k) watch.see(kGood_nat, 1, true, kSound);
  for (int k = 0; k < 6; ++k) watch.see(kBad_nat, 1, true, kOtherRoom);
  CHECK(watch.detector.suspected());
  CHECK(watch.detector.probability() > 0.8);
}

TEST_CASE("who sees the map explain less and less is not kidnapped") {
  Watch watch;
  for (int k = 0; k < 20; ++k) watch.see(kGood_nat, 1, true, {0.9, 0.05});
  for (double passed = 0.1; passed < 0.5; passed += 0.03) watch.see(kBad_nat, 1, true, {0.95 - passed, passed});
  CHECK_FALSE(watch.detector.suspected());
}

TEST_CASE("who drives into a part that the map has wrong is not kidnapped, however long it lasts") {
  Watch watch;
  watch.see_good(10);
  watch.see_bad(50);
  CHECK_FALSE(watch.detector.suspected());
  CHECK(watch.detector.probability() < 0.5);
}

TEST_CASE("who drives 20 m past things that hide all walls is not kidnapped, however often the laser looks") {
  constexpr double kDriven_m = 20, kNothing_nat = 0;
  for (const int scans : {20, 140, 400}) {
    CAPTURE(scans);
    Watch watch;
    watch.see_good(10);
    watch.tempering_weight = kDriven_m / TemperingOptions{}.distance_m / scans;
    for (int k = 0; k < scans; ++k) watch.see(kNothing_nat);
    CHECK(watch.detector.probability() < 1 - StatusOptions{}.localized_probability);
  }
}

TEST_CASE("after a break each scan counts in full, however close it was taken") {
  Watch watch;
  watch.see_good(10);
  watch.tempering_weight = 0.1;
  watch.be_kidnapped(3);
  CHECK(watch.detector.suspected());
}

TEST_CASE("bad scans after one that continues nothing are a kidnapping after the last good scan") {
  Watch watch;
  watch.see_good(10);
  const KeyframeId last_good = watch.keyframe;
  const double gathered_nat = watch.gathered_nat;
  watch.be_kidnapped(3);
  const auto takeover = watch.detector.suspected();
  REQUIRE(takeover);
  CHECK(takeover->keyframe == last_good);
  CHECK(takeover->nat < gathered_nat + KidnappingOptions{}.prior_nat);  // the price, and one place of many
  watch.see_bad(4);
  CHECK(watch.detector.probability() > 0.9);
}

TEST_CASE("what a takeover inherits fades while suspicion lasts, as tracking lets it fade") {
  Watch watch;
  watch.see_good(30);
  watch.be_kidnapped(3);
  const auto early = watch.detector.suspected();
  watch.see_bad(10);
  const auto late = watch.detector.suspected();
  REQUIRE((early && late));
  CHECK(late->keyframe == early->keyframe);
  CHECK(late->nat < early->nat);
}

TEST_CASE("good scans take suspicion back, whatever has gathered") {
  Watch watch;
  watch.see_good(10);
  watch.be_kidnapped(100);
  REQUIRE(watch.detector.suspected());
  watch.see_good(10);
  CHECK_FALSE(watch.detector.suspected());
  CHECK(watch.detector.probability() < 0.01);
}

TEST_CASE("suspicion once raised goes on though the hypothesis is no longer believed") {
  Watch watch;
  watch.see_good(10);
  watch.see(kBad_nat, 0);
  for (int k = 0; k < 5; ++k) watch.see(kBad_nat, 1, false);
  CHECK(watch.detector.suspected());
}

TEST_CASE("a place that looks alike by chance is suspect after a scan that continues nothing, and else it is not") {
  constexpr double kAlike_nat = 0.4;  // more than nothing, much less than usual
  Watch kidnapped, driving;
  for (Watch* watch : {&kidnapped, &driving}) watch->see_good(60);
  kidnapped.see(kAlike_nat, 0);
  driving.see(kAlike_nat);
  for (int k = 0; k < 20; ++k)
    for (Watch* watch : {&kidnapped, &driving}) watch->see(kAlike_nat);
  CHECK(kidnapped.detector.suspected());
  CHECK_FALSE(driving.detector.suspected());
  CHECK(driving.detector.probability() < 0.01);
}

TEST_CASE("the probability of a kidnapping grows with every bad scan and shrinks with every good one") {
  Watch watch;
  watch.see_good(10);
  watch.see(kBad_nat, 0);
  double before = watch.detector.probability();
  for (int k = 0; k < 10; ++k) {
    watch.see_bad(1);
    CHECK(watch.detector.probability() >= before);
    before = watch.detector.probability();
  }
  for (int k = 0; k < 10; ++k) {
    watch.see_good(1);
    CHECK(watch.detector.probability() <= before);
    before = watch.detector.probability();
  }
}

TEST_CASE("worse scans make a kidnapping no less probable") {
  double before = 0;
  for (const double nat : {2.0, 1.0, 0.0, -0.5, -1.0, -2.0, -20.0}) {
    Watch watch;
    watch.see_good(10);
    watch.see(nat, 0);
    watch.see(nat);
    CHECK(watch.detector.probability() >= before);
    before = watch.detector.probability();
  }
}

TEST_CASE("the probability of a kidnapping is one, whatever was seen") {
  const unsigned seed = GENERATE(1u, 2u, 3u);
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> nat(-30, 30), share(0, 1);
  Watch watch;
  for (int k = 0; k < 300; ++k) {
    const double seen_nat = nat(random), seen_share = share(random);
    watch.see(seen_nat, seen_share, random() % 2 == 0);
    const double probability = watch.detector.probability();
    CHECK((std::isfinite(probability) && probability >= 0 && probability <= 1));
    if (watch.detector.suspected()) CHECK(watch.detector.suspected()->keyframe < watch.keyframe);
  }
}

TEST_CASE("a scan alarms where it says much less than usual") {
  Watch watch;
  watch.see_good(60);
  CHECK_FALSE(watch.detector.alarming(kGood_nat));
  CHECK_FALSE(watch.detector.alarming(0.8));  // nearly half of it
  CHECK(watch.detector.alarming(0));
  CHECK(watch.detector.alarming(kBad_nat));
}

TEST_CASE(
    "a scan breaks off if it shows much less of what was seen before than scans usually do, however much that is") {
  const double usual = GENERATE(0.4, 0.6, 1.0);
  Watch watch;
  for (int k = 0; k < 10; ++k) {
    watch.see(kGood_nat, usual);
    CHECK_FALSE(watch.detector.is_broken());
  }
  watch.see(kGood_nat, 0.6 * usual);
  CHECK_FALSE(watch.detector.is_broken());
  watch.see(kGood_nat, 0.2 * usual);
  CHECK(watch.detector.is_broken());
  watch.see(kGood_nat, usual);
  CHECK_FALSE(watch.detector.is_broken());
}

TEST_CASE("who sees little of the same from scan to scan for good gets used to it") {
  Watch watch;
  watch.see_good(10);
  int broken = 0;
  for (int k = 0; k < 20; ++k) {
    watch.see(kGood_nat, 0.2);
    broken += watch.detector.is_broken();
  }
  CHECK(broken > 0);
  CHECK(broken < 10);
}

TEST_CASE("a detector that is reset suspects nothing and knows of no usual scan") {
  Watch watch;
  watch.see_good(60);
  watch.be_kidnapped(10);
  watch.detector.reset();
  CHECK_FALSE(watch.detector.suspected());
  CHECK(watch.detector.probability() == KidnapDetector(KidnappingOptions{}, kDetectorMemory).probability());
  CHECK_FALSE(watch.detector.alarming(0));
  watch.see_bad(1);
  CHECK_FALSE(watch.detector.suspected());
}

TEST_CASE("a place where the robot was kidnapped to is not asked for what another place used to say") {
  Watch watch;
  for (int k = 0; k < 30; ++k) watch.see(10 * kGood_nat);
  watch.be_kidnapped(10);
  REQUIRE(watch.detector.is_suspicious());
  watch.take_over();
  watch.see_good(2);
  CHECK_FALSE(watch.detector.is_suspicious());
  CHECK(watch.detector.probability() < 0.01);
  CHECK_FALSE(watch.detector.alarming(kGood_nat));
}

TEST_CASE("until a kidnapping is settled, other candidates may rest on it, too") {
  Watch watch;
  watch.see_good(10);
  const KeyframeId last_good = watch.keyframe;
  watch.be_kidnapped(10);
  watch.take_over();
  watch.see_good(3);
  REQUIRE(watch.detector.suspected());
  CHECK(watch.detector.suspected()->keyframe == last_good);
  watch.kidnapped_after = {};
  watch.detector.settle(5);
  watch.see_good(1);
  CHECK_FALSE(watch.detector.suspected());
}

TEST_CASE("a second kidnapping is one from the place of the first") {
  Watch watch;
  watch.see_good(10);
  watch.be_kidnapped(10);
  watch.take_over();
  watch.see_good(10);
  const KeyframeId last_good = watch.keyframe;
  watch.be_kidnapped(10);
  CHECK(watch.detector.is_suspicious());
  REQUIRE(watch.detector.suspected());
  CHECK(watch.detector.suspected()->keyframe == last_good);
}

TEST_CASE("a hypothesis that is the best one again is as suspicious as it was") {
  Watch watch;
  watch.see_good(10);
  watch.be_kidnapped(10);
  const double before = watch.detector.probability();
  watch.take_over();
  watch.see_good(5);
  watch.kidnapped_after = {};
  watch.see_bad(1);
  CHECK(watch.detector.is_suspicious());
  CHECK(watch.detector.probability() >= before);
}
