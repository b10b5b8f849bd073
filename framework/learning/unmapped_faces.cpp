#include "learning/unmapped_faces.hpp"

#include "learning/face_views.hpp"

#include <opal/common/quantile.hpp>

#include <algorithm>

namespace opal {
namespace {

constexpr double kStep_m = 0.1;
constexpr double kLeastLength_m = 0.8;
constexpr int kFewestViews = 3;  // of a face, and of each piece of it; how sure that makes is for `learned_from`
constexpr int kGapSteps = 4;

/// What enough views of one face have in common: their median line, as far as several of them cover it.
Segment common_face(const FaceViews& all) {
  const Segment& longest = all.longest();
  const Point along = longest.direction(), across = longest.normal();
  std::vector<double> offsets;
  double low = 0, high = longest.length_m();
  for (const auto& [face, keyframe, seen] : all.views) {
    offsets.push_back(across.dot(face.midpoint() - longest.begin));
    low = std::min(low, along.dot(face.begin - longest.begin));
    high = std::max(high, along.dot(face.end - longest.begin));
  }
  std::vector<int> covered(static_cast<std::size_t>((high - low) / kStep_m) + 1);
  for (const auto& [face, keyframe, seen] : all.views) {
    const auto from = static_cast<std::size_t>(std::max(0.0, along.dot(face.begin - longest.begin) - low) / kStep_m);
    const auto to = static_cast<std::size_t>(std::max(0.0, along.dot(face.end - longest.begin) - low) / kStep_m);
    for (std::size_t k = from; k <= std::min(to, covered.size() - 1); ++k) ++covered[k];
  }
  int best = 0, best_from = 0, from = -1, last = -1;
  for (int k = 0; k < static_cast<int>(covered.size()); ++k) {
    if (covered[static_cast<std::size_t>(k)] < kFewestViews) continue;
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
  std::vector<UnmappedFace> faces;
  for (const FaceViews& all : views_of_unmapped_faces(map, belief, views, T_map_base)) {
    const auto seen = static_cast<int>(all.keyframes.size());
    if (seen < kFewestViews) continue;
    const Segment face = common_face(all);
    if (face.length_m() < kLeastLength_m) continue;
    faces.push_back({face, seen, seen_through_share(face, seen, views, T_map_base)});
  }
  return faces;
}

}  // namespace opal
