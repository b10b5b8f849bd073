#pragma once

#include <opal/sensing/scan.hpp>

#include <vector>

namespace opal {

/// When two neighbouring returns of a scan no longer belong to one surface.
struct ChainOptions {
  double gap_m = 0.25;  ///< a distance above gap_m + gap_per_spacing * (nearer range * beam increment) is a break;
  double gap_per_spacing = 8;  ///< the second term lets surfaces seen at a grazing angle through
  int max_missing_beams = 3;   ///< more beams than this without a hit in between are a break
};

/// One beam that was measured: it hit something, or it was free.
struct Sightline {
  Point direction;     ///< unit, sensor frame
  double range_m = 0;  ///< infinity if the beam was free
};

/// Positions first..last of consecutive hits, both inclusive.
struct Run {
  int first = 0;  ///< into ScanChains::hits
  int last = 0;   ///< into ScanChains::hits
  /// Number of hits.
  int size() const { return last - first + 1; }
};

/// A scan as surfaces: each chain is what was seen of one of them, counter-clockwise. A chain goes on behind
/// something that covers up to max_missing_beams, so that chair legs do not cut a wall, and both a railing
/// and what is seen through it come out whole. The sweep starts after its largest break, so that the seam of
/// a scanner that sees all around cuts no surface (a closed outline is cut at its farthest hit). Points that
/// are not finite or lie at the sensor are left out.
struct ScanChains {
  std::vector<ScanPoint> hits;        ///< chain after chain
  std::vector<Run> chains;            ///< into hits, ordered by first hit; together all hits
  std::vector<int> chain_of;          ///< by hit: its chain
  std::vector<Sightline> sightlines;  ///< hits and free beams together, counter-clockwise
  std::vector<int> sightline_of;      ///< by hit: its sightline
  bool full_circle = false;           ///< the last sightline is followed by the first one
  bool closed = false;                ///< ... and one chain goes all around
  double angle_increment_rad = 0;     ///< between beams; positive
  double range_max_m = 0;             ///< of the scan
  int max_missing_beams = 0;          ///< of the options
};

/// Cuts a scan into surfaces.
OPAL_EXPORT ScanChains chained(const Scan& scan, const ChainOptions& options);

/// The sightline `steps` after a hit, counter-clockwise (or before it, if negative); null beyond the edge of
/// the view and where more than max_missing_beams in between measured nothing.
OPAL_EXPORT const Sightline* neighbour(const ScanChains& chains, int hit, int steps);

}  // namespace opal
