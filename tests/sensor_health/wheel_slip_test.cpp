#include "sensor_health/wheel_slip.hpp"

#include <catch2/catch.hpp>

using namespace opal;

namespace {

/// Ten steps of these lengths in all.
void go(WheelSlip& slip, double by_odometry_m, double by_scans_m) {
  for (int step = 0; step < 10; ++step) slip.add(by_odometry_m / 10, by_scans_m / 10);
}

std::optional<SensorFinding> after(double by_odometry_m, double by_scans_m) {
  WheelSlip slip;
  go(slip, by_odometry_m, by_scans_m);
  return slip.finding();
}

}  // namespace

TEST_CASE("wheels that count more or less than scans move are noticed, with the share between them") {
  const auto spinning = after(1.5, 0.9), sliding = after(0.9, 1.5), frozen = after(0, 1.5);
  REQUIRE((spinning && sliding && frozen));
  CHECK(spinning->subject == SensorFinding::Subject::odometry_distance);
  CHECK(spinning->verdict == SensorFinding::Verdict::doubtful);
  CHECK(spinning->found == Approx(0.6));
  CHECK(spinning->described == 1);
  CHECK(sliding->found == Approx(1.5 / 0.9));
  CHECK(frozen->found == 0);
  CHECK_THAT(spinning->words, Catch::Contains("odometry counts 1.5 m where scans move by 0.9 m"));
}

TEST_CASE("no slip is told while both agree, of less than a metre, of less than 0.4 m, or of less than a third") {
  CHECK_FALSE(WheelSlip().finding());
  CHECK_FALSE(after(1.8, 1.8));
  CHECK_FALSE(after(0.9, 0));
  CHECK(after(1.1, 0));
  CHECK_FALSE(after(1.1, 0.8));
  CHECK_FALSE(after(1.95, 1.52));
  CHECK(after(1.95, 1.45));
}

TEST_CASE("a slip counts over the last two metres") {
  WheelSlip slip;
  go(slip, 1, 0.1);
  go(slip, 0.8, 0.8);
  REQUIRE(slip.finding());
  CHECK(slip.finding()->found == Approx(0.5));
  go(slip, 1.2, 1.2);
  CHECK_FALSE(slip.finding());

  WheelSlip by_scans;
  go(by_scans, 0.1, 1);
  go(by_scans, 2, 2);
  CHECK_FALSE(by_scans.finding());
}

TEST_CASE("a slip from before a new beginning is forgotten") {
  WheelSlip slip;
  go(slip, 1.5, 0.1);
  slip.clear();
  CHECK_FALSE(slip.finding());
  go(slip, 1, 1);
  CHECK_FALSE(slip.finding());
}
