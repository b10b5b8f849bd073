#pragma once

#include "benchmark/experiments/integrity/drawn_drive.hpp"
#include "simulation/drives/building_suite.hpp"

#include <vector>

namespace opal::experiments {

/// Which drives a campaign has.
struct CampaignRequest {
  std::size_t drives = 10000;
  int buildings = 500;  ///< of every kind and difficulty (building_suite.hpp), by turns
  std::uint64_t seed = 1;
  double duration_s = 60;  ///< of each drive
};

/// The drives of a campaign. What happens in them is drawn by the seed: storeys, the map's faults, lasers, clutter,
/// people, kidnapping, faults of the sensor streams. Drive k does not depend on how many drives there are.
class Campaign {
 public:
  /// @throws ConfigError if there is no building.
  explicit Campaign(const CampaignRequest& request);

  std::size_t size() const { return request_.drives; }
  const CampaignRequest& request() const { return request_; }
  DrawnDrive drive(std::size_t number) const;

 private:
  CampaignRequest request_;
  std::vector<simulation::SuiteBuilding> buildings_;
};

/// What decides a campaign's drives, as a document.
nlohmann::ordered_json to_json(const CampaignRequest& request);

}  // namespace opal::experiments
