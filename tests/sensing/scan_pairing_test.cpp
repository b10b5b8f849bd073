#include <opal/sensing/scan_pairing.hpp>

#include <catch2/catch.hpp>

namespace {

using namespace opal;

constexpr double kPi = std::numbers::pi;

LaserModel all_around(double sweep_s) {
  LaserModel laser;
  laser.angle_min_rad = -kPi;
  laser.angle_increment_rad = kPi / 180;
  laser.beams = 360;
  laser.range_max_m = 50;
  laser.T_base_laser = Pose2(0.3, 0.1, 0.2);
  laser.sweep_s = sweep_s;
  return laser;
}

/// Of a robot that turns and drives evenly.
Pose2 driven(double time_s) { return {0.8 * time_s, 0.1 * time_s, 1.2 * time_s}; }

/// What the laser measures of a round room about the origin of odom, beam after beam.
RawScan sweep_at(double stamp_s, const LaserModel& laser) {
  constexpr double kRadius_m = 10;
  RawScan raw;
  raw.stamp_s = stamp_s;
  for (int beam = 0; beam < laser.beams; ++beam) {
    const double now_s = stamp_s + *laser.sweep_s * beam / (laser.beams - 1);
    const Pose2 T_odom_laser = driven(now_s) * laser.T_base_laser;
    const Point& from = T_odom_laser.position();
    const Point along = T_odom_laser.rotate(unit_vector(laser.angle_min_rad + beam * laser.angle_increment_rad));
    const double half = from.dot(along);
    raw.ranges_m.push_back(
        static_cast<float>(-half + std::sqrt(half * half - from.squaredNorm() + kRadius_m * kRadius_m)));
  }
  return raw;
}

OdometryRecord odometry_at(double stamp_s) { return {stamp_s, driven(stamp_s)}; }

/// How far returns lie from the wall of the room, at worst [m].
double worst_off_m(const Sample& sample, const LaserModel& laser) {
  double worst = 0;
  for (const ScanPoint& point : sample.views.front().scan.points)
    worst = std::max(worst, std::abs((sample.T_odom_base * laser.T_base_laser * point.position).norm() - 10));
  return worst;
}

RawScan plain(double stamp_s, float range_m = 2) {
  RawScan raw;
  raw.stamp_s = stamp_s;
  raw.ranges_m.assign(361, range_m);
  return raw;
}

std::vector<double> stamps_of(ScanPairing& pairing) {
  std::vector<double> stamps;
  while (const auto sample = pairing.next()) stamps.push_back(sample->stamp_s);
  return stamps;
}

}  // namespace

TEST_CASE("a scan leaves as soon as odometry has passed the end of its sweep") {
  const LaserModel laser = all_around(0.1);
  ScanPairing pairing({laser});
  pairing.take(odometry_at(0.95));
  pairing.take(sweep_at(1.0, laser));
  pairing.take(odometry_at(1.05));
  CHECK_FALSE(pairing.next());
  pairing.take(odometry_at(1.15));
  CHECK(pairing.next());
}

TEST_CASE("a scan has the laser's mount to the last digit, whatever the robot's pose") {
  LaserModel laser = all_around(0);
  laser.T_base_laser = Pose2(0.31, -0.07, 0.3);
  ScanPairing pairing({laser});
  for (int k = 0; k < 20; ++k) {
    const double now_s = 1 + 0.37 * k;
    for (const double late_s : {0., 0.1}) pairing.take(odometry_at(now_s + late_s));
    pairing.take(sweep_at(now_s + 0.05, laser));
    const auto sample = pairing.next();
    REQUIRE(sample);
    const Pose2& mount = sample->views.front().T_base_laser;
    CHECK(mount.position() == laser.T_base_laser.position());
    CHECK(mount.heading_rad() == laser.T_base_laser.heading_rad());
  }
}

TEST_CASE("returns of a sweep lie where they were at the scan's stamp, and are smeared if it is said to take no time") {
  LaserModel laser = all_around(0.1);
  const RawScan raw = sweep_at(1.0, laser);
  const bool is_corrected = GENERATE(true, false);
  if (!is_corrected) laser.sweep_s = 0;
  ScanPairing pairing({laser});
  for (double stamp_s : {0.95, 1.0, 1.03, 1.06, 1.09, 1.12}) pairing.take(odometry_at(stamp_s));
  pairing.take(raw);
  const auto sample = pairing.next();
  REQUIRE(sample);
  REQUIRE(sample->views.front().scan.points.size() == 360);
  CHECK(sample->T_odom_base.heading_rad() == Approx(1.2));
  if (is_corrected)
    CHECK(worst_off_m(*sample, laser) < 0.001);
  else
    CHECK(worst_off_m(*sample, laser) > 0.05);
  for (std::size_t k = 1; k < sample->views.front().scan.points.size(); ++k)
    CHECK(sample->views.front().scan.points[k - 1].bearing_rad <= sample->views.front().scan.points[k].bearing_rad);
}

