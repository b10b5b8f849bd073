#pragma once

#include "step_text.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace opal::ifc_importer {

/// The arguments of an instance one by one: what stands between its commas, outside of texts and parentheses.
std::vector<std::string_view> split_arguments(std::string_view arguments);

/// 12 of "#12"; -1 if an argument is no reference.
int referred_by(std::string_view argument);

/// The arguments of an instance of IFC4X3 as IFC4 has them, where that makes geometry: placements by grids say first
/// what they are relative to, lists of points may have tags, sets of triangles say earlier whether they are closed.
std::string arguments_of_ifc4(const StepInstance& instance);

/// The arguments of an instance without some of its references: `$` where one stood alone, nothing where it stood in a
/// list.
std::string arguments_without(std::string_view arguments, const std::vector<int>& numbers);

/// A piece of an IfcIndexedPolyCurve, by numbers of its points from 1 on.
struct IndexedSegment {
  bool is_arc = false;  ///< from the first of three points through the second to the third
  std::vector<int> points;
};

/// Of "(IFCLINEINDEX((1,2)),IFCARCINDEX((2,3,4)))"; a piece that is neither has no points.
std::vector<IndexedSegment> indexed_segments(std::string_view argument);

}  // namespace opal::ifc_importer
