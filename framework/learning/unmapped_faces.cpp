#include "learning/unmapped_faces.hpp"

#include <opal/common/quantile.hpp>

#include <algorithm>
#include <set>

namespace opal {
namespace {

constexpr double kStep_m = 0.1;
constexpr double kBesideMapped_m = 0.25;
constexpr double kLeastLength_m = 0.8;
constexpr int kFewestViews = 5;
// A piece of a face is there if so many keyframes saw it.
constexpr int kFewestViewsOfPiece = 3;
constexpr int kGapSteps = 4;

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
  bool has_surface_at(const Point& p) const {
    if (map_.clearance_m(p) < kBesideMapped_m) return true;
    return std::any_of(moved_.begin(), moved_.end(),
                       [&](const Geometry& surface) { return distance_m(surface, p) < kBesideMapped_m; });
  }

 private:
  const MapView& map_;
  std::vector<Geometry> moved_;
};

/// The longest part of a face with nothing mapped beside it.
Segment unmapped_part(const Segment& face, const BelievedMap& map) {
  const int steps = static_cast<int>(face.length_m() / kStep_m);
  const Point direction = face.direction();
  int best_from = 0, best = 0, from = 0;
  for (int k = 0; k <= steps; ++k) {
    if (map.has_surface_at(face.begin + k * kStep_m * direction)) from = k + 1;
    if (k + 1 - from <= best) continue;
    best = k + 1 - from;
    best_from = from;
  }
  return {face.begin + best_from * kStep_m * direction,
          face.begin + (best_from + std::max(0, best - 1)) * kStep_m * direction};
}

/// Views of one straight face, from wherever they show a part of it.
struct FaceViews {
  Segment extent;  ///< of all views, along the first one
  std::vector<Segment> views;
  std::set<std::size_t> keyframes;

  bool takes(const Segment& view) const {
    constexpr double kTurn_rad = 0.1, kOff_m = 0.1, kGap_m = 0.2;
    const Point along = extent.direction();
    const double begin = along.dot(view.begin - extent.begin), end = along.dot(view.end - extent.begin);
    return std::abs(wrap_angle(view.heading_rad() - extent.heading_rad())) < kTurn_rad &&
           std::abs(extent.normal().dot(view.midpoint() - extent.begin)) < kOff_m &&
           begin < extent.length_m() + kGap_m && end > -kGap_m;
  }
  void add(const Segment& view, std::size_t keyframe) {
    const Point along = extent.direction();
    const double begin = along.dot(view.begin - extent.begin), end = along.dot(view.end - extent.begin);
    const double length = extent.length_m();
    extent = {extent.begin + std::min(0.0, begin) * along, extent.begin + std::max(length, end) * along};
    views.push_back(view);
    keyframes.insert(keyframe);
  }
  const Segment& longest() const {
    return *std::max_element(views.begin(), views.end(),
                             [](const Segment& a, const Segment& b) { return a.length_m() < b.length_m(); });
  }
};

void add_view(std::vector<FaceViews>& faces, const Segment& view, std::size_t keyframe) {
  auto face = std::find_if(faces.begin(), faces.end(), [&](const FaceViews& each) { return each.takes(view); });
  if (face == faces.end()) face = faces.insert(faces.end(), FaceViews{view, {}, {}});
  face->add(view, keyframe);
}

/// What enough views of one face have in common: their median line, as far as several of them cover it.
Segment common_face(const std::vector<Segment>& views, const Segment& longest) {
  const Point along = longest.direction(), across = longest.normal();
  std::vector<double> offsets;
  double low = 0, high = longest.length_m();
  for (const Segment& face : views) {
    offsets.push_back(across.dot(face.midpoint() - longest.begin));
    low = std::min(low, along.dot(face.begin - longest.begin));
    high = std::max(high, along.dot(face.end - longest.begin));
  }
  std::vector<int> covered(static_cast<std::size_t>((high - low) / kStep_m) + 1);
  for (const Segment& face : views) {
    const auto from = static_cast<std::size_t>(std::max(0.0, along.dot(face.begin - longest.begin) - low) / kStep_m);
    const auto to = static_cast<std::size_t>(std::max(0.0, along.dot(face.end - longest.begin) - low) / kStep_m);
    for (std::size_t k = from; k <= std::min(to, covered.size() - 1); ++k) ++covered[k];
  }
  int best = 0, best_from = 0, from = -1, last = -1;
  for (int k = 0; k < static_cast<int>(covered.size()); ++k) {
    if (covered[static_cast<std::size_t>(k)] < kFewestViewsOfPiece) continue;
    if (from < 0 || k - last > kGapSteps) from = k;
    last = k;
    if (k - from <= best) continue;
    best = k - from;
    best_from = from;
  }
  const Point begin = longest.begin + upper_median_of(offsets) * across + (low + best_from * kStep_m) * along;
  return {begin, begin + best * kStep_m * along};
}

bool crosses(const Segment& face, const Point& from, const Point& to) {
  constexpr double kMargin_m = 0.3;  // a beam that ends just behind may have ended on it
  const Point way = to - from, side = face.end - face.begin;
  const double turn = cross(way, side);
  if (std::abs(turn) < 1e-9) return false;
  const double on_way = cross(face.begin - from, side) / turn, on_face = cross(face.begin - from, way) / turn;
  return on_way > 0 && (1 - on_way) * way.norm() > kMargin_m && on_face > 0.1 && on_face < 0.9;
}

/// Share of the keyframes through which three beams went, of those and the ones that saw it.
double seen_through_share(const Segment& face, int seen, std::span<const KeyframeView> views,
                          std::span<const Pose2> T_map_base) {
  constexpr int kFewestBeams = 3;
  int through = 0;
  for (std::size_t k = 0; k < views.size(); ++k) {
    int beams = 0;
    for (const auto& [laser, hit] : views[k].beams) {
      if (beams == kFewestBeams) break;
      beams += crosses(face, T_map_base[k] * laser, T_map_base[k] * hit);
    }
    through += beams == kFewestBeams;
  }
  return static_cast<double>(through) / std::max(1, through + seen);
}

}  // namespace

std::vector<UnmappedFace> unmapped_faces(const MapView& map, const MapBelief& belief,
                                         std::span<const KeyframeView> views, std::span<const Pose2> T_map_base) {
  const BelievedMap believed(map, belief);
  std::vector<FaceViews> found;
  for (std::size_t k = 0; k < views.size(); ++k)
    for (const Segment& seen : views[k].faces) {
      const Segment part = unmapped_part(transformed(T_map_base[k], seen), believed);
      if (part.length_m() >= kLeastLength_m / 2) add_view(found, part, k);
    }
  std::vector<UnmappedFace> faces;
  for (const FaceViews& all : found) {
    const auto seen = static_cast<int>(all.keyframes.size());
    if (seen < kFewestViews) continue;
    const Segment face = common_face(all.views, all.longest());
    if (face.length_m() < kLeastLength_m) continue;
    faces.push_back({face, seen, seen_through_share(face, seen, views, T_map_base)});
  }
  return faces;
}

}  // namespace opal
