#pragma once

#include "learning/learned_overlay.hpp"

#include <memory>
#include <string>
#include <vector>

/// A small map, and drives that say what a test wants.
namespace opal::made {

inline const char* const kSensor = "PlanarLidar2D";

/// A room of 8 m by 6 m whose walls share their corners.
inline std::shared_ptr<const SemanticMap> room() {
  const Point corners[] = {{0, 0}, {8, 0}, {8, 6}, {0, 6}};
  std::vector<MapObject> objects;
  std::vector<MapFeature> features;
  for (int k = 0; k < 4; ++k) {
    const std::string id = "wall-" + std::to_string(k);
    objects.push_back({id, "opal:Wall"});
    features.push_back(
        {id + "/face", MapObjectNumber(k), "opal:Wall", kSensor, Segment{corners[k], corners[(k + 1) % 4]}});
    features.back().points = {"corner-" + std::to_string(k), "corner-" + std::to_string((k + 1) % 4)};
  }
  return SemanticMap::make("room", objects, features);
}

inline Deviation seen(const std::string& object, DeviationVerdict verdict, const Point& moved = Point::Zero(),
                      int keyframes = 12) {
  Deviation deviation;
  deviation.object = object;
  deviation.type = "opal:Wall";
  deviation.verdict = verdict;
  deviation.moved = moved;
  deviation.offset_m = moved.norm();
  deviation.sigma_m = 0.03;
  const bool is_gone = verdict == DeviationVerdict::probably_absent;
  deviation.observations = is_gone ? 0 : keyframes;  // what is gone is never recognized
  deviation.looks = keyframes;
  return deviation;
}

inline DriveEvidence drive(const std::string& name, std::vector<Deviation> objects,
                           std::vector<UnmappedFace> faces = {}) {
  return {"room", name, {{std::move(objects), std::move(faces)}}, 20, 0};
}

inline const auto kThere = DeviationVerdict::as_mapped, kMoved = DeviationVerdict::moved,
                  kGone = DeviationVerdict::probably_absent;

}  // namespace opal::made
