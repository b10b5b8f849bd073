#pragma once

#include "grid.hpp"
#include "vectorizer_limits.hpp"

#include <opal/map/map_importer.hpp>

namespace opal::grid_importer {

/// Makes a map of the occupancy grid that a SLAM program saved for ROS's map_server (yaml file and image).
class GridImporter : public MapImporter {
 public:
  explicit GridImporter(const VectorizerLimits& limits) : limits_(limits) {}

  bool recognizes(const std::string& path) const override;
  MapImport import(const std::string& path) const override;

 private:
  VectorizerLimits limits_for(const OccupancyGrid& grid) const;

  VectorizerLimits limits_;
};

}  // namespace opal::grid_importer