TEST_CASE("beams that met nothing are turned as the returns between them are") {
  LaserModel laser = all_around(0.1);
  laser.range_max_m = 9.9;  // of the round room only the near side is in reach
  RawScan raw = sweep_at(1.0, laser);
  for (float& range_m : raw.ranges_m) range_m = 90;
  raw.ranges_m[180] = 5;
  ScanPairing pairing({laser});
  for (double stamp_s : {0.9, 1.2}) pairing.take(odometry_at(stamp_s));
  pairing.take(raw);
  const auto sample = pairing.next();
  REQUIRE(sample);
  REQUIRE(sample->views.front().scan.free_bearings_rad.size() == 359);
  const double turned_rad = 1.2 * 0.1;
  CHECK(sample->views.front().scan.free_bearings_rad.front() == Approx(-kPi).margin(1e-6));
  CHECK(sample->views.front().scan.free_bearings_rad.back() < kPi);
  // The last beams turned on beyond the first ones.
  const auto beyond = std::ranges::count_if(sample->views.front().scan.free_bearings_rad,
                                            [&](double bearing) { return bearing < -kPi + turned_rad - kPi / 180; });
  CHECK(beyond > 7);
}

TEST_CASE("the log's own time between beams holds where the laser's description gives none") {
  LaserModel laser = all_around(0.1);
  RawScan raw = sweep_at(1.0, laser);
  raw.time_increment_s = 0.1 / 359;
  laser.sweep_s.reset();
  ScanPairing pairing({laser});
  for (double stamp_s : {0.95, 1.05, 1.15}) pairing.take(odometry_at(stamp_s));
  pairing.take(raw);
  CHECK(worst_off_m(*pairing.next(), laser) < 0.001);
}

TEST_CASE("sweeps of a log whose only odometry is that of its scans are corrected by those before and after") {
  const LaserModel laser = all_around(0.1);
  ScanPairing pairing({laser});
  double worst = 0;
  int samples = 0;
  for (int k = 0; k < 10; ++k) {
    RawScan raw = sweep_at(0.2 * k, laser);
    raw.T_odom_base = driven(raw.stamp_s);
    pairing.take(raw);
    while (const auto sample = pairing.next()) {
      worst = std::max(worst, worst_off_m(*sample, laser));
      ++samples;
    }
  }
  CHECK(samples == 9);
  CHECK(worst < 0.001);
  pairing.finish();
  CHECK(pairing.next());
}

TEST_CASE("scans that come in another order leave in the order of their stamps, if they are still waited with") {
  ScanPairing pairing({LaserModel{}});
  pairing.take(odometry_at(0.9));
  for (double stamp_s : {1.1, 1.0, 1.2}) pairing.take(plain(stamp_s, static_cast<float>(stamp_s)));
  pairing.take(odometry_at(1.3));
  CHECK(stamps_of(pairing) == std::vector{1.0, 1.1, 1.2});
  CHECK(pairing.counts() == std::map<std::string, int>{{"scan out of order", 1}});
  pairing.take(plain(1.05));
  CHECK(stamps_of(pairing).empty());
  CHECK(pairing.counts().at("scan stamp steps back") == 1);
}

TEST_CASE("a scan that comes twice counts once") {
  ScanPairing pairing({LaserModel{}});
  pairing.take(odometry_at(0.9));
  pairing.take(plain(1));
  pairing.take(plain(1));
  pairing.take(plain(1, 3));  // another scan with the same stamp: coarse stamps have such
  pairing.take(odometry_at(1.3));
  CHECK(stamps_of(pairing) == std::vector{1.0, 1.0});
  CHECK(pairing.counts() == std::map<std::string, int>{{"doubled scan", 1}, {"repeated scan stamp", 1}});
}

TEST_CASE("however many scans come without odometry, few wait") {
  PairingOptions options;
  options.most_waiting = 8;
  options.odometry_wait_s = 1e6;
  ScanPairing pairing({LaserModel{}}, options);
  int left = 0;
  for (int k = 0; k < 1000; ++k) {
    pairing.take(plain(k * 0.1, 1 + static_cast<float>(k) * 0.01f));
    left += static_cast<int>(stamps_of(pairing).size());
  }
  CHECK(left == 0);
  CHECK(pairing.counts().at("too many scans wait for odometry") == 992);
  CHECK(pairing.counts().at("scan without odometry") == 992);
}

