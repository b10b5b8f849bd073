#include "benchmark/experiments/goals/goal_watch.hpp"

#include <algorithm>
#include <functional>

namespace opal::experiments {
namespace {

using navigation::Blackboard;
using navigation::Node;
using navigation::NodeStatus;

/// Tells that its node is ticked.
class Told : public Node {
 public:
  using Tell = std::function<void(bool begins)>;
  Told(std::unique_ptr<Node> node, Tell tell) : node_(std::move(node)), tell_(std::move(tell)) {}
  NodeStatus tick(Blackboard& blackboard) override {
    tell_(!running_);
    const NodeStatus outcome = node_->tick(blackboard);
    running_ = outcome == NodeStatus::running;
    return outcome;
  }
  void halt() override {
    running_ = false;
    node_->halt();
  }

 private:
  std::unique_ptr<Node> node_;
  Tell tell_;
  bool running_ = false;
};

/// A tree, and somebody who looks on after each tick.
class LookedOn : public Node {
 public:
  LookedOn(std::unique_ptr<Node> tree, std::function<void(const Blackboard&)> look)
      : tree_(std::move(tree)), look_(std::move(look)) {}
  NodeStatus tick(Blackboard& blackboard) override {
    const NodeStatus outcome = tree_->tick(blackboard);
    look_(blackboard);
    return outcome;
  }
  void halt() override { tree_->halt(); }

 private:
  std::unique_ptr<Node> tree_;
  std::function<void(const Blackboard&)> look_;
};

bool some_is_right(const PoseEstimate& estimate, const Pose2& truth) {
  if (kRightPose.holds(estimate.T_map_base, truth)) return true;
  return std::any_of(
      estimate.alternatives.begin(), estimate.alternatives.end(),
      [&](const PoseEstimate::Alternative& alternative) { return kRightPose.holds(alternative.T_map_base, truth); });
}

/// The first columns of what a hypothesis rests on, at most so many.
std::vector<Point> columns_of(const std::vector<Geometry>& features, int most) {
  std::vector<Point> columns;
  for (const Geometry& feature : features)
    if (std::holds_alternative<Circle>(feature) && static_cast<int>(columns.size()) < most)
      columns.push_back(anchor_of(feature));
  return columns;
}

/// B for two columns, C for three in line, L for others; "" if there are fewer.
std::string letter_of(const std::vector<Point>& columns, int size) {
  if (static_cast<int>(columns.size()) < size) return "";
  if (size == 2) return "B";
  // In line: the longest side is nearly as long as the other two.
  std::vector<double> sides{(columns[0] - columns[1]).norm(), (columns[1] - columns[2]).norm(),
                            (columns[2] - columns[0]).norm()};
  std::sort(sides.begin(), sides.end());
  return sides[2] > 0.97 * (sides[0] + sides[1]) ? "C" : "L";
}

int places_of(const PoseEstimate& estimate) {
  return estimate.has_pose ? 1 + static_cast<int>(estimate.alternatives.size()) : 0;
}

}  // namespace

std::unique_ptr<Node> GoalWatch::watched_tree(const std::string& trees, const std::string& name) {
  navigation::NodeRegistry nodes = navigation::standard_nodes();
  nodes.wrap("opal:BackOff", [this](std::unique_ptr<Node> node) {
    return std::make_unique<Told>(std::move(node), [this](bool begins) { run_.recoveries += begins; });
  });
  nodes.wrap("opal:GoToGoal", [this](std::unique_ptr<Node> node) {
    return std::make_unique<Told>(std::move(node), [this](bool) { under_way_ = true; });
  });
  return std::make_unique<LookedOn>(read_tree(nodes, trees, name),
                                    [this](const Blackboard& blackboard) { look(blackboard); });
}

void GoalWatch::look(const Blackboard& blackboard) {
  const PoseEstimate& said = blackboard.estimate();
  if (under_way_ && run_.places_after_inspection < 0) run_.places_after_inspection = places_of(said);
  run_.places_at_end = places_of(said);
  look_at_hypotheses(blackboard);
  JudgedMoment moment{simulation_.now_s(), 0,           simulation_.T_map_base(), said.T_map_base,
                      said.has_pose,       said.status, said.hypotheses,          0,
                      under_way_};
  if (!run_.moments.empty())
    moment.driven_m = run_.moments.back().driven_m + distance_m(run_.moments.back().truth, moment.truth);
  run_.moments.push_back(moment);
  under_way_ = false;
}

void GoalWatch::look_at_hypotheses(const Blackboard& blackboard) {
  const PoseEstimate& said = blackboard.estimate();
  const bool right = said.has_pose && some_is_right(said, simulation_.T_map_base());
  if (said.has_pose && !had_pose_) note_start(blackboard, right);
  if (right && run_.right_after_s == kNever) note_right(blackboard);
  if (right && !run_.starts.empty()) run_.starts.back().right = true;
  right_since_start_ = right_since_start_ || right;
  if (!said.has_pose && had_pose_) {
    ++run_.recoveries;
    run_.wrong_starts += !right_since_start_;
    right_since_start_ = false;
  }
  had_pose_ = said.has_pose;
}

void GoalWatch::note_start(const Blackboard& blackboard, bool right) {
  const Pose2& truth = simulation_.T_map_base();
  GoalRun::Start start{truth.position(), {}, right};
  const std::vector<Point> columns = columns_of(blackboard.localization.pattern(), pattern_size_);
  for (const Point& column : columns) start.features.push_back(truth * column);
  if (run_.right_after_s == kNever) run_.pattern = letter_of(columns, pattern_size_);
  run_.starts.push_back(std::move(start));
}

void GoalWatch::note_right(const Blackboard& blackboard) {
  run_.right_after_s = simulation_.now_s();
  if (run_.pattern.empty())
    run_.pattern = letter_of(columns_of(blackboard.localization.pattern(), pattern_size_), pattern_size_);
  for (const LocalFeature& local : localizer_.local_map().features()) {
    if (!std::holds_alternative<Circle>(local.feature.geometry)) continue;
    ++run_.candidates;
    run_.circles += local.stable;
  }
}

void GoalWatch::finish() { run_.wrong_starts += had_pose_ && !right_since_start_; }

}  // namespace opal::experiments
