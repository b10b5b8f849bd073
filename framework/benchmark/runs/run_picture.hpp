#pragma once

#include "benchmark/runs/run_record.hpp"

#include "drawing/drawing.hpp"

namespace opal::benchmark {

/// The localizer's present opinion as a picture: map, newest scan, hypotheses, associations, the way so far.
opal::DrawingScene scene_of(const opal::Localizer& localizer, const opal::LaserModel& laser, const RunRecord& record);

/// Adds recorded truth, given as poses of the laser, as the way of the robot.
void add_truth(opal::DrawingScene& scene, const std::vector<opal::StampedPose>& T_map_laser,
               const opal::LaserModel& laser);

}  // namespace opal::benchmark
