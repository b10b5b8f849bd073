#include "detector.hpp"

#include "arc_fit.hpp"

namespace opal::circles {
namespace {

/// Direction in which a free-standing object ends at one of its outermost hits; empty if the beam beside it
/// does not go clearly farther (then something covers or touches the object).
std::optional<Point> edge(const ScanChains& chains, int hit, int step, double min_jump_m) {
  const Sightline* beside = neighbour(chains, hit, step);
  if (!beside || beside->range_m < chains.hits[hit].range_m + min_jump_m) return std::nullopt;
  const Sightline& outermost = chains.sightlines[chains.sightline_of[hit]];
  return (outermost.direction + beside->direction).normalized();
}

/// Whether nearly all beams between a chain's ends hit it: an opaque object.
bool opaque(const ScanChains& chains, const Run& run) {
  const int n = static_cast<int>(chains.sightlines.size());
  const int beams = (chains.sightline_of[run.last] - chains.sightline_of[run.first] + n) % n + 1;
  return run.size() >= 0.8 * beams;
}

std::optional<Arc> free_standing_arc(const ScanChains& chains, const Run& run, const CircleOptions& options) {
  if (run.size() < options.min_points || !opaque(chains, run)) return std::nullopt;
  const auto& first = chains.hits[run.first];
  const auto& last = chains.hits[run.last];
  if ((first.position - last.position).norm() > 2.2 * options.max_radius_m) return std::nullopt;
  const auto clockwise = edge(chains, run.first, -1, options.min_jump_m);
  const auto counter_clockwise = edge(chains, run.last, +1, options.min_jump_m);
  if (!clockwise || !counter_clockwise) return std::nullopt;
  const std::span<const ScanPoint> hits(&first, static_cast<std::size_t>(run.size()));
  // Uniform within one beam spacing has 0.29 of it as sigma; the beam's own width doubles that.
  return Arc{hits, *clockwise, *counter_clockwise, 0.6 * chains.angle_increment_rad};
}

bool is_column(const ArcFit& fit, const LineFit& line, const CircleOptions& options) {
  const double radius = fit.circle.radius_m;
  return radius >= options.min_radius_m && radius <= options.max_radius_m && fit.rms_m <= options.max_rms_m &&
         fit.edge_error_sigmas <= 2.5 && std::sqrt(fit.covariance(2, 2)) <= options.max_radius_sigma_m &&
         line.rms_m > 2 * fit.rms_m;
}

}  // namespace

std::vector<Feature> CircleDetector::detect(const Scan& scan) const {
  const ScanChains chains = chained(scan, options_.chain);
  std::vector<Feature> columns;
  for (const Run& run : chains.chains) {
    const auto arc = free_standing_arc(chains, run, options_);
    if (!arc) continue;
    const auto fit = fit_arc(*arc, options_.noise);
    if (!fit || !is_column(*fit, fit_line(chains, {&run, 1}, options_.noise), options_)) continue;
    columns.push_back({.type = "opal:Column", .geometry = fit->circle, .covariance = fit->covariance});
  }
  return columns;
}

}  // namespace opal::circles
