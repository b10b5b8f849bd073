#pragma once

#include "benchmark/experiments/integrity/drawn_drive.hpp"
#include "simulation/drives/recording.hpp"

#include <opal/deployment/deployment.hpp>

#include <filesystem>
#include <memory>

namespace opal::experiments {

/// The robots of a campaign, and the plugins that they run.
struct CampaignRobots {
  Deployment one_laser, two_lasers;  ///< with the lasers that are simulated
  const PluginRegistry* registry = nullptr;

  const Deployment& of(const DrawnDrive& drive) const { return drive.has_two_lasers ? two_lasers : one_laser; }
};

/// What a drive takes place in. Frame `map`.
struct DriveWorld {
  std::shared_ptr<const SemanticMap> building;  ///< as it is: the storey on which the robot drives
  std::shared_ptr<const SemanticMap> map;       ///< all storeys, as the robot has them
};

/// Makes the building of a drive and the robot's map of it.
/// @param scratch  folder for a file that is removed again.
/// @throws MapError if a robot has no floor there, or nothing is left of the map.
DriveWorld world_of(const DrawnDrive& drive, const CampaignRobots& robots, const std::filesystem::path& scratch);

/// The map of a building that another team draws, which goes into every room.
std::shared_ptr<const SemanticMap> redrawn_map(const std::shared_ptr<const SemanticMap>& building,
                                               const DrawnDrive& drive, const CampaignRobots& robots,
                                               const std::filesystem::path& scratch);

/// A wrong map of a building, with the changes that some drives through it teach.
std::shared_ptr<const SemanticMap> learned_map(const std::shared_ptr<const SemanticMap>& building,
                                               const std::shared_ptr<const SemanticMap>& wrong, const DrawnDrive& drive,
                                               const CampaignRobots& robots);

/// The drive as the robot's sensors record it, without faults of their streams.
simulation::Recording recorded(const DrawnDrive& drive, const DriveWorld& world, const Deployment& robot);

}  // namespace opal::experiments
