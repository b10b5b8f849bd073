#pragma once

#include "building.hpp"
#include "classes.hpp"
#include "region.hpp"

#include <vector>

namespace opal::ifc_importer {

/// What the plane at the sensor's height shows of one thing.
struct ElementCut {
  const Element* element = nullptr;
  const Element* object = nullptr;  ///< what stands for it in the map: what it is a part of, or itself
  Treatment treatment;
  std::vector<Loop> outline;     ///< of all of it, without its openings
  std::vector<Loop> solid;       ///< what a LiDAR sees
  std::vector<Loop> unseen;      ///< leaf, pane, glass
  double width_m = 0;            ///< of a door or window
  std::string trouble;           ///< why it has no outline although it is there
  bool is_within_reach = false;  ///< the plane lies between its lowest and its highest point

  bool is_cut() const { return !outline.empty(); }
};

/// Cuts every thing of the building, whatever storey holds it: columns run through. In the order of the elements.
std::vector<ElementCut> cut_storey(const Building& building, const Classes& classes, double height_m);

}  // namespace opal::ifc_importer
