#include <opal/sensing/replay.hpp>

#include <catch2/catch.hpp>

#include <limits>

namespace {

using namespace opal;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

OdometryRecord odometry(double stamp_s, double x_m, double heading_rad = 0) {
  return {stamp_s, Pose2(x_m, 0, heading_rad)};
}

RawScan scan_at(double stamp_s, float range_m = 2) {
  RawScan raw;
  raw.stamp_s = stamp_s;
  raw.ranges_m.assign(361, range_m);
  return raw;
}

RawScan scan_with_odometry(double stamp_s, double x_m) {
  RawScan raw = scan_at(stamp_s);
  raw.T_odom_base = Pose2(x_m, 0, 0);
  return raw;
}

struct Played {
  std::vector<Sample> samples;
  std::map<std::string, int> counts;
};

Played play(const std::vector<LogRecord>& records, const ReplayOptions& options = {}) {
  Replay replay(records, {LaserModel{}}, options);
  Played played{read_all(replay), {}};
  played.counts = replay.counts();
  CHECK(replay.progress() == 1.0);
  return played;
}

using Counts = std::map<std::string, int>;

/// A robot that drives 1 m/s; odometry every 0.1 s, a scan every 0.5 s, `fault` put in at 5 s.
std::vector<LogRecord> drive(const std::vector<LogRecord>& fault = {}) {
  std::vector<LogRecord> records;
  for (int tick = 0; tick <= 100; ++tick) {
    records.push_back(odometry(tick * 0.1, tick * 0.1));
    if (tick == 50) records.insert(records.end(), fault.begin(), fault.end());
    if (tick % 5 == 0) records.push_back(scan_at(tick * 0.1));
  }
  return records;
}

class ListReader final : public LogReader {
 public:
  explicit ListReader(std::vector<LogRecord> records) : records_(std::move(records)) {}
  std::optional<LogRecord> next() override {
    return position_ < records_.size() ? std::optional(records_[position_++]) : std::nullopt;
  }
  std::map<std::string, int> defects() const override { return {{"malformed line", 3}}; }
  double progress() const override { return 0.25; }

 private:
  std::vector<LogRecord> records_;
  std::size_t position_ = 0;
};

}  // namespace

TEST_CASE("odometry is interpolated at the scan's stamp, even if it comes late") {
  const auto played = play({odometry(1, 0, 3.0), scan_at(1.25), odometry(2, 4, -3.0), scan_at(2)});
  REQUIRE(played.samples.size() == 2);
  CHECK(played.samples[0].views.front().scan.stamp_s == 1.25);
  CHECK(played.samples[0].T_odom_base.x() == Approx(1));
  const double across_pi = 3.0 + 0.25 * (2 * std::numbers::pi - 6.0);  // the short way round
  CHECK(played.samples[0].T_odom_base.heading_rad() == Approx(wrap_angle(across_pi)));
  CHECK(played.samples[1].T_odom_base.x() == Approx(4));
  CHECK(played.counts == Counts{});
}

TEST_CASE("odometry recorded with the scan wins over what stands around it") {
  const auto played = play({odometry(1, 0), scan_with_odometry(1.5, 0.7), odometry(2, 1)});
  REQUIRE(played.samples.size() == 1);
  CHECK(played.samples[0].T_odom_base.x() == Approx(0.7));
}

TEST_CASE("a clean drive has no counts") {
  const auto played = play(drive());
  CHECK(played.samples.size() == 21);
  CHECK(played.counts == Counts{});
}

TEST_CASE("each fault of a log is survived, counted under its name, and harms nothing after it") {
  struct Fault {
    std::string name;
    std::vector<LogRecord> records;
    Counts counts;
    std::size_t samples;
  };
  const auto fault = GENERATE(values<Fault>({
      {"odometry steps back", {odometry(4.5, 4.5)}, {{"odometry stamp steps back", 1}}, 21},
      {"a scan steps back", {scan_at(4.4)}, {{"scan stamp steps back", 1}}, 21},
      {"odometry repeats its stamp", {odometry(5.0, 5.0)}, {{"repeated odometry stamp", 1}}, 21},
      {"a scan repeats its stamp", {scan_at(5.0, 3)}, {{"repeated scan stamp", 1}}, 22},
      {"a scan comes twice", {scan_at(5.0)}, {{"doubled scan", 1}}, 21},
      {"odometry jumps away and back", {odometry(5.05, 90)}, {{"odometry jump", 2}}, 21},
      {"odometry is NaN", {odometry(5.05, kNan)}, {{"odometry that is not finite", 1}}, 21},
      {"odometry has no stamp", {odometry(kNan, 5)}, {{"odometry that is not finite", 1}}, 21},
      {"a scan has no stamp", {scan_at(kNan)}, {{"scan stamp that is not finite", 1}}, 21},
      {"a scan is all zeros", {scan_at(5.0, 0)}, {{"repeated scan stamp", 1}, {"scan without a valid beam", 1}}, 22},
      {"a scan is all NaN", {scan_at(4.9f, NAN)}, {{"scan without a valid beam", 1}}, 22},
      {"a scan is all negative", {scan_at(4.9f, -1)}, {{"scan without a valid beam", 1}}, 22},
      {"a scan is all maximum", {scan_at(4.9f, 81.91f)}, {}, 22},
      {"a scan is empty", {RawScan{4.9, {}, {}, {}, {}, {}, 0}}, {{"scan without a valid beam", 1}}, 22},
      {"one stamp is far in the past", {odometry(-900, 5)}, {{"clock reset", 1}, {"gap", 1}}, 21},
      {"one stamp is far in the future", {odometry(9000, 5)}, {{"clock reset", 1}, {"gap", 1}}, 21},
  }));
  INFO(fault.name);
  const auto played = play(drive(fault.records));
  CHECK(played.counts == fault.counts);
  REQUIRE(played.samples.size() == fault.samples);
  CHECK(played.samples.back().views.front().scan.stamp_s == Approx(10));
  CHECK(played.samples.back().T_odom_base.x() == Approx(10).margin(0.25));
}

