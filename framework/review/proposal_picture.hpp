#pragma once

#include "learning/learned_overlay.hpp"

#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <vector>

namespace opal {

/// Shapes for a page: {"faces": [x, y, x, y, ...], "circles": [x, y, r, ...], "points": [x, y, ...]} [m], frame `map`.
nlohmann::ordered_json shapes_of(const std::vector<Geometry>& geometries);

/// What there is to draw of proposals.
class ProposalPictures {
 public:
  /// @param map  must outlive it.
  explicit ProposalPictures(const SemanticMap& map);

  /// Everything that is mapped.
  nlohmann::ordered_json whole_map() const;
  /// "mapped": the object as the map has it; "proposed": what would stand there instead, with the neighbours that reach
  /// up to it; "sights": what each visit saw, in order.
  nlohmann::ordered_json of(const Proposal& proposal) const;

 private:
  std::vector<Geometry> mapped(const std::string& object) const;
  std::vector<Geometry> proposed(const Proposal& proposal) const;
  std::vector<Geometry> seen(const Proposal& proposal, const VisitSight& sight) const;

  const SemanticMap& map_;
  std::vector<std::size_t> features_;                          ///< each geometry once, whatever sensors perceive it
  std::map<std::string, std::vector<std::size_t>> at_point_;   ///< features by the points that they use
  std::map<std::string, std::vector<std::size_t>> of_object_;  ///< features by object
};

}  // namespace opal
