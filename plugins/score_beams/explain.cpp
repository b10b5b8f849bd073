#include "scorer.hpp"

#include <fmt/format.h>
#include <opal/map/object_words.hpp>

#include <algorithm>
#include <map>

namespace opal::score_beams {
namespace {

/// The beams that pass through one mapped object.
struct Passage {
  int beams = 0;
  double depth_m = 0;  ///< how far the deepest of them reaches beyond the surface
  std::string beam;    ///< its name
  MapFeatureNumber map_feature;
  std::vector<Point> line;
};

class Passages {
 public:
  explicit Passages(const MapView& map) : map_(map) {}

  void add(const std::string& beam, const Point& eye, const Point& end, double margin_m) {
    ++judged_;
    const auto wall = map_.first_crossing(eye, end, margin_m);
    if (!wall.feature.exists()) return;
    const double range_m = (end - eye).norm();
    Passage& passage = by_object_[map_.feature(wall.feature).object];
    ++passage.beams;
    if (range_m - wall.range_m <= passage.depth_m) return;
    passage.depth_m = range_m - wall.range_m;
    passage.beam = beam;
    passage.map_feature = wall.feature;
    passage.line = {eye + wall.range_m / range_m * (end - eye), end};
  }

  /// Those with most beams first.
  std::vector<Finding> findings() const {
    std::vector<const Passage*> order;
    for (const auto& [object, passage] : by_object_)
      if (passage.map_feature.exists()) order.push_back(&passage);
    std::ranges::stable_sort(order, [](const Passage* a, const Passage* b) { return a->beams > b->beams; });
    std::vector<Finding> findings;
    for (const Passage* passage : order) findings.push_back({words(*passage), passage->map_feature, passage->line});
    return findings;
  }

 private:
  std::string words(const Passage& passage) const {
    const std::string object = object_words(map_.map(), map_.feature(passage.map_feature).object);
    if (passage.beams == 1) return fmt::format("{} passes {:.2f} m through {}", passage.beam, passage.depth_m, object);
    return fmt::format("{} of {} judged beams pass through {}, at most {:.2f} m", passage.beams, judged_, object,
                       passage.depth_m);
  }

  const MapView& map_;
  int judged_ = 0;
  std::map<MapObjectNumber, Passage> by_object_;
};

std::string beam_without_return(double bearing_rad) {
  return fmt::format("the beam at {:.0f} deg, which met nothing,", bearing_rad * 180 / std::numbers::pi);
}

}  // namespace

std::vector<Finding> BeamScorer::explain(const Hypothesis& hypothesis, const Observation& observation,
                                         const MapView& map) const {
  const Pose2 T_map_base = observation.T_map_base(hypothesis.T_map_local);
  Passages passages(map);
  for (const ObservedScan& scan : observation.scans) {
    const Point eye = T_map_base * scan.laser_position;
    for (std::size_t k = 0; k < scan.points.size(); ++k) {
      const std::string beam = fmt::format("beam {}", scan.beams[k]);
      passages.add(beam, eye, T_map_base * scan.points[k], margin_at((scan.points[k] - scan.laser_position).norm()));
    }
    const double range = std::min(scan.range_max_m, free_range_m_);
    for (double bearing : scan.free_bearings_rad)
      passages.add(beam_without_return(bearing), eye, T_map_base * (scan.laser_position + range * unit_vector(bearing)),
                   margin_at(range));
  }
  return passages.findings();
}

}  // namespace opal::score_beams
