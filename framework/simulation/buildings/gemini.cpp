#include "simulation/buildings/kinds.hpp"

namespace opal::simulation {
namespace {

constexpr int kGeminiLength = 7000, kGeminiDepth = 1700;
constexpr int kPitchX = 740, kPitchY = 620, kRadius = 33;
constexpr int kFirstX = 170, kSouthY = 540;
constexpr int kNorthWall = 1640;  // of the open space, with niches as deep as the building
constexpr int kHallway = 4000;    // the open space ends here
constexpr int kHallwaySouth = 410, kHallwayNorth = 1290;

constexpr int column_x(int number) { return kFirstX + number * kPitchX; }

void open_space(FloorPlan& plan) {
  plan.room({0, 0, kHallway, kNorthWall});
  plan.room({kHallway, kHallwaySouth, kGeminiLength, kHallwayNorth});
  // Pilasters of the south facade, some with glass between them; the north wall has shafts of other pitch.
  for (int k = 0; k < 5; ++k) plan.wall({column_x(k) - 25, 0, column_x(k) + 25, 35});
  for (const int k : {0, 1, 3}) plan.facade_glass({column_x(k) + 90, -10, column_x(k) + 560, 0});
  plan.facade_glass({-10, 620, 0, 1080});
  plan.wall({0, 1510, 260, kNorthWall});
  plan.wall({900, 1590, 990, kNorthWall});
  plan.wall({1980, 1480, 2420, kNorthWall});
  plan.wall({3130, 1590, 3220, kNorthWall});
  plan.open({1250, kNorthWall, 1680, kGeminiDepth});
  plan.open({2700, kNorthWall, 2960, kGeminiDepth});
}

/// What stands in the open space and in the hallway: stairs, lifts, shafts, between the columns.
void building_elements(FloorPlan& plan) {
  plan.wall({column_x(2) + 180, 720, column_x(2) + 560, 1010});  // stairs, with a landing cut out
  plan.open({column_x(2) + 180, 790, column_x(2) + 300, 940});
  plan.wall({column_x(6) + 130, 700, column_x(6) + 610, 1000});  // lifts, two doors in recesses
  plan.open({column_x(6) + 190, 700, column_x(6) + 310, 720});
  plan.open({column_x(6) + 410, 700, column_x(6) + 530, 720});
  plan.wall({column_x(8) + 200, 730, column_x(8) + 420, 950});  // shaft
  plan.wall({6550, 950, kGeminiLength, kHallwayNorth});         // emergency stairs, where a tenth column would stand
}

/// Rooms along the hallway.
void rooms(FloorPlan& plan) {
  plan.room({4020, 1310, 4480, kGeminiDepth});
  plan.door({4300, kHallwayNorth, 4400, 1310});
  plan.room({4500, 1310, 5220, kGeminiDepth});
  plan.door({4560, kHallwayNorth, 4660, 1310});
  plan.pane({4760, kHallwayNorth, 5160, 1310});
  plan.room({5240, 1310, 5600, kGeminiDepth});
  plan.door({5300, kHallwayNorth, 5400, 1310});
  plan.room({5960, 1310, 6500, kGeminiDepth});
  plan.door({6200, kHallwayNorth, 6300, 1310});
  plan.open({5680, kHallwayNorth, 5860, 1370});  // a pantry
  plan.room({4300, 0, 4960, 390});
  plan.door({4340, 390, 4440, kHallwaySouth});
  plan.room({4980, 0, 5420, 390});
  plan.door({5280, 390, 5380, kHallwaySouth});
  plan.room({5700, 0, 6560, 390});
  plan.door({5780, 390, 5880, kHallwaySouth});
  plan.pane({6000, 390, 6400, kHallwaySouth});
  plan.open({4060, 300, 4220, kHallwaySouth});
  plan.open({6660, 330, 6900, kHallwaySouth});
}

}  // namespace

PlannedBuilding plan_gemini() {
  PlannedBuilding building;
  FloorPlan& plan = building.plan;
  open_space(plan);
  rooms(plan);
  building_elements(plan);
  for (int k = 0; k < 10; ++k) plan.column(column_x(k), kSouthY, kRadius);
  for (int k = 0; k < 9; ++k) plan.column(column_x(k), kSouthY + kPitchY, kRadius);
  return building;
}

}  // namespace opal::simulation
