#pragma once

#include "simulation/buildings/floor_plan.hpp"
#include "simulation/buildings/variation.hpp"

namespace opal::simulation {

/// Thickness of walls between rooms [cm].
inline constexpr int kPartition_cm = 10;

struct PlannedBuilding {
  FloorPlan plan;
  int module = 0;  ///< see Building::module_m [cm]
};

/// Like the floor of Hendrikx 2023, 3.5.1: 20 x 41 m, rooms around open space, 154 concave corners.
PlannedBuilding plan_atlas();
/// Like the hall of Hendrikx 2023, 4.4: 70 x 17 m, open space and hallway, two rows of round columns.
PlannedBuilding plan_gemini();
/// Rooms on both sides of corridors that end in cross corridors.
PlannedBuilding plan_office(Variation& vary, double size_m2);
/// One hall with a grid of columns; niches, side rooms, pilasters and glass along its walls.
PlannedBuilding plan_hall(Variation& vary, double size_m2);
/// Racks in rows before a zone with dock doors.
PlannedBuilding plan_warehouse(Variation& vary, double size_m2);
/// Corridors and crossings around closed blocks with niches and doors.
PlannedBuilding plan_corridor(Variation& vary, double size_m2);

}  // namespace opal::simulation
