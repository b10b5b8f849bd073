#include "simulation/simulation.hpp"

#include "simulation/along_walls.hpp"

#include <opal/common/error.hpp>

namespace opal::simulation {
namespace {

std::vector<Solid> joined(const std::vector<std::vector<Solid>>& pieces) {
  std::vector<Solid> solids;
  for (const auto& piece : pieces) solids.insert(solids.end(), piece.begin(), piece.end());
  return solids;
}

std::vector<Solid> with(std::vector<Solid> solids, const std::vector<Solid>& more) {
  solids.insert(solids.end(), more.begin(), more.end());
  return solids;
}

}  // namespace

LaserModel SimulationOptions::default_laser() {
  LaserModel laser;
  laser.angle_min_rad = -0.75 * std::numbers::pi;
  laser.angle_increment_rad = std::numbers::pi / 360;
  laser.beams = 541;
  laser.T_base_laser = Pose2(0.2, 0, 0);
  return laser;
}

Simulation::Simulation(std::shared_ptr<const SemanticMap> building, const SimulationOptions& options,
                       std::uint64_t seed)
    : building_(std::move(building)),
      options_(options),
      random_(seed),
      ground_(std::make_unique<const BuildingGround>(*building_, options_.outdoors)),
      solids_(furnished()),
      odometry_(options.drive, options.odometry_errors, random_.branch()) {
  for (int k = 0; k < options_.people; ++k) people_.emplace_back(*floor_, random_.branch());
  T_map_base_ = {floor_->anywhere(random_), random_.uniform(-std::numbers::pi, std::numbers::pi)};
}

/// The building with clutter that leaves most of its floor to drive on: if it does not, half of the pieces go, and so
/// on.
std::unique_ptr<const RayCaster> Simulation::furnished() {
  constexpr double kLeast = 0.6;
  Random doors = random_.branch(), furniture = random_.branch();
  const auto stays_shut = [&](const MapObject& object) { return ground_->is_shut_outer_door(*building_, object); };
  const std::vector<Solid> building = building_solids(*building_, options_.doors_open_share, doors, stays_shut);
  const std::vector<Solid> lasting =
      with(options_.furniture, joined(pieces_along_walls(*building_, options_.clutter.along_walls, furniture)));
  auto solids = std::make_unique<const RayCaster>(with(building, lasting));
  const Floor empty(*building_, *ground_, *solids, clearance_m());
  auto pieces = clutter_pieces(
      *building_, empty.area_m2(), options_.clutter, [&](Random& r) { return empty.anywhere(r); }, furniture);
  for (;; pieces.resize(pieces.size() / 2)) {
    clutter_ = with(lasting, joined(pieces));
    solids = std::make_unique<const RayCaster>(with(building, clutter_));
    try {
      floor_ = std::make_unique<const Floor>(*building_, *ground_, *solids, clearance_m());
    } catch (const MapError&) {
      if (pieces.empty()) throw;
      continue;
    }
    if (pieces.empty() || floor_->area_m2() > kLeast * empty.area_m2()) return solids;
  }
}

std::vector<Geometry> Simulation::unmapped() const {
  std::vector<Geometry> shapes;
  for (const Solid& solid : clutter_) shapes.push_back(solid.shape);
  for (const Solid& solid : solids_->solids())
    if (solid.open) shapes.push_back(solid.shape);
  return shapes;
}

std::optional<Contact> Simulation::contact(const Pose2& T_map_base) const {
  const int solid = solids_->touched(T_map_base.position(), options_.robot_radius_m);
  if (solid >= 0) return Contact{solids_->solids()[static_cast<std::size_t>(solid)].shape, false};
  for (const Walker& walker : people_)
    for (const Circle& leg : walker.legs())
      if ((leg.center - T_map_base.position()).norm() < leg.radius_m + options_.robot_radius_m)
        return Contact{leg, true};
  return std::nullopt;
}

/// One can go away from what one touches already.
bool Simulation::nears(const Geometry& touched, const Point& next) const {
  return distance_m(touched, next) < distance_m(touched, T_map_base_.position());
}

std::optional<Contact> Simulation::drive(const Velocity& velocity, double duration_s) {
  now_s_ += duration_s;
  for (Walker& walker : people_) walker.walk(duration_s, *floor_, {T_map_base_.position(), options_.robot_radius_m});
  Velocity possible = velocity;
  if (options_.drive == Drive::differential) possible.linear_mps.y() = 0;
  const Pose2 step = moved(possible, duration_s), next = T_map_base_ * step;
  if (distance_m(next, T_map_base_) > 0)
    if (auto touched = contact(next); touched && nears(touched->what, next.position())) return touched;
  T_map_base_ = next;
  odometry_.move(step);
  remember();
  return std::nullopt;
}

void Simulation::follow(const Pose2& T_map_base, double stamp_s) {
  const double duration_s = std::max(0.0, stamp_s - now_s_);
  for (Walker& walker : people_) walker.walk(duration_s, *floor_, {T_map_base_.position(), options_.robot_radius_m});
  odometry_.move(T_map_base_.inverse() * T_map_base);
  T_map_base_ = T_map_base;
  now_s_ = stamp_s;
  remember();
}

void Simulation::place(const Pose2& T_map_base) {
  T_map_base_ = T_map_base;
  moved_.clear();
  remember();
}

double Simulation::longest_sweep_s() const {
  double longest_s = options_.laser.sweep_s.value_or(0);
  for (const LaserModel& laser : options_.more_lasers) longest_s = std::max(longest_s, laser.sweep_s.value_or(0));
  return longest_s;
}

void Simulation::remember() {
  if (longest_sweep_s() > 0) moved_.add({now_s_, T_map_base_, T_odom_base()}, longest_sweep_s());
}

Pose2 Simulation::T_map_base_at(double stamp_s) const {
  return moved_.empty() ? T_map_base_ : moved_.at(stamp_s).T_map_base;
}

RawScan Simulation::scan(std::size_t number) {
  std::vector<Circle> legs;
  for (const Walker& walker : people_)
    for (const Circle& leg : walker.legs()) legs.push_back(leg);
  const LaserModel& laser = this->laser(number);
  const double sweep_s = laser.sweep_s.value_or(0);
  const double start_s = now_s_ - sweep_s, beam_s = sweep_s / std::max(1, laser.beams - 1);
  const auto path = [&](int beam) { return T_map_base_at(start_s + beam * beam_s) * laser.T_base_laser; };
  RawScan scan = swept(*solids_, legs, path, laser, options_.laser_errors, random_);
  scan.stamp_s = start_s;
  scan.frame = laser.frame;
  scan.T_odom_base = moved_.empty() ? T_odom_base() : moved_.at(start_s).T_odom_base;
  return scan;
}

}  // namespace opal::simulation
