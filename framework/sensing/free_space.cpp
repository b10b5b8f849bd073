#include <opal/sensing/free_space.hpp>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/point_xy.hpp>

#include <algorithm>

namespace opal {
namespace {

namespace bg = boost::geometry;
using BoostPoint = bg::model::d2::point_xy<double>;
using BoostLine = bg::model::linestring<BoostPoint>;

struct Beam {
  double bearing_rad;
  double range_m;
};

std::vector<Beam> beams_of(const Scan& scan, double reach_m) {
  std::vector<Beam> beams;
  for (const ScanPoint& point : scan.points) beams.push_back({point.bearing_rad, std::min(point.range_m, reach_m)});
  const double free_m = std::min(scan.range_max_m, reach_m);
  for (double bearing : scan.free_bearings_rad) beams.push_back({bearing, free_m});
  std::ranges::sort(beams, {}, &Beam::bearing_rad);
  return beams;
}

/// The ends of beams between two gaps, simplified, in the laser's frame.
void append_run(const BoostLine& run, double tolerance_m, std::vector<Point>& outline) {
  BoostLine simple;
  bg::simplify(run, simple, tolerance_m);
  for (const BoostPoint& p : simple) outline.emplace_back(p.x(), p.y());
}

}  // namespace

std::vector<Point> free_space_outline(const Scan& scan, const Pose2& T_base_laser, const FreeSpaceOptions& options) {
  const std::vector<Beam> beams = beams_of(scan, options.reach_m);
  if (beams.size() < 2) return {};
  const double two_pi = 2 * std::numbers::pi;
  const bool all_round = beams.front().bearing_rad + two_pi - beams.back().bearing_rad <= options.gap_rad;
  std::vector<Point> outline;
  if (!all_round) outline.push_back(Point::Zero());
  BoostLine run;
  for (std::size_t k = 0; k < beams.size(); ++k) {
    if (k > 0 && beams[k].bearing_rad - beams[k - 1].bearing_rad > options.gap_rad) {
      append_run(run, options.tolerance_m, outline);
      outline.push_back(Point::Zero());
      run.clear();
    }
    const Point end = beams[k].range_m * unit_vector(beams[k].bearing_rad);
    run.emplace_back(end.x(), end.y());
  }
  append_run(run, options.tolerance_m, outline);
  for (Point& p : outline) p = T_base_laser * p;
  return outline;
}

}  // namespace opal
