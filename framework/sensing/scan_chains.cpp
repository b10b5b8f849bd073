#include <opal/sensing/scan_chains.hpp>

#include <algorithm>
#include <limits>

namespace opal {
namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;

/// Counter-clockwise angle from one bearing to another, in [0, 2 pi).
double turn_rad(double from_rad, double to_rad) {
  const double turn = std::fmod(to_rad - from_rad, kTwoPi);
  return turn < 0 ? turn + kTwoPi : turn;
}

bool usable(const ScanPoint& p) {
  return p.position.allFinite() && std::isfinite(p.bearing_rad) && std::isfinite(p.range_m) && p.range_m > 0;
}

/// How far apart two neighbours are, relative to what one surface allows: above 1 is a break.
double break_ratio(const ScanPoint& a, const ScanPoint& b, double increment_rad, const ChainOptions& options) {
  const double turn = turn_rad(a.bearing_rad, b.bearing_rad);
  const double allowed_turn = (options.max_missing_beams + 1.5) * increment_rad;
  const bool same_bearing = turn > kTwoPi - increment_rad / 2;  // rounded into the wrong order
  if (increment_rad > 0 && turn > allowed_turn && !same_bearing) return 1 + turn / increment_rad;
  const double allowed = options.gap_m + options.gap_per_spacing * std::min(a.range_m, b.range_m) * increment_rad;
  return (a.position - b.position).norm() / allowed;
}

std::vector<ScanPoint> usable_points(const Scan& scan) {
  std::vector<ScanPoint> points;
  points.reserve(scan.points.size());
  std::copy_if(scan.points.begin(), scan.points.end(), std::back_inserter(points), usable);
  return points;
}

/// Where to start: after the largest break, or, if the outline is closed, at the farthest hit (a corner of
/// its hull).
int start_of(const std::vector<ScanPoint>& hits, const std::vector<double>& ratio_after) {
  const auto largest = std::max_element(ratio_after.begin(), ratio_after.end());
  if (*largest > 1) return static_cast<int>((largest - ratio_after.begin() + 1) % static_cast<long>(hits.size()));
  const auto nearer = [](const ScanPoint& a, const ScanPoint& b) { return a.range_m < b.range_m; };
  return static_cast<int>(std::max_element(hits.begin(), hits.end(), nearer) - hits.begin());
}

/// Reorders hits so that each chain is one run.
void group_by_chain(ScanChains& chains, const std::vector<int>& size) {
  for (int c = 0, first = 0; c < static_cast<int>(size.size()); first += size[c++])
    chains.chains.push_back({first, first + size[c] - 1});
  std::vector<int> next;
  for (const Run& chain : chains.chains) next.push_back(chain.first);
  ScanChains grouped = chains;
  for (std::size_t i = 0; i < chains.hits.size(); ++i) {
    const int to = next[chains.chain_of[i]]++;
    grouped.hits[to] = chains.hits[i];
    grouped.sightline_of[to] = chains.sightline_of[i];
    grouped.chain_of[to] = chains.chain_of[i];
  }
  chains = std::move(grouped);
}

/// The chain that a hit continues: of those that ended within the last few beams, the nearest one. -1 if
/// none.
int continued_chain(const ScanChains& chains, const std::vector<int>& last_hit, int hit, const ChainOptions& options) {
  int chain = -1;
  double least = 1;
  for (int back = 1; back <= options.max_missing_beams + 1 && back <= hit; ++back) {
    const int candidate = chains.chain_of[hit - back];
    if (last_hit[candidate] != hit - back) continue;  // it went on with a later hit
    const double ratio = break_ratio(chains.hits[hit - back], chains.hits[hit], chains.angle_increment_rad, options);
    if (ratio <= least) least = ratio, chain = candidate;
  }
  return chain;
}

/// Gives every hit its chain, then brings the hits of each chain together.
void link(ScanChains& chains, const ChainOptions& options) {
  const int n = static_cast<int>(chains.hits.size());
  std::vector<int> last_hit;  // by chain
  std::vector<int> size;
  chains.chain_of.resize(n);
  for (int i = 0; i < n; ++i) {
    int chain = continued_chain(chains, last_hit, i, options);
    if (chain < 0) {
      chain = static_cast<int>(last_hit.size());
      last_hit.push_back(i);
      size.push_back(0);
    }
    chains.chain_of[i] = chain;
    last_hit[chain] = i;
    ++size[chain];
  }
  group_by_chain(chains, size);
}

/// Interleaves hits and free beams by their turn from the first hit; free beams before it come last.
void add_sightlines(ScanChains& chains, const std::vector<double>& free_bearings_rad) {
  std::vector<double> free_turns;
  free_turns.reserve(free_bearings_rad.size());
  const double origin = chains.hits.front().bearing_rad;
  for (const double bearing : free_bearings_rad)
    if (std::isfinite(bearing)) free_turns.push_back(turn_rad(origin, bearing));
  std::sort(free_turns.begin(), free_turns.end());

  chains.sightlines.reserve(chains.hits.size() + free_turns.size());
  auto next_free = free_turns.begin();
  const auto add_free_up_to = [&](double turn) {
    for (; next_free != free_turns.end() && *next_free < turn; ++next_free)
      chains.sightlines.push_back({unit_vector(origin + *next_free), std::numeric_limits<double>::infinity()});
  };
  for (const ScanPoint& hit : chains.hits) {
    add_free_up_to(turn_rad(origin, hit.bearing_rad));
    chains.sightline_of.push_back(static_cast<int>(chains.sightlines.size()));
    chains.sightlines.push_back({hit.position / hit.range_m, hit.range_m});
  }
  add_free_up_to(kTwoPi);
}

}  // namespace

ScanChains chained(const Scan& scan, const ChainOptions& options) {
  ScanChains chains;
  chains.angle_increment_rad = std::abs(scan.angle_increment_rad);
  chains.range_max_m = scan.range_max_m;
  chains.max_missing_beams = options.max_missing_beams;
  chains.hits = usable_points(scan);
  const std::size_t n = chains.hits.size();
  if (n == 0) return chains;

  std::vector<double> ratio_after(n);
  for (std::size_t i = 0; i < n; ++i)
    ratio_after[i] = break_ratio(chains.hits[i], chains.hits[(i + 1) % n], chains.angle_increment_rad, options);
  const double seam_rad = turn_rad(chains.hits.back().bearing_rad, chains.hits.front().bearing_rad);
  chains.full_circle = n > 2 && seam_rad < std::numbers::pi / 4;
  if (chains.full_circle) {
    chains.closed = *std::max_element(ratio_after.begin(), ratio_after.end()) <= 1;
    const int start = start_of(chains.hits, ratio_after);
    std::rotate(chains.hits.begin(), chains.hits.begin() + start, chains.hits.end());
  }
  add_sightlines(chains, scan.free_bearings_rad);
  link(chains, options);
  return chains;
}

const Sightline* neighbour(const ScanChains& chains, int hit, int steps) {
  const int n = static_cast<int>(chains.sightlines.size());
  const int self = chains.sightline_of[hit];
  const Sightline& next = chains.sightlines[((self + steps) % n + n) % n];
  const Point& direction = chains.sightlines[self].direction;
  const double turn =
      std::copysign(1.0, steps) * std::atan2(cross(direction, next.direction), direction.dot(next.direction));
  const double limit = (chains.max_missing_beams + std::abs(steps) + 0.5) * chains.angle_increment_rad;
  return turn > 0 && turn <= limit ? &next : nullptr;
}

}  // namespace opal
