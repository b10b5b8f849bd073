#include "benchmark/experiments/integrity/campaign.hpp"

#include <opal/common/error.hpp>

namespace opal::experiments {
namespace {

// How often what happens. Every kind has some hundred drives of ten thousand, and nothing the user would meet daily is
// rare.
constexpr std::uint64_t kStoreyedEvery = 5;  // buildings, of each kind and difficulty
constexpr int kStoreys = 3;
constexpr double kTwoLasers = 0.5, kFurnished = 0.3, kMostFurniture = 0.6, kKidnapped = 0.15, kFaulty = 0.4;
constexpr int kMostPeople = 6;

/// Shares of `kMapStates`; maps of several storeys are drawn from the first three.
constexpr std::array kMapShares{0.45, 0.1, 0.2, 0.15, 0.1};
constexpr std::size_t kStateOfStoreys = 3;

MapState drawn_state(Random& random, std::size_t states) {
  double whole = 0;
  for (std::size_t k = 0; k < states; ++k) whole += kMapShares[k];
  double at = random.uniform(0, whole);
  for (std::size_t k = 0; k + 1 < states; ++k) {
    at -= kMapShares[k];
    if (at < 0) return kMapStates[k];
  }
  return kMapStates[states - 1];
}

void draw_event(DrawnDrive& drive, Random& random) {
  const double at = random.share();
  drive.is_kidnapped = at < kKidnapped;
  const std::size_t fault = random.below(simulation::kFaults.size());
  if (at >= kKidnapped && at < kKidnapped + kFaulty) drive.fault = simulation::kFaults[fault];
}

}  // namespace

Campaign::Campaign(const CampaignRequest& request) : request_(request) {
  simulation::SuiteRequest suite;
  suite.buildings = request.buildings;
  buildings_ = building_suite(suite);
  if (buildings_.empty()) throw ConfigError("campaign: no building, expected at least one");
}

DrawnDrive Campaign::drive(std::size_t number) const {
  const simulation::SuiteBuilding& building = buildings_[number % buildings_.size()];
  Random random(request_.seed * 1'000'003 + number);
  DrawnDrive drive;
  drive.number = number;
  drive.building_id = building.id;
  drive.building = building.request;
  drive.storeys = building.request.seed % kStoreyedEvery == 0 ? kStoreys : 1;
  drive.storey = static_cast<int>(random.below(static_cast<std::size_t>(drive.storeys)));
  drive.map_state = drawn_state(random, drive.storeys > 1 ? kStateOfStoreys : kMapStates.size());
  drive.damage = random.share();
  drive.has_two_lasers = random.chance(kTwoLasers);
  drive.clutter = building.clutter;
  const double furniture = random.uniform(0, kMostFurniture);
  drive.along_walls = random.chance(kFurnished) ? furniture : 0;
  drive.people = static_cast<int>(random.below(kMostPeople + 1));
  drive.doors_open_share = random.share();
  draw_event(drive, random);
  drive.duration_s = request_.duration_s;
  drive.seed = static_cast<std::uint64_t>(random.uniform(1, 1e9));
  return drive;
}

nlohmann::ordered_json to_json(const CampaignRequest& request) {
  return {{"drives", request.drives},
          {"buildings", request.buildings},
          {"seed", request.seed},
          {"duration_s", request.duration_s}};
}

}  // namespace opal::experiments
