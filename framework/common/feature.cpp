#include <opal/common/feature.hpp>

#include "common/covariance.hpp"

namespace opal {

Feature transformed(const Pose2& T_a_b, const Feature& feature_b) {
  Feature moved = feature_b;
  moved.geometry = transformed(T_a_b, feature_b.geometry);
  if (kind_of(feature_b.geometry) != GeometryKind::segment)  // a segment's covariance is in its own axes
    moved.covariance = turned_covariance(T_a_b, feature_b.covariance);
  return moved;
}

}  // namespace opal
