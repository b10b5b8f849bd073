#pragma once

#include "simulation/drives/faults.hpp"
#include "simulation/drives/recording.hpp"

#include <opal/live/live_localizer.hpp>
#include <opal/localization/localizer.hpp>

#include <memory>
#include <string>
#include <vector>

/// A robot with two lasers that has driven for a minute through a generated hall, and what it said on the way.
struct LiveRobot {
  explicit LiveRobot(double duration_s = 60);
  LiveRobot(std::vector<opal::LaserModel> lasers, double scan_every_s, double duration_s);

  /// Of a localizer that knows the lasers as they are.
  opal::LocalizerParts parts() const;
  /// The same with the lasers as somebody wrongly describes them.
  opal::LocalizerParts parts(std::vector<opal::LaserModel> described) const;
  opal::Pose2 truth_at(double stamp_s) const;
  /// The same drive at another time. From its end to its start the robot is carried.
  std::vector<opal::simulation::Arrival> later(double by_s) const;

  std::shared_ptr<const opal::SemanticMap> map;
  std::vector<opal::LaserModel> lasers;
  opal::simulation::Recording recording;
  std::vector<opal::simulation::Arrival> arrivals;
};

/// One for all tests that only look at it.
const LiveRobot& robot();

/// Two lasers, front and rear, of 190 degrees each.
std::vector<opal::LaserModel> front_and_rear();
