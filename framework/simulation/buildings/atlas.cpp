#include "simulation/buildings/kinds.hpp"

namespace opal::simulation {
namespace {

constexpr int kAtlasWidth_cm = 2000, kAtlasLength_cm = 4100;

/// Floor-high openings of the facades, between pilasters that stand 3.6 m apart.
void facades(FloorPlan& plan) {
  for (int y = 250; y < kAtlasLength_cm - 100; y += 360) {
    plan.wall({0, y, 25, y + 45});
    plan.wall({kAtlasWidth_cm - 25, y, kAtlasWidth_cm, y + 45});
  }
  for (int x = 380; x < kAtlasWidth_cm - 300; x += 400) plan.wall({x, 0, x + 40, 30});
  for (const int x : {300, 800, 1100, 1450, 1800}) plan.wall({x, kAtlasLength_cm - 30, x + 40, kAtlasLength_cm});
  plan.facade_glass({1520, kAtlasLength_cm, 1770, kAtlasLength_cm + 10});
  plan.facade_glass({460, -10, 740, 0});
  plan.facade_glass({1260, -10, 1540, 0});
  plan.facade_glass({kAtlasWidth_cm, 320, kAtlasWidth_cm + 10, 590});
}

/// Open space in the south and in the north, joined by corridors on both sides of the core.
void open_spaces(FloorPlan& plan) {
  plan.room({0, 0, kAtlasWidth_cm, 1300});
  plan.room({490, 1300, 690, 2800});    // west corridor
  plan.room({1310, 1300, 1510, 2800});  // east corridor
  plan.room({490, 2800, kAtlasWidth_cm, 3500});
  for (const int x : {560, 1395})
    for (const int y : {420, 900}) plan.wall({x, y, x + 45, y + 45});
  plan.wall({980, 3120, 1025, 3165});
  plan.wall({1500, 3120, 1545, 3165});
}

/// Lifts, stairs and shafts in the middle.
void core(FloorPlan& plan) {
  plan.room({690, 1880, 1310, 2080});  // lift lobby
  for (const int x : {740, 930, 1120}) {
    plan.open({x, 1860, x + 120, 1880});
    plan.open({x, 2080, x + 120, 2100});
  }
  plan.room({760, 1400, 1010, 1780});  // toilets
  plan.door({690, 1500, 760, 1600});
  plan.wall({760, 1640, 880, 1655});
  plan.room({1040, 1400, 1240, 1780});  // pantry, open to the corridor
  plan.open({1240, 1460, 1310, 1720});
  plan.wall({1040, 1400, 1100, 1500});
  plan.room({770, 2200, 1230, 2560});  // stairs
  plan.door({1230, 2300, 1310, 2400});
  plan.wall({770, 2330, 1080, 2430});
  plan.open({840, 1270, 1160, 1330});  // wall of lockers
  plan.open({690, 2640, 740, 2740});
  plan.open({900, 2740, 1100, 2800});
}

/// Rooms of one side, from the south; doors into the corridor.
void west_rooms(FloorPlan& plan) {
  plan.room({0, 1310, 480, 1720});
  plan.door({480, 1340, 490, 1440});
  plan.room({0, 1730, 480, 2300});
  plan.door({480, 1760, 490, 1860});
  plan.pane({480, 1920, 490, 2220});
  plan.wall({430, 2240, 480, 2300});
  plan.room({0, 2310, 480, 2640});
  plan.door({480, 2520, 490, 2620});
  plan.room({0, 2650, 480, 3180});
  plan.door({480, 2900, 490, 3000});
  plan.wall({0, 3120, 80, 3180});
  plan.room({0, 3190, 480, 3500});
  plan.door({480, 3220, 490, 3320});
}

void east_rooms(FloorPlan& plan) {
  plan.room({1520, 1310, kAtlasWidth_cm, 1640});
  plan.door({1510, 1500, 1520, 1600});
  plan.room({1520, 1650, kAtlasWidth_cm, 2240});
  plan.door({1510, 1690, 1520, 1790});
  plan.wall({1940, 2180, kAtlasWidth_cm, 2240});
  plan.pane({1510, 1860, 1520, 2180});
  plan.room({1520, 2250, kAtlasWidth_cm, 2790});
  plan.door({1510, 2640, 1520, 2740});
  plan.wall({1520, 2250, 1590, 2310});
}

void north_rooms(FloorPlan& plan) {
  plan.room({0, 3510, 640, kAtlasLength_cm});
  plan.door({510, 3500, 610, 3510});
  plan.room({650, 3510, 960, kAtlasLength_cm});
  plan.door({680, 3500, 780, 3510});
  plan.room({970, 3510, 1240, kAtlasLength_cm});
  plan.door({1110, 3500, 1210, 3510});
  plan.room({1250, 3510, kAtlasWidth_cm, kAtlasLength_cm});
  plan.door({1290, 3500, 1390, 3510});
  plan.pane({1460, 3500, 1860, 3510});
}

}  // namespace

PlannedBuilding plan_atlas() {
  PlannedBuilding building;
  open_spaces(building.plan);
  core(building.plan);
  west_rooms(building.plan);
  east_rooms(building.plan);
  north_rooms(building.plan);
  facades(building.plan);
  return building;
}

}  // namespace opal::simulation
