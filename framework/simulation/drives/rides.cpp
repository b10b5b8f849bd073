#include "simulation/drives/rides.hpp"

#include "map_tools/map_stack.hpp"

#include <opal/common/error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace opal::simulation {
namespace {

constexpr double kNear_m = 2.5;  // of the lift: the cabin is there

/// Walls about the landing, open towards +x of its frame. Where the map has the shaft, they are there only while the
/// door is closed.
class Cabin {
 public:
  Cabin(const Pose2& T_map_cabin, const RideDriveOptions& options)
      : middle_(T_map_cabin.position()), is_shaft_mapped_(options.is_shaft_mapped) {
    const double h = options.cabin_m / 2, d = options.door_width_m / 2;
    const auto wall = [&](const Point& from, const Point& to) {
      walls_.push_back({T_map_cabin * from, T_map_cabin * to});
    };
    wall({-h, -h}, {-h, h});
    wall({-h, -h}, {h, -h});
    wall({-h, h}, {h, h});
    wall({h, -h}, {h, -d});
    wall({h, d}, {h, h});
    door_ = {T_map_cabin * Point(h, -d), T_map_cabin * Point(h, d)};
  }

  bool is_near(const Pose2& T_map_base) const { return (T_map_base.position() - middle_).norm() < kNear_m; }

  /// Beams end at the cabin where it is before what they met.
  void stand_before(RawScan& scan, const Pose2& T_map_laser, const LaserModel& laser, bool is_closed) const {
    if (is_shaft_mapped_ && !is_closed) return;
    for (std::size_t beam = 0; beam < scan.ranges_m.size(); ++beam) {
      const double bearing_rad = laser.angle_min_rad + static_cast<double>(beam) * laser.angle_increment_rad;
      const Point along = T_map_laser.rotate(unit_vector(bearing_rad));
      double range_m = is_closed ? range_to(door_, T_map_laser.position(), along) : kFar_m;
      for (const Segment& wall : walls_) range_m = std::min(range_m, range_to(wall, T_map_laser.position(), along));
      float& read_m = scan.ranges_m[beam];
      if (range_m < laser.range_max_m && !(read_m > 0 && read_m < range_m)) read_m = static_cast<float>(range_m);
    }
  }

 private:
  static constexpr double kFar_m = std::numeric_limits<double>::infinity();

  static double range_to(const Segment& wall, const Point& from, const Point& along) {
    const Point way = wall.end - wall.begin;
    const double slope = cross(along, way);
    if (std::abs(slope) < 1e-9) return kFar_m;
    const double range_m = cross(wall.begin - from, way) / slope, share = cross(wall.begin - from, along) / slope;
    return range_m > 0 && share >= 0 && share <= 1 ? range_m : kFar_m;
  }

  Point middle_;
  bool is_shaft_mapped_;
  std::vector<Segment> walls_;
  Segment door_;
};

const Landing& landing_on(const MapConnection& lift, const std::string& storey) {
  for (const Landing& landing : lift.landings)
    if (landing.storey == storey) return landing;
  throw ConfigError("lift '" + lift.id + "': no landing on '" + storey + "', expected one of its storeys");
}

/// Appends what one robot records later: time goes on, and so does odometry.
void append_leg(Recording& all, Recording more, double later_s, const Pose2& T_odom_odom) {
  for (RecordedScan& recorded : more.scans) {
    carry_on(recorded.scan, later_s, T_odom_odom);
    if (!all.scans.empty() && recorded.scan.stamp_s <= all.scans.back().scan.stamp_s) continue;  // where legs meet
    all.scans.push_back(std::move(recorded));
  }
  for (double driven_m : more.distances_m) all.distances_m.back() += driven_m;
  all.stops += more.stops;
}

/// A robot that stands and looks.
Recording stand(Simulation& simulation, double duration_s, double scan_every_s) {
  Recording recording;
  for (double end_s = simulation.now_s() + duration_s; simulation.now_s() + scan_every_s <= end_s;) {
    simulation.drive({}, scan_every_s);
    recording.scans.push_back({simulation.scan(), simulation.T_map_base()});
  }
  return recording;
}

/// Places to go to, until the way is long enough.
std::vector<Point> tour(const Simulation& simulation, Point from, double length_m, Random& random) {
  std::vector<Point> places;
  for (int k = 0; k < 50 && length_m > 0; ++k) {
    const Point next = simulation.floor().anywhere(random);
    const auto way = simulation.floor().way(from, next);
    if (!way) continue;
    for (std::size_t i = 1; i < way->size(); ++i) length_m -= ((*way)[i] - (*way)[i - 1]).norm();
    places.push_back(next);
    from = next;
  }
  return places;
}

class RideDrive {
 public:
  RideDrive(const SemanticMap& building, const SimulationOptions& world, const MapConnection& lift,
            const std::string& from, const std::string& to, const RideDriveOptions& options, std::uint64_t seed)
      : options_(options),
        random_(seed),
        T_map_from_(landing_on_map(building, landing_on(lift, from))),
        T_map_to_(landing_on_map(building, landing_on(lift, to))),
        below_(storey_of_map(building, from), world, seed),
        above_(storey_of_map(building, to), world, seed + 1) {
    made_.ride = {lift.id, from, to};
  }