TEST_CASE("a jump of the odometry is a new frame, in which the robot goes on from where it was") {
  auto records = drive();
  for (LogRecord& record : records)
    if (auto* reset = std::get_if<OdometryRecord>(&record); reset && reset->stamp_s > 4.95)
      reset->T_odom_base = Pose2(reset->stamp_s - 5.0, 30, 1.0);
  const auto bridged = play(records);
  CHECK(bridged.counts == Counts{{"odometry jump", 1}});
  const auto step_m = [](const Played& played, std::size_t i) {
    return distance_m(played.samples[i - 1].T_odom_base, played.samples[i].T_odom_base);
  };
  for (std::size_t i = 1; i < bridged.samples.size(); ++i) {
    CAPTURE(i);
    CHECK(step_m(bridged, i) <= 0.5 + 1e-9);
  }
  ReplayOptions as_recorded;
  as_recorded.pairing.bridge_jumps = false;
  const auto raw = play(records, as_recorded);
  CHECK(raw.counts == Counts{{"odometry jump", 1}});
  CHECK(raw.samples.back().T_odom_base.y() == Approx(30));
}

TEST_CASE("a scan out of reach of the odometry is left out and counted") {
  const auto played = play({scan_at(0.5), odometry(10, 0), scan_at(9.5), scan_at(10.5), scan_at(12.5)});
  REQUIRE(played.samples.size() == 2);
  CHECK(played.samples[0].views.front().scan.stamp_s == 9.5);  // nearest odometry, in reach
  CHECK(played.samples[1].views.front().scan.stamp_s == 10.5);
  CHECK(played.counts.at("scan without odometry") == 2);
  const auto blind = play({scan_at(1), scan_at(2)});
  CHECK(blind.samples.empty());
  CHECK(blind.counts.at("scan without odometry") == 2);
}

TEST_CASE("a gap is counted and passed") {
  const auto played = play({odometry(0, 0), scan_at(0), odometry(60, 5), scan_at(60)});
  CHECK(played.samples.size() == 2);
  CHECK(played.counts == Counts{{"gap", 1}});
}

TEST_CASE("a clock that is set back starts a new timeline, and no scan is lost") {
  auto records = drive();
  for (const LogRecord& record : drive()) records.push_back(record);  // begins anew at 0
  for (std::size_t i = drive().size(); i < records.size(); ++i)
    if (auto* later = std::get_if<OdometryRecord>(&records[i]))
      later->T_odom_base = Pose2(later->T_odom_base.x() + 10, 0, 0);
  const auto played = play(records);
  CHECK(played.counts == Counts{{"clock reset", 1}});
  REQUIRE(played.samples.size() == 42);
  CHECK(played.samples.back().T_odom_base.x() == Approx(20));
}

TEST_CASE("a window sees nothing of what is outside of it") {
  ReplayOptions window;
  window.from_s = 3.0;
  window.to_s = 4.7;
  std::vector<LogRecord> records = drive();
  for (LogRecord& record : records)  // outside, the robot is elsewhere
    if (auto* outside = std::get_if<OdometryRecord>(&record);
        outside && (outside->stamp_s < 2.99 || outside->stamp_s > 4.71))
      outside->T_odom_base = Pose2(1000, 0, 0);
  const auto played = play(records, window);
  CHECK(played.counts == Counts{});
  REQUIRE(played.samples.size() == 4);
  CHECK(played.samples.front().views.front().scan.stamp_s == Approx(3.0));
  CHECK(played.samples.back().views.front().scan.stamp_s == Approx(4.5));
  CHECK(played.samples.back().T_odom_base.x() == Approx(4.5));
}

TEST_CASE("replaying a reader is replaying its records, with its defects among the counts") {
  Replay replay(std::make_unique<ListReader>(drive()), {LaserModel{}});
  CHECK(replay.progress() == 0.25);
  CHECK(read_all(replay).size() == 21);
  CHECK(replay.counts() == Counts{{"malformed line", 3}});
  ListReader reader(drive());
  CHECK(read_all(reader).size() == drive().size());
}

TEST_CASE("an empty log gives no sample") { CHECK(play({}).samples.empty()); }

TEST_CASE("beam geometry and mount are taken from the log only where model and log say so") {
  RawScan raw = scan_at(1);
  raw.frame = "front_laser";
  raw.angle_min_rad = -1.0;
  raw.angle_increment_rad = 0.01;
  const std::vector<LogRecord> records{MountRecord{"base", "camera", Pose2(9, 9, 0)},
                                       MountRecord{"base", "front_laser", Pose2(0.3, 0, 1.5)}, scan_at(0), raw};
  LaserModel model;
  CHECK(with_log_geometry(model, records).T_base_laser.x() == 0);
  model.geometry_from_log = true;
  const LaserModel stated = with_log_geometry(model, records);
  CHECK(stated.T_base_laser.x() == 0.3);
  CHECK(stated.T_base_laser.heading_rad() == 1.5);
  CHECK(stated.angle_min_rad == -1.0);
  CHECK(stated.beams == 361);
  CHECK(with_log_geometry(model, {}).beams == model.beams);
}
