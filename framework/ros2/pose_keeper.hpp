#pragma once

#include "common/task_queue.hpp"

#include <opal/common/geometry.hpp>

#include <functional>
#include <thread>

namespace opal::ros2 {

/// Keeps poses in a thread of its own: a disk may take seconds, and nobody waits for it.
class PoseKeeper {
 public:
  using Keep = std::function<void(const Pose2& T_map_base)>;

  /// @param keep  called in the thread of this; it must not throw.
  explicit PoseKeeper(Keep keep);
  /// Waits until the last pose is kept.
  ~PoseKeeper();
  PoseKeeper(const PoseKeeper&) = delete;
  PoseKeeper& operator=(const PoseKeeper&) = delete;

  /// Returns at once. If poses come faster than they are kept, the newest one counts.
  void give(const Pose2& T_map_base) { poses_.give(T_map_base); }

 private:
  void work(const std::stop_token& stop);

  Keep keep_;
  TaskQueue<Pose2> poses_{1};
  std::jthread thread_;  // last: it ends before what it uses
};

}  // namespace opal::ros2