  std::optional<RideRecording> run() {
    const auto in = below_.floor().nearest(T_map_from_.position()), out = above_.floor().nearest(T_map_to_.position());
    if (!in || !out) return std::nullopt;
    drive_in(*in);
    if (distance_m(below_.T_map_base(), T_map_from_) > options_.cabin_m / 2) return std::nullopt;
    ride();
    drive_on();
    put_cabin();
    return std::move(made_);
  }

 private:
  Recording& recording() { return made_.recording; }

  void drive_in(const Point& cabin) {
    below_.place({below_.floor().anywhere(random_), random_.uniform(-std::numbers::pi, std::numbers::pi)});
    std::vector<Point> places = tour(below_, below_.T_map_base().position(), options_.before_m, random_);
    places.push_back(cabin);
    const double most_s = 60 + 8 * (options_.before_m + 100) / options_.drive.follower.speed_mps;
    recording() = record_way(below_, places, most_s, options_.drive);
    made_.ride.stands_s = below_.now_s();
  }

  void ride() {
    append_leg(recording(), stand(below_, options_.door_s, options_.drive.scan_every_s), 0, Pose2());
    made_.ride.closes_s = below_.now_s();
    const Pose2 T_odom_before = below_.T_odom_base();
    above_.place(T_map_to_ * T_map_from_.inverse() * below_.T_map_base());
    T_odom_odom_ = T_odom_before * above_.T_odom_base().inverse();
    later_s_ = below_.now_s() - above_.now_s();
    append_leg(recording(), stand(above_, options_.closed_s, options_.drive.scan_every_s), later_s_, T_odom_odom_);
    made_.ride.opens_s = above_.now_s() + later_s_;
    append_leg(recording(), stand(above_, options_.door_s, options_.drive.scan_every_s), later_s_, T_odom_odom_);
    made_.ride.leaves_s = above_.now_s() + later_s_;
  }

  void drive_on() {
    const std::vector<Point> places = tour(above_, above_.T_map_base().position(), options_.after_m, random_);
    const double most_s = 60 + 4 * options_.after_m / options_.drive.follower.speed_mps;
    append_leg(recording(), record_way(above_, places, most_s, options_.drive), later_s_, T_odom_odom_);
    recording().queries.back().end_s = recording().scans.back().scan.stamp_s;
  }

  /// The robot came in through the door, and goes out through it.
  void put_cabin() {
    const auto& scans = recording().scans;
    Pose2 before = scans.front().T_map_base;
    for (const RecordedScan& scan : scans) {
      if (scan.scan.stamp_s >= made_.ride.stands_s) break;
      if (distance_m(scan.T_map_base, T_map_from_) > options_.cabin_m) before = scan.T_map_base;
    }
    const Point outwards = before.position() - T_map_from_.position();
    const double heading_rad = std::atan2(outwards.y(), outwards.x());
    const Pose2 T_map_cabin(T_map_from_.position(), heading_rad);
    const Cabin below(T_map_cabin, options_), above(T_map_to_ * T_map_from_.inverse() * T_map_cabin, options_);
    bool has_left = false;
    for (RecordedScan& scan : recording().scans) {
      const double stamp_s = scan.scan.stamp_s;
      const bool is_above = stamp_s > made_.ride.closes_s;
      const Cabin& cabin = is_above ? above : below;
      has_left = has_left || (stamp_s > made_.ride.leaves_s && !cabin.is_near(scan.T_map_base));
      if (has_left || !cabin.is_near(scan.T_map_base)) continue;
      cabin.stand_before(scan.scan, scan.T_map_base * recording().laser.T_base_laser, recording().laser,
                         stamp_s > made_.ride.closes_s && stamp_s <= made_.ride.opens_s);
    }
  }

  RideDriveOptions options_;
  Random random_;
  Pose2 T_map_from_, T_map_to_;
  Simulation below_, above_;
  RideRecording made_;
  Pose2 T_odom_odom_;
  double later_s_ = 0;
};

}  // namespace

std::optional<RideRecording> record_ride(const SemanticMap& building, const SimulationOptions& world,
                                         const MapConnection& lift, const std::string& from, const std::string& to,
                                         const RideDriveOptions& options, std::uint64_t seed) {
  return RideDrive(building, world, lift, from, to, options, seed).run();
}

}  // namespace opal::simulation
