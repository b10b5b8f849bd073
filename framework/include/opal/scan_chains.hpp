#pragma once

#include <opal/scan.hpp>

#include <vector>

namespace opal {

/// When two neighbouring returns of a scan no longer belong to one surface.
struct ChainOptions {
  double gap_m = 0.25;         ///< a distance above gap_m + gap_per_spacing * (nearer range * beam increment) is a break;
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
  int first = 0;
  int last = 0;
  int size() const { return last - first + 1; }
};

/// A scan cut at its breaks. Hits keep their order, counter-clockwise, but start after the largest break, so that
/// the seam of a scanner that sees all around cuts no surface (a closed outline is cut at its farthest hit). Points
/// that are not finite or lie at the sensor are left out.
struct ScanChains {
  std::vector<ScanPoint> hits;
  std::vector<Run> chains;             ///< into hits, in order, without overlap; together all hits
  std::vector<int> chain_of;           ///< by hit: its chain
  std::vector<Sightline> sightlines;   ///< hits and free beams together, in the order of hits
  std::vector<int> sightline_of;       ///< by hit: its sightline
  bool full_circle = false;            ///< the last hit is followed by the first one
  bool closed = false;                 ///< ... without a break between the two
  double angle_increment_rad = 0;
  double range_max_m = 0;
  int max_missing_beams = 0;
};

OPAL_EXPORT ScanChains chained(const Scan& scan, const ChainOptions& options);

/// The sightline next to a hit, clockwise (step -1) or counter-clockwise (step +1); null at the edge of the view and
/// where more than max_missing_beams in between measured nothing.
OPAL_EXPORT const Sightline* neighbour(const ScanChains& chains, int hit, int step);

}  // namespace opal
