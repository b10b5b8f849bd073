#pragma once

#include "dxf_drawing.hpp"

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace opal::dxf_importer {

/// An entity where it stands in the drawing, after all blocks have been put in their places.
struct PlacedEntity {
  const DxfEntity* entity = nullptr;
  Eigen::Affine2d T_drawing_entity = Eigen::Affine2d::Identity();  ///< may scale, also differently by axis, and mirror
  std::string insert;  ///< ids of the INSERTs that it came by, "2F/31" or "2F[0,2]" in arrays; empty: by none
  std::vector<std::pair<std::string, std::string>> inserts;  ///< these ids and their layers, from the outermost on
  std::vector<std::string> blocks;                           ///< names of the blocks that it came by, as these
  std::string layer;                                         ///< that of its INSERT, if it is on layer 0 of a block
  std::string trouble;  ///< why it cannot be used, as far as blocks are to blame; then it may be an INSERT
  std::string damage;   ///< of the entity, of an INSERT that it came by, or of the name of their block: a whole message
  bool is_frozen = false;
};

/// All entities in model and paper space, in order.
/// @throws MapError naming the file and the block if blocks contain themselves, or if this gives more than 300,000
/// entities.
std::vector<PlacedEntity> expand_blocks(const std::string& path, const DxfDrawing& drawing);

}  // namespace opal::dxf_importer
