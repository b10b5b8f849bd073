#include "simulation/buildings/kinds.hpp"

namespace opal::simulation {
namespace {

constexpr int kGeminiLength_cm = 7000, kGeminiDepth_cm = 1700;
constexpr int kPitchX_cm = 740, kPitchY_cm = 620, kRadius_cm = 33;
constexpr int kFirstX_cm = 170, kSouthY_cm = 540;
constexpr int kNorthWall_cm = 1640;  // of the open space, with niches as deep as the building
constexpr int kHallway_cm = 4000;    // the open space ends here
constexpr int kHallwaySouth_cm = 410, kHallwayNorth_cm = 1290;

constexpr int column_x(int number) { return kFirstX_cm + number * kPitchX_cm; }

void open_space(FloorPlan& plan) {
  plan.room({0, 0, kHallway_cm, kNorthWall_cm});
  plan.room({kHallway_cm, kHallwaySouth_cm, kGeminiLength_cm, kHallwayNorth_cm});
  // Pilasters of the south facade, some with glass between them; the north wall has shafts of other pitch.
  for (int k = 0; k < 5; ++k) plan.wall({column_x(k) - 25, 0, column_x(k) + 25, 35});
  for (const int k : {0, 1, 3}) plan.facade_glass({column_x(k) + 90, -10, column_x(k) + 560, 0});
  plan.facade_glass({-10, 620, 0, 1080});
  plan.wall({0, 1510, 260, kNorthWall_cm});
  plan.wall({900, 1590, 990, kNorthWall_cm});
  plan.wall({1980, 1480, 2420, kNorthWall_cm});
  plan.wall({3130, 1590, 3220, kNorthWall_cm});
  plan.open({1250, kNorthWall_cm, 1680, kGeminiDepth_cm});
  plan.open({2700, kNorthWall_cm, 2960, kGeminiDepth_cm});
}

/// What stands in the open space and in the hallway: stairs, lifts, shafts, between the columns.
void building_elements(FloorPlan& plan) {
  plan.wall({column_x(2) + 180, 720, column_x(2) + 560, 1010});  // stairs, with a landing cut out
  plan.open({column_x(2) + 180, 790, column_x(2) + 300, 940});
  plan.wall({column_x(6) + 130, 700, column_x(6) + 610, 1000});  // lifts, two doors in recesses
  plan.open({column_x(6) + 190, 700, column_x(6) + 310, 720});
  plan.open({column_x(6) + 410, 700, column_x(6) + 530, 720});
  plan.wall({column_x(8) + 200, 730, column_x(8) + 420, 950});  // shaft
  plan.wall({6550, 950, kGeminiLength_cm, kHallwayNorth_cm});   // emergency stairs, where a tenth column would stand
}

/// Rooms along the hallway.
void rooms(FloorPlan& plan) {
  plan.room({4020, 1310, 4480, kGeminiDepth_cm});
  plan.door({4300, kHallwayNorth_cm, 4400, 1310});
  plan.room({4500, 1310, 5220, kGeminiDepth_cm});
  plan.door({4560, kHallwayNorth_cm, 4660, 1310});
  plan.pane({4760, kHallwayNorth_cm, 5160, 1310});
  plan.room({5240, 1310, 5600, kGeminiDepth_cm});
  plan.door({5300, kHallwayNorth_cm, 5400, 1310});
  plan.room({5960, 1310, 6500, kGeminiDepth_cm});
  plan.door({6200, kHallwayNorth_cm, 6300, 1310});
  plan.open({5680, kHallwayNorth_cm, 5860, 1370});  // a pantry
  plan.room({4300, 0, 4960, 390});
  plan.door({4340, 390, 4440, kHallwaySouth_cm});
  plan.room({4980, 0, 5420, 390});
  plan.door({5280, 390, 5380, kHallwaySouth_cm});
  plan.room({5700, 0, 6560, 390});
  plan.door({5780, 390, 5880, kHallwaySouth_cm});
  plan.pane({6000, 390, 6400, kHallwaySouth_cm});
  plan.open({4060, 300, 4220, kHallwaySouth_cm});
  plan.open({6660, 330, 6900, kHallwaySouth_cm});
}

}  // namespace

PlannedBuilding plan_gemini() {
  PlannedBuilding building;
  FloorPlan& plan = building.plan;
  open_space(plan);
  rooms(plan);
  building_elements(plan);
  for (int k = 0; k < 10; ++k) plan.column(column_x(k), kSouthY_cm, kRadius_cm);
  for (int k = 0; k < 9; ++k) plan.column(column_x(k), kSouthY_cm + kPitchY_cm, kRadius_cm);
  return building;
}

}  // namespace opal::simulation
