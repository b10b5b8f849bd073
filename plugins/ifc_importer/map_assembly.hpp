#pragma once

#include "duplicates.hpp"
#include "import_options.hpp"
#include "plan.hpp"
#include "storey_cut.hpp"

#include <opal/map/semantic_map.hpp>

namespace opal::ifc_importer {

/// What came of the plan, for the report.
struct AssembledMap {
  std::shared_ptr<const SemanticMap> map;
  int faces = 0, corners = 0, circles = 0;
  double length_m = 0;
  int posts = 0;                           ///< too thin to be features
  int specks = 0;                          ///< faces too short to be features
  std::vector<std::string> hidden;         ///< ids of solids of which nothing is visible
  std::vector<std::string> hidden_rounds;  ///< ids of round things that stand too deep in others to be circles
};

/// @param cuts  those that come into the map; `plan` was made of the solids among them, in `order`: positions in
/// `cuts`.
AssembledMap assemble(const std::string& name, const std::vector<ElementCut>& cuts, const Plan& plan,
                      const std::vector<std::size_t>& order, const Duplicates& duplicates, const MapOrigin& origin,
                      const std::string& sensor);

}  // namespace opal::ifc_importer
