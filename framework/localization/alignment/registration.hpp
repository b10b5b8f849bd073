#pragma once

#include <opal/common/geometry.hpp>
#include <opal/localization/observation/observation.hpp>
#include <opal/map/view/map_view.hpp>

#include <Eigen/Core>

#include <span>
#include <vector>

namespace opal {

/// One local geometry and the mapped geometry it is said to be (of the same kind).
struct GeometryPair {
  Geometry local;
  Geometry mapped;
};

/// The rigid transform that lays local over mapped geometry.
struct Registration {
  Pose2 T_map_local;
  /// 3: the pairs fix the pose; 2: they leave a shift along parallel lines free; 1 or 0: hardly anything is fixed.
  int fixed = 0;
  /// Per pair, in order, after alignment: distance of points [m]; for segments the larger distance of the two local
  /// end points to the mapped line. Where the pose is not fixed, distances along the free direction do not count.
  std::vector<double> errors_m;
};

/// Minimises the squared distances of eq. 3.12 (Hendrikx 2023): points to points, segments' end points to infinite
/// lines. Pre-aligned in closed form by headings and line intersections (thesis 3.4.4), then Gauss-Newton.
OPAL_EXPORT Registration register_geometry(std::span<const GeometryPair> pairs);

/// How far a placed geometry is from a mapped one of the same kind. Segments may be parts of each other: offset of
/// the placed midpoint from the mapped line, and the gap along the line if they do not overlap.
struct Mismatch {
  double position_m = 0;
  double heading_rad = 0;  ///< 0 for points and circles
};
OPAL_EXPORT Mismatch mismatch(const Geometry& placed, const Geometry& mapped);

struct RefinementOptions {
  int iterations = 5;
  double sigma_m = 0.12;          ///< scale of the robust weight 1 / (1 + (e / sigma)^2)^2
  double prior_position = 0.003;  ///< weight of the guess per point, position [1/m^2 relative to a point's]
  double prior_heading = 0.02;
};

/// A scan on the map, and what fixes it there: information about (x, y, heading), relative to what a point says of its
/// distance to a surface [1/m^2].
struct Alignment {
  Pose2 T_map_base;
  Eigen::Matrix3d by_points = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d by_guess = Eigen::Matrix3d::Zero();
};

/// Slides a scan onto the mapped surfaces near it: robust point-to-surface Gauss-Newton (Censi 2008 for the metric;
/// weights after Geman and McClure). Surfaces that would be seen from behind are not used.
/// @param scans  base frame.
/// @return T_map_base near `guess`.
OPAL_EXPORT Alignment align_with_map(const MapView& map, std::span<const ObservedScan> scans, const Pose2& guess,
                                     const RefinementOptions& options);
/// The same, its pose only.
OPAL_EXPORT Pose2 refine_on_map(const MapView& map, std::span<const ObservedScan> scans, const Pose2& guess,
                                const RefinementOptions& options);

/// Mean likelihood-field score of points to mapped surfaces at a pose, in [0, 1].
OPAL_EXPORT double likelihood_field_score(const MapView& map, std::span<const Point> points, const Pose2& T_map_base);

}  // namespace opal
