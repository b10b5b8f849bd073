#pragma once

#include <opal/common/feature.hpp>
#include <opal/sensing/scan_chains.hpp>

#include <span>
#include <vector>

namespace opal {

/// What one range reading is worth: the standard deviation of a point across a surface that is not quite
/// flat.
struct ReadingNoise {
  double range_sigma_m = 0.02;       ///< along the beam
  double bearing_sigma_rad = 0.002;  ///< of the beam's direction
  double surface_sigma_m = 0.005;    ///< roughness of the surface, across it
};

/// Variance [m^2] of a reading along a surface normal: range and bearing noise projected on it (Pfister et
/// al. 2003).
OPAL_EXPORT double variance_across(const ScanPoint& hit, const Point& normal, const ReadingNoise& noise);

/// What makes a line, and which pieces are one face.
struct LineExtractionOptions {
  ChainOptions chain{};            ///< how the scan falls into surfaces
  ReadingNoise noise{};            ///< weights of the points in a fit
  double tolerance_m = 0.05;       ///< a point farther than tolerance_m + tolerance_per_m * range from its line
  double tolerance_per_m = 0.003;  ///< does not belong to it
  int min_points = 5;              ///< hits that a line has at least
  double min_length_m = 0.3;       ///< of the part that is covered by points
  double max_hidden_gap_m = 3.0;   ///< pieces of one face are joined behind something nearer up to this far apart,
  double max_open_gap_m = 0.3;     ///< and across a hole that beams pass through up to this wide
  double max_offset_m = 0.08;      ///< joined pieces differ at most by this across the face,
  double max_angle_rad = 0.05;     ///< and by this (plus their uncertainty) in heading
};

/// A straight line fitted to points by weighted total least squares.
struct LineFit {
  Point centroid = Point::Zero();    ///< weighted
  Point direction = Point::UnitX();  ///< unit, from the first point to the last
  double offset_variance_m2 = 0;     ///< across the line at the centroid
  double heading_variance_rad2 = 0;  ///< independent of the offset at the centroid
  double rms_m = 0;                  ///< unweighted distance of the points
};

/// Fits one line to the hits of some runs (at least two points in all).
OPAL_EXPORT LineFit fit_line(const ScanChains& chains, std::span<const Run> runs, const ReadingNoise& noise);

/// A straight face found in a scan, sensor frame.
struct Line {
  Segment segment;                                       ///< begin = clockwise end, so that the sensor is on the left
  std::vector<Run> runs;                                 ///< its hits, in order
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< (offset at the midpoint [m], heading [rad])
  /// Begin, end: the face ends there; false: hidden, or the view ends.
  std::array<bool, 2> true_end{false, false};
  double support_m = 0;  ///< length covered by points
  /// Number of its hits.
  int points() const;
};

/// Where one line ends at the begin of the next, counter-clockwise one, on one connected surface.
struct Junction {
  int before = 0;  ///< index of the line that ends here
  int after = 0;   ///< index of the line that begins here
  Point position;  ///< intersection of the two lines
};

/// How near two ends must be to meet.
struct JunctionOptions {
  double max_end_distance_m = 0.4;  ///< between the two ends
  double max_extension_m = 0.3;     ///< from either end to the intersection
  double min_sine = 0.4;            ///< of the angle between the lines
};

/// Straight faces, counter-clockwise: split and merge, weighted fit, pieces of one face joined behind
/// occluders, true ends told from occlusions. Sources: split and merge after Pavlidis and Horowitz (1974) and
/// Nguyen et al. (2007), "A comparison of line extraction algorithms using 2D range data for indoor mobile
/// robotics"; weights and covariance after Pfister, Roumeliotis and Burdick (2003), "Weighted line fitting
/// algorithms for mobile robot map building".
OPAL_EXPORT std::vector<Line> extract_lines(const ScanChains& chains, const LineExtractionOptions& options);

/// Where lines meet on one connected surface, in order of the line that ends there.
OPAL_EXPORT std::vector<Junction> find_junctions(const ScanChains& chains, std::span<const Line> lines,
                                                 const JunctionOptions& options);

}  // namespace opal
