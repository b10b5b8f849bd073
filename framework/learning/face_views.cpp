#include "learning/face_views.hpp"

#include <algorithm>

namespace opal {
namespace {

constexpr double kAlongStep_m = 0.1;
constexpr double kBesideMapped_m = 0.25;
constexpr double kShortestPart_m = 0.4;

/// The map where the drive believes it to be.
class BelievedMap {
 public:
  BelievedMap(const MapView& map, const MapBelief& belief) : map_(map) {
    for (std::size_t k = 0; k < belief.size(); ++k) {
      const FeatureBelief& known = belief[MapFeatureNumber(k)];
      if (known.observations > 0 && known.moved.norm() > kBesideMapped_m / 2)
        moved_.push_back(corrected(map.map().features()[k].geometry, known));
    }
  }
  /// Whether a surface near a point is seen from where the face is seen, too: the other side of a wall is another face.
  bool has_surface_at(const Point& p, const Point& normal) const {
    const auto is_it = [&](const Geometry& surface) {
      const auto* face = std::get_if<Segment>(&surface);
      return distance_m(surface, p) < kBesideMapped_m && (!face || face->normal().dot(normal) > 0);
    };
    if (map_.clearance_m(p) < kBesideMapped_m)
      for (const MapFeatureNumber number : map_.within(p, kBesideMapped_m))
        if (is_it(map_.map().feature(number).geometry)) return true;
    return std::ranges::any_of(moved_, is_it);
  }

 private:
  const MapView& map_;
  std::vector<Geometry> moved_;
};

/// The longest part of a face with nothing mapped beside it.
Segment unmapped_part(const Segment& face, const BelievedMap& map) {
  const int steps = static_cast<int>(face.length_m() / kAlongStep_m);
  const Point direction = face.direction();
  int best_from = 0, best = 0, from = 0;
  for (int k = 0; k <= steps; ++k) {
    if (map.has_surface_at(face.begin + k * kAlongStep_m * direction, face.normal())) from = k + 1;
    if (k + 1 - from <= best) continue;
    best = k + 1 - from;
    best_from = from;
  }
  return {face.begin + best_from * kAlongStep_m * direction,
          face.begin + (best_from + std::max(0, best - 1)) * kAlongStep_m * direction};
}

bool takes(const FaceViews& face, const Segment& view) {
  constexpr double kTurn_rad = 0.1, kOff_m = 0.1, kGap_m = 0.2;
  const Segment& extent = face.extent;
  const Point along = extent.direction();
  const double begin = along.dot(view.begin - extent.begin), end = along.dot(view.end - extent.begin);
  return std::abs(wrap_angle(view.heading_rad() - extent.heading_rad())) < kTurn_rad &&
         std::abs(extent.normal().dot(view.midpoint() - extent.begin)) < kOff_m && begin < extent.length_m() + kGap_m &&
         end > -kGap_m;
}

void add(FaceViews& face, const FaceView& view) {
  Segment& extent = face.extent;
  const Point along = extent.direction();
  const double begin = along.dot(view.part.begin - extent.begin), end = along.dot(view.part.end - extent.begin);
  const double length = extent.length_m();
  extent = {extent.begin + std::min(0.0, begin) * along, extent.begin + std::max(length, end) * along};
  face.views.push_back(view);
  face.keyframes.insert(view.keyframe);
}

}  // namespace

const Segment& FaceViews::longest() const {
  return std::ranges::max_element(
             views, [](const FaceView& a, const FaceView& b) { return a.part.length_m() < b.part.length_m(); })
      ->part;
}

std::vector<FaceViews> views_of_unmapped_faces(const MapView& map, const MapBelief& belief,
                                               std::span<const KeyframeView> views, std::span<const Pose2> T_map_base) {
  const BelievedMap believed(map, belief);
  std::vector<FaceViews> found;
  for (std::size_t k = 0; k < views.size(); ++k)
    for (const SeenFace& seen : views[k].faces) {
      const FaceView view{unmapped_part(transformed(T_map_base[k], seen.segment), believed), k, &seen};
      if (view.part.length_m() < kShortestPart_m) continue;
      auto face = std::ranges::find_if(found, [&](const FaceViews& each) { return takes(each, view.part); });
      if (face == found.end()) face = found.insert(found.end(), FaceViews{view.part});
      add(*face, view);
    }
  return found;
}

}  // namespace opal
