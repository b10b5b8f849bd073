#include "filter.hpp"
#include "recorded_scan.hpp"

#include <opal/common/error.hpp>
#include "evaluation/site.hpp"

#include <CLI/CLI.hpp>

#include <ctime>
#include <fstream>
#include <iostream>

namespace {

struct Options {
  std::string map, log, laser, out;
  std::string motion = "omni-corrected";
  std::vector<double> region;
  std::uint32_t seed = 1;
  FilterOptions filter;
  LikelihoodFieldOptions field;
};

double cpu_ms() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

/// Whether the robot has moved enough since an update (AMCL asks for each axis).
bool is_far(const opal::Pose2& from, const opal::Pose2& to, const FilterOptions& options) {
  return std::abs(to.x() - from.x()) > options.update_m || std::abs(to.y() - from.y()) > options.update_m ||
         std::abs(opal::wrap_angle(to.heading_rad() - from.heading_rad())) > options.update_rad;
}

void run(const Options& options) {
  const auto grid = mrpt::maps::COccupancyGridMap2D::Create();
  if (!grid->loadFromROSMapServerYAML(options.map))
    throw opal::MapError(options.map + ": cannot be read as a map of ROS map_server");
  const opal::LaserModel laser = opal::read_site_laser(options.laser);
  LikelihoodField field(*grid, options.field);
  std::optional<Region> region;
  if (!options.region.empty()) region = {{options.region[0], options.region[1]}, options.region[2]};
  ParticleFilter filter(grid, field, options.filter, region, options.seed);
  std::ofstream out(options.out);
  out << "timestamp,x,y,theta,localized,hypotheses,cpu_ms\n";
  out.precision(10);
  std::optional<opal::Pose2> T_odom_laser;  // at the last update
  opal::Pose2 T_map_laser;
  bool localized = false;
  for (const RecordedScan& scan : read_scans(options.log)) {
    const double before_ms = cpu_ms();
    const bool updates = !T_odom_laser || is_far(*T_odom_laser, scan.T_odom_laser, options.filter);
    if (updates) {
      field.take(scan.ranges_m, laser);
      filter.update(T_odom_laser ? T_odom_laser->inverse() * scan.T_odom_laser : opal::Pose2());
      T_odom_laser = scan.T_odom_laser;
      T_map_laser = filter.best();
      localized = filter.localized();
    }
    const opal::Pose2 now = T_map_laser * (T_odom_laser->inverse() * scan.T_odom_laser);
    out << scan.stamp_s << ',' << now.x() << ',' << now.y() << ',' << now.heading_rad() << ',' << localized << ','
        << filter.particles() << ',' << (updates ? cpu_ms() - before_ms : 0) << '\n';
  }
  if (!out.flush()) throw opal::Error(options.out + ": cannot be written");
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("MRPT's particle filter on a recorded log, with the parameters of Hendrikx (2023), table 3.2");
  app.add_option("--map", options.map, "grid map (yaml of ROS map_server)")->required();
  app.add_option("--log", options.log, "CARMEN log (.log, .log.gz)")->required();
  app.add_option("--laser", options.laser, "the laser (.info.json)")->required();
  app.add_option("--out", options.out, "table to write: timestamp,x,y,theta,localized,hypotheses,cpu_ms")->required();
  app.add_option("--region", options.region, "X,Y,R: the robot starts in this circle [m]")->delimiter(',')->expected(3);
  app.add_option("--seed", options.seed, "of the particles")->capture_default_str();
  app.add_option("--particles", options.filter.most_particles, "at most, and at first")
      ->capture_default_str()
      ->check(CLI::Range(100, 1000000));
  app.add_option("--beams", options.field.beams, "of each scan that count")
      ->capture_default_str()
      ->check(CLI::Range(2, 10000));
  app.add_option("--motion", options.motion, "odometry model, as AMCL has them")
      ->capture_default_str()
      ->check(CLI::IsMember({"omni", "omni-corrected"}));
  CLI11_PARSE(app, argc, argv);
  options.filter.motion.variance_as_deviation = options.motion == "omni";
  try {
    run(options);
  } catch (const std::exception& error) {
    std::cerr << "particle_filter: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