TEST_CASE("scans of before a clock went back leave with what was known then") {
  ScanPairing pairing({LaserModel{}});
  pairing.take(odometry_at(100));
  pairing.take(plain(100.1));
  pairing.take(odometry_at(0.5));
  pairing.take(plain(0.6, 3));
  pairing.take(odometry_at(0.7));
  CHECK(stamps_of(pairing) == std::vector{100.1, 0.6});
  CHECK(pairing.counts().at("clock reset") == 1);
}

TEST_CASE("a scan is that of the laser whose frame it names; a single laser without a frame takes any") {
  const auto left_of = [](const std::vector<std::string>& frames, const std::string& named) {
    std::vector<LaserModel> lasers;
    for (const std::string& frame : frames) lasers.emplace_back().frame = frame;
    ScanPairing pairing(lasers);
    pairing.take(odometry_at(0.9));
    RawScan raw = plain(1);
    raw.frame = named;
    pairing.take(raw);
    pairing.finish();
    return stamps_of(pairing).size();
  };
  CHECK(left_of({""}, "rear") == 1);
  CHECK(left_of({"front"}, "front") == 1);
  CHECK(left_of({"front"}, "rear") == 0);
  CHECK(left_of({"front", "rear"}, "rear") == 1);
  CHECK(left_of({"front", ""}, "rear") == 0);
}

TEST_CASE("over a clock reset nobody knows how long the robot drove: what is farther than a jump is one") {
  ScanPairing pairing({LaserModel{}});
  pairing.take(OdometryRecord{100, Pose2()});
  pairing.take(plain(100));
  pairing.take(OdometryRecord{60, Pose2(5, 0, 0)});
  CHECK(pairing.counts().at("clock reset") == 1);
  CHECK(pairing.counts().at("odometry jump") == 1);
  pairing.take(OdometryRecord{65, Pose2(10, 0, 0)});  // from then on time tells again
  CHECK(pairing.counts().at("odometry jump") == 1);
}

TEST_CASE("two clocks that are apart are no clock that went back") {
  const double apart_s = GENERATE(-2.0, -1.2, 1.2, 2.0);
  ScanPairing pairing({LaserModel{}});
  std::size_t left = 0;
  for (int k = 0; k < 100; ++k) {
    pairing.take(odometry_at(100 + k * 0.1));
    pairing.take(plain(100 + k * 0.1 + apart_s, 1 + static_cast<float>(k) * 0.01f));
    left += stamps_of(pairing).size();
  }
  CHECK(pairing.counts().count("clock reset") == 0);
  // Odometry of the same stamp has come, or never will in time.
  CHECK(left + static_cast<std::size_t>(pairing.counts().count("scan without odometry")
                                            ? pairing.counts().at("scan without odometry")
                                            : 0) >=
        70);
}

TEST_CASE("a time between beams that is too long to be true holds no scan back, and is counted") {
  const double increment_s = GENERATE(25.0 / 359, 0.9 / 359, 0.14 / 359);  // of a laser that scans ten times a second
  LaserModel laser = all_around(0.1);
  laser.sweep_s.reset();
  ScanPairing pairing({laser});
  int left = 0;
  for (int k = 0; k < 40; ++k) {
    RawScan raw = sweep_at(1 + 0.1 * k, laser);
    raw.time_increment_s = increment_s;
    pairing.take(odometry_at(raw.stamp_s));
    pairing.take(raw);
    while (pairing.next()) ++left;
  }
  int counted = 0;
  for (const auto& [cause, times] : pairing.counts())
    if (cause.find("sensor.sweep_s") != std::string::npos) counted = times;
  // The rhythm is known after five intervals.
  CHECK(counted == (increment_s * 359 > 10 ? 40 : increment_s * 359 > 0.5 ? 35 : 0));
  CHECK(left >= 38);
}

TEST_CASE("a sweep that the deployment states holds, however soon the next scan comes") {
  const LaserModel laser = all_around(0.4);
  ScanPairing pairing({laser});
  for (int k = 0; k < 20; ++k) {
    const RawScan raw = sweep_at(1 + 0.1 * k, laser);
    pairing.take(odometry_at(raw.stamp_s));
    pairing.take(raw);
    stamps_of(pairing);
  }
  CHECK(pairing.counts().empty());
}
