#include "scorer.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace opal::score_evidence {
namespace {

double size_m(const Feature& feature) {
  const auto* segment = std::get_if<Segment>(&feature.geometry);
  return segment ? segment->length_m() : 0;
}

Finding unexplained(const Feature& placed) {
  const auto* segment = std::get_if<Segment>(&placed.geometry);
  const std::string length = segment ? fmt::format(" of {:.2f} m", segment->length_m()) : "";
  std::vector<Point> line;
  if (segment) line = {segment->begin, segment->end};
  return {fmt::format("a seen {}{} matches nothing on the map", placed.type, length), {}, line};
}

}  // namespace

std::vector<Finding> EvidenceScorer::explain(const Hypothesis& hypothesis, const Observation& observation,
                                             const MapView& map) const {
  const Pose2 T_map_base = observation.T_map_base(hypothesis.T_map_local);
  std::vector<Feature> missed;
  for (std::size_t k = 0; k < observation.features.size(); ++k)
    if (Feature placed = transformed(T_map_base, observation.features[k]);
        !matches(placed, T_map_base * observation.viewpoint_of(k), map))
      missed.push_back(std::move(placed));
  std::ranges::stable_sort(missed, [](const Feature& a, const Feature& b) { return size_m(a) > size_m(b); });
  std::vector<Finding> findings;
  for (const Feature& feature : missed) findings.push_back(unexplained(feature));
  return findings;
}

}  // namespace opal::score_evidence
