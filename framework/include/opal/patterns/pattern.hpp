#pragma once

#include <opal/common/feature.hpp>

#include <string>
#include <vector>

namespace opal {

/// How a mapped invariant has to compare with an observed one for the two patterns to be the same.
enum class Comparison {
  equal,           ///< the two differ by no more than the tolerance
  mapped_at_most,  ///< the mapped one is no larger, up to the tolerance
  mapped_at_least  ///< the mapped one is no smaller, up to the tolerance
};

/// A number that a rigid motion of the features leaves unchanged: a distance, an angle, a radius, an extent.
struct Invariant {
  double value = 0;  ///< [m], [rad] or a pure number, as the template means it
  /// Slack of the comparison, from the measurement's uncertainty (on the observed side; ignored on the map side).
  double tolerance = 0;
  Comparison comparison = Comparison::equal;  ///< how a mapped value may differ from it
};

/// Features in a certain geometric relation, described by invariants. The instance on the map and the instance in
/// the local map come from the same template code.
struct PatternInstance {
  /// For member slot k, the position of that feature in the span given to `match`.
  std::vector<int> members;
  std::vector<Invariant> invariants;  ///< as many, and in the same order, for all instances of a template
  /// Where the pattern sits: a pose, in the features' own frame, that moves rigidly with them, so that
  /// T_map_local = mapped.frame * observed.frame.inverse().
  Pose2 frame;
  /// What the pattern leaves free: it extends along the frame's x axis from extent_min_m to extent_max_m, and may be
  /// seen anywhere within a mapped pattern's extent, overhanging it by up to overhang_m (a piece of a wall). All
  /// zero for patterns that fix the pose.
  double extent_min_m = 0;
  double extent_max_m = 0;  ///< where it ends, along the frame's x axis
  double overhang_m = 0;    ///< how far an observed piece may stick out of the mapped extent
  /// True if turning the frame by pi gives the same pattern (two equal columns): both are tried.
  bool symmetric = false;
};

}  // namespace opal
