#pragma once

#include "simulation/ray_caster.hpp"

#include <opal/map/perceivable_faces.hpp>

#include <vector>

namespace opal::simulation {

/// One thing that stands about: its outline, frame `map`.
using Piece = std::vector<Solid>;

inline Solid straight(const Point& a, const Point& b) { return {Segment{a, b}, false}; }
inline Solid round_post(const Point& center, double radius_m) { return {Circle{center, radius_m}, false}; }

/// A closed box about its centre; its length lies along the x axis of `center`.
inline Piece box(const Pose2& center, double length_m, double width_m) {
  const double a = length_m / 2, b = width_m / 2;
  const Point p[4] = {center * Point(-a, -b), center * Point(a, -b), center * Point(a, b), center * Point(-a, b)};
  return {straight(p[0], p[1]), straight(p[1], p[2]), straight(p[2], p[3]), straight(p[3], p[0])};
}

/// Four round legs at the corners of a rectangle.
inline Piece legs(const Pose2& center, double length_m, double width_m, double radius_m) {
  Piece piece;
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5}) piece.push_back(round_post(center * Point(x * length_m, y * width_m), radius_m));
  return piece;
}

/// The building with all doors shut.
inline std::vector<Solid> shut_solids(const SemanticMap& map) {
  std::vector<Solid> solids;
  for (const MapFeature& feature : map.features())
    if (!feature.sensor.empty() || map.object(feature.object).type == "opal:Door")
      solids.push_back({feature.geometry, false});
  return solids;
}

/// How far it is to the first solid along a direction, at most `reach_m`. @param direction  unit length.
inline double room_m(const RayCaster& solids, const Point& from, const Point& direction, double reach_m) {
  const RayHit hit = solids.cast(from, direction, reach_m);
  return hit.solid < 0 ? reach_m : hit.range_m;
}

/// Faces that one sees, long enough to put something along.
inline std::vector<Segment> long_faces(const SemanticMap& map, double least_m) {
  std::vector<Segment> faces = perceivable_faces(map);
  std::erase_if(faces, [&](const Segment& face) { return face.length_m() <= least_m; });
  return faces;
}

}  // namespace opal::simulation
