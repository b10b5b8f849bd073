#include "scorer.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace {

double size_m(const opal::Feature& feature) {
  const auto* segment = std::get_if<opal::Segment>(&feature.geometry);
  return segment ? segment->length_m() : 0;
}

opal::Finding unexplained(const opal::Feature& placed) {
  const auto* segment = std::get_if<opal::Segment>(&placed.geometry);
  const std::string length = segment ? fmt::format(" of {:.2f} m", segment->length_m()) : "";
  std::vector<opal::Point> line;
  if (segment) line = {segment->begin, segment->end};
  return {fmt::format("a seen {}{} matches nothing on the map", placed.type, length), {}, line};
}

}  // namespace

std::vector<opal::Finding> EvidenceScorer::explain(const opal::Hypothesis& hypothesis,
                                                   const opal::Observation& observation,
                                                   const opal::MapView& map) const {
  const opal::Pose2 T_map_base = observation.T_map_base(hypothesis.T_map_local);
  std::vector<opal::Feature> missed;
  for (std::size_t k = 0; k < observation.features.size(); ++k)
    if (opal::Feature placed = transformed(T_map_base, observation.features[k]);
        !matches(placed, T_map_base * observation.viewpoint_of(k), map))
      missed.push_back(std::move(placed));
  std::stable_sort(missed.begin(), missed.end(),
                   [](const opal::Feature& a, const opal::Feature& b) { return size_m(a) > size_m(b); });
  std::vector<opal::Finding> findings;
  for (const opal::Feature& feature : missed) findings.push_back(unexplained(feature));
  return findings;
}
