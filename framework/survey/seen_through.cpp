#include "survey/seen_through.hpp"

#include <algorithm>

namespace opal {
namespace {

constexpr double kMetAcross_m = 0.15;  ///< across the surface; beams that end so near have met it
constexpr double kThrough_m = 0.3;     ///< beams that go on so far have not
constexpr double kEdge_m = 0.1;        ///< of a face, where a small error of the pose decides
constexpr double kLeastSlope = 0.2;    ///< between beam and face: grazing beams do not tell
constexpr int kBeamsForAll = 5;        ///< so many beams are a whole keyframe's worth

enum class Passage { nothing, met, through };

Passage passage(const Surface& surface, const Point& eye, const Point& p) {
  if (surface.is_circle()) {
    const Point way = (p - eye).normalized(), to_center = surface.origin - eye;
    if (way.dot(to_center) <= 0 || std::abs(cross(way, to_center)) > 0.7 * surface.size_m) return Passage::nothing;
    const double beyond = way.dot(p - surface.origin);
    if (beyond > surface.size_m + kThrough_m) return Passage::through;
    return std::abs(offset_from(surface, p).offset_m) < kMetAcross_m ? Passage::met : Passage::nothing;
  }
  const Point way = p - eye;
  const double slope = -surface.normal().dot(way);
  if (slope < kLeastSlope * way.norm()) return Passage::nothing;
  const SurfaceOffset at = offset_from(surface, p);
  const double to_face = offset_from(surface, eye).offset_m / slope;  // in units of `way`
  if (to_face <= 0) return Passage::nothing;
  const double along = offset_from(surface, eye + to_face * way).along_m;
  if (along < kEdge_m || along > surface.size_m - kEdge_m) return Passage::nothing;
  if (at.offset_m < -kThrough_m) return Passage::through;
  return std::abs(at.offset_m) < kMetAcross_m ? Passage::met : Passage::nothing;
}

}  // namespace

void count_seen(MapBelief& belief, const ExpectedFeatures& expected, std::span<const Point> points, const Point& laser,
                const Pose2& T_map_base) {
  struct Count {
    int met = 0, through = 0;
  };
  std::vector<Count> counts(expected.all().size());
  const Point eye = T_map_base * laser;
  for (const Point& point : points) {
    const Point p = T_map_base * point;
    for (int k : expected.towards(p - eye)) {
      const Passage what = passage(expected.all()[k].surface, eye, p);
      counts[k].met += what == Passage::met;
      counts[k].through += what == Passage::through;
    }
  }
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const auto [met, through] = counts[k];
    if (met + through == 0) continue;
    const double worth = std::min(1.0, (met + through) / static_cast<double>(kBeamsForAll)) / (met + through);
    FeatureBelief& feature = belief[expected.all()[k].number];
    feature.seen += worth * met;
    feature.seen_through += worth * through;
  }
}

double share_through(const ExpectedFeatures& expected, std::span<const Point> points, const Point& laser,
                     const Pose2& T_map_base) {
  const Point eye = T_map_base * laser;
  int through = 0;
  for (const Point& point : points) {
    const Point p = T_map_base * point;
    const auto passed = [&](int k) { return passage(expected.all()[k].surface, eye, p) == Passage::through; };
    const auto near = expected.towards(p - eye);
    through += std::any_of(near.begin(), near.end(), passed);
  }
  return points.empty() ? 0 : through / static_cast<double>(points.size());
}

}  // namespace opal
