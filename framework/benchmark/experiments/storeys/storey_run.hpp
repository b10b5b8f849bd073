#pragma once

#include "simulation/drives/rides.hpp"

#include <opal/localization/localizer.hpp>

#include <functional>
#include <limits>
#include <optional>
#include <string>

namespace opal::experiments {

/// What became of one drive. Lengths are driven ways; of a ride, they begin when the robot leaves the cabin.
struct StoreyRun {
  bool is_ride = false;
  std::uint64_t seed = 0;
  std::string from, to;           ///< storeys; the same unless it is a ride
  std::string lift;               ///< of a ride
  bool localized_before = false;  ///< of a ride: rightly, when the robot came to rest in the cabin
  std::optional<double> right_from_m =
      {};  ///< the best hypothesis is at the right place of the right storey from here on
  std::optional<double> localized_from_m = {};  ///< and was called localized so for the first time
  bool is_right = false;                        ///< at the end: localized, right storey and place
  bool is_storey = false;                       ///< at the end: the storey named is right, whatever the status
  int answers = 0;
  int wrong = 0;                                                 ///< localized elsewhere than where the robot was
  int wrong_storey = 0;                                          ///< of these, on another storey
  double wrong_at_m = std::numeric_limits<double>::quiet_NaN();  ///< where the first of these was
  double driven_m = 0;
  double difference = 1;  ///< of the storey that is most like it: share of beams that end elsewhere there
};

/// What the drives of an experiment have in common.
struct StoreyWorld {
  const LocalizerParts& parts;  ///< of the localizer; its map holds storeys
  const simulation::SimulationOptions& world;
  /// Gets each drive as it was recorded, if it is set; from the threads in which drives run.
  std::function<void(const simulation::Recording&, std::uint64_t seed)> keep = {};
};

/// A drive about one storey from an unknown place on an unknown storey.
StoreyRun run_storey_drive(const StoreyWorld& world, const std::string& storey, const simulation::DriveOptions& drive,
                           std::uint64_t seed);

/// A ride in a lift; none if the lift cannot be reached.
std::optional<StoreyRun> run_ride(const StoreyWorld& world, const MapConnection& lift, const std::string& from,
                                  const std::string& to, const simulation::RideDriveOptions& options,
                                  std::uint64_t seed);

}  // namespace opal::experiments
