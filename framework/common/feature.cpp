#include <opal/common/feature.hpp>

namespace opal {

Feature transformed(const Pose2& T_a_b, const Feature& feature_b) {
  Feature moved = feature_b;
  moved.geometry = transformed(T_a_b, feature_b.geometry);
  if (kind_of(feature_b.geometry) != GeometryKind::segment) {  // a segment's covariance is in its own axes
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    turn.col(0).head<2>() = T_a_b.rotate(Point::UnitX());
    turn.col(1).head<2>() = T_a_b.rotate(Point::UnitY());
    moved.covariance = turn * feature_b.covariance * turn.transpose();
  }
  return moved;
}

}  // namespace opal
