#include "closed_loop/closed_loop.hpp"

#include "evaluation/pose_tolerance.hpp"

#include <chrono>
#include <thread>

namespace opal {
namespace {

constexpr int kStepsPerTick = 2;

/// One drive under way.
class ClosedLoop {
 public:
  ClosedLoop(simulation::Simulation& simulation, navigation::Localization& localization,
             const ClosedLoopOptions& options)
      : simulation_(simulation), localization_(localization), options_(options) {
    localization_.begin();
  }

  DriveRecord run(const FloorGrid& floor, navigation::Node& tree, const Point& goal) {
    const navigation::MotionPrimitives motion(options_.motion);
    navigation::Blackboard blackboard(localization_, motion, floor, goal);
    const double start_s = simulation_.now_s();
    tree.halt();
    for (auto outcome = navigation::NodeStatus::running; outcome == navigation::NodeStatus::running;) {
      sense();
      outcome = localization_.answers() ? decide(blackboard, tree) : wait(blackboard);
      record_.said_so = outcome == navigation::NodeStatus::success;
      record_.time_s = simulation_.now_s() - start_s;
      if (record_.time_s >= options_.most_s || record_.said_so || options_.stop.stop_requested()) break;
      outcome = navigation::NodeStatus::running;  // a robot that has failed tries again
      move(localization_.answers() ? blackboard.velocity() : Velocity{});
    }
    record_.off_goal_m = (simulation_.T_map_base().position() - goal).norm();
    record_.reached = record_.said_so && record_.off_goal_m < options_.reached_m;
    if (!record_.reached) record_.why = why_not(blackboard.estimate());
    return std::move(record_);
  }

 private:
  std::string why_not(const PoseEstimate& estimate) const {
    if (record_.said_so) return "it took another place for the goal";
    if (estimate.status == Status::localized) return "it knew where it was, and the time was up before it was there";
    if (!estimate.has_pose) return "it had no idea where it was when the time was up";
    if (estimate.alternatives.empty()) return "it was not sure of its pose when the time was up";
    return "nothing that it saw told " + std::to_string(estimate.alternatives.size() + 1) +
           " places apart, at each of which it could be, before the time was up";
  }

  navigation::NodeStatus decide(navigation::Blackboard& blackboard, navigation::Node& tree) {
    blackboard.look();
    const navigation::NodeStatus outcome = tree.tick(blackboard);
    if (blackboard.wants_pattern_alone()) localization_.keep_pattern();
    return outcome;
  }

  /// Whoever waits has not been stuck.
  navigation::NodeStatus wait(navigation::Blackboard& blackboard) const {
    std::this_thread::sleep_for(std::chrono::duration<double>(options_.tick_s));
    blackboard.forget_being_stuck();
    return navigation::NodeStatus::running;
  }

  void sense() {
    const RawScan raw = simulation_.scan();
    if (options_.witness) options_.witness(raw, simulation_.T_map_base());
    localization_.take(raw);
    if (!localization_.answers()) {
      ++record_.unanswered_scans;
      return;
    }
    const PoseEstimate estimate = localization_.estimate();
    const Pose2& truth = simulation_.T_map_base();
    record_.moments.push_back({raw.stamp_s, truth, estimate.T_map_base, estimate.has_pose, estimate.status});
    ++record_.scans;
    if (estimate.status != Status::localized) return;
    ++record_.localized_scans;
    if (!kRightPose.holds(estimate.T_map_base, truth)) {
      ++record_.falsely_localized_scans;
    } else if (!record_.localized_after_m) {
      record_.localized_after_m = record_.driven_m;
      record_.localized_after_s = simulation_.now_s();
    }
  }

  void move(const Velocity& velocity) {
    for (int k = 0; k < kStepsPerTick; ++k) {
      const Pose2 before = simulation_.T_map_base();
      if (auto touched = simulation_.drive(velocity, options_.tick_s / kStepsPerTick))
        record_.collisions.push_back({simulation_.now_s(), before, velocity, *touched});
      record_.driven_m += distance_m(before, simulation_.T_map_base());
    }
  }

  simulation::Simulation& simulation_;
  navigation::Localization& localization_;
  ClosedLoopOptions options_;
  DriveRecord record_;
};

}  // namespace

DriveRecord drive_to_goal(simulation::Simulation& simulation, navigation::Localization& localization,
                          const FloorGrid& floor, navigation::Node& tree, const Point& goal,
                          const ClosedLoopOptions& options) {
  return ClosedLoop(simulation, localization, options).run(floor, tree, goal);
}

DriveRecord drive_to_goal(simulation::Simulation& simulation, Localizer& localizer, const FloorGrid& floor,
                          navigation::Node& tree, const Point& goal, const ClosedLoopOptions& options) {
  navigation::LocalizerQueries localization(localizer, simulation.options().laser);
  return drive_to_goal(simulation, localization, floor, tree, goal, options);
}

}  // namespace opal
