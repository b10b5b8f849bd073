#pragma once

#include <opal/map/semantic_map.hpp>
#include "survey/map_belief.hpp"

#include <string>
#include <vector>

namespace opal {

enum class DeviationVerdict { as_mapped, moved, probably_absent };
OPAL_EXPORT const char* name_of(DeviationVerdict verdict);

/// Where one face of an object is: from where the map says, along its normal, positive towards the visible side.
struct FaceOffset {
  std::string face;  ///< id of the mapped feature
  double offset_m = 0, sigma_m = 0;
};

/// Where a mapped object really is. Frame: `map`.
struct Deviation {
  std::string object, type;
  MapFeatureNumber feature = {};  ///< its longest face that was recognized, or its circle
  /// From where the map says to where it is [m]: along that face's normal, positive towards the visible side; of a
  /// column, the distance.
  double offset_m = 0;
  double sigma_m = 0;  ///< one-sigma of offset_m
  Point moved = Point::Zero();
  int observations = 0;  ///< keyframes that recognized it, of the face that was recognized most often
  /// Keyframes' worth of beams that ended on it or passed through where it should be, recognized or not.
  double looks = 0;
  double seen_through_share = 0;  ///< of the evidence about its faces, in [0, 1]
  DeviationVerdict verdict = DeviationVerdict::as_mapped;
  std::vector<FaceOffset> faces = {};  ///< each that was recognized often enough, in the order of the map
};

struct DeviationOptions {
  int least_observations = 3;    ///< fewer keyframes do not make a statement about an object
  double least_covered_m = 0.5;  ///< nor do shorter pieces of a face
  double least_offset_m = 0.1;   ///< nearer to where the map says counts as there,
  double sigmas = 3;             ///< and so does what is not farther by so many standard deviations
  double absent_share = 0.6;     ///< evidence of being seen through that makes an object probably absent
};

/// All objects about which there is something to say, largest deviation first; those that are probably absent stand at
/// the end.
OPAL_EXPORT std::vector<Deviation> deviations_of(const SemanticMap& map, const MapBelief& belief,
                                                 const DeviationOptions& options = {});

/// docs/track.md describes the document.
OPAL_EXPORT nlohmann::ordered_json to_json(const SemanticMap& map, const std::vector<Deviation>& deviations);
/// The same for people: one line per object.
OPAL_EXPORT std::string to_table(const std::vector<Deviation>& deviations);

}  // namespace opal
