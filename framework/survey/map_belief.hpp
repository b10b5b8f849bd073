#pragma once

#include <opal/common/geometry.hpp>
#include <opal/map/map_numbers.hpp>

#include "survey/list_by_id.hpp"

namespace opal {

/// What driving past a mapped feature has taught about it. Frame: `map`.
struct FeatureBelief {
  /// How far it really is from where the map says [m]: a face along its normal, a column anywhere.
  Point moved = Point::Zero();
  double sigma_m = 0;       ///< one-sigma of `moved`, per axis; meaningless before it was seen
  int observations = 0;     ///< keyframes from which it was recognized
  double seen = 0;          ///< keyframes' worth of beams that ended on it
  double seen_through = 0;  ///< keyframes' worth of beams that passed through where it is believed to be
  double covered_m = 0;     ///< of a face: the widest piece of it that was recognized at once

  /// Share of the evidence that says that it is not there, in [0, 1]; 0 if there is none.
  double seen_through_share() const {
    const double all = seen + seen_through;
    return all > 0 ? seen_through / all : 0;
  }
};

using MapBelief = ListById<MapFeatureNumber, FeatureBelief>;

/// The feature where it is believed to be.
inline Geometry corrected(const Geometry& mapped, const FeatureBelief& belief) {
  return transformed(Pose2(belief.moved, 0), mapped);
}

}  // namespace opal
