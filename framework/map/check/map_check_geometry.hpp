#pragma once

#include <opal/map/semantic_map.hpp>

#include <string>
#include <utility>
#include <vector>

namespace opal {

/// Points closer than this are one point in a building; maps that share them keep its topology.
inline constexpr double kSamePoint_m = 0.01;
/// A feature with no other this near is out of reach of what a robot sees beside it: a wrong unit or origin.
inline constexpr double kNeighbour_m = 15;

struct PointPair {
  std::string point, near_point;
};
/// Ends of segments and corners that lie within kSamePoint_m of another such point of another id: each point once.
/// Features that no sensor perceives do not count, nor those that are less sure than kSamePoint_m.
std::vector<PointPair> unshared_points(const SemanticMap& map);
/// Features of one sensor, kind and place, but for kSamePoint_m: pairs of positions, each later feature once.
OPAL_EXPORT std::vector<std::pair<MapFeatureNumber, MapFeatureNumber>> duplicate_features(const SemanticMap& map);
/// Positions of features that have no other feature within kNeighbour_m (none within twice that is surely listed).
std::vector<MapFeatureNumber> isolated_features(const SemanticMap& map);
/// Faces that meet one other of their sensor at each end, begin to begin and end to end: turned round they would fit.
/// Those of a source with classes do not count: an importer has chosen their sides.
std::vector<MapFeatureNumber> backward_faces(const SemanticMap& map);
/// How many points belong to more than one geometry.
int count_shared_points(const SemanticMap& map);

}  // namespace opal
