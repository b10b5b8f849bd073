#pragma once

#include <opal/common/geometry.hpp>

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace opal::ros2 {

/// Keeps poses in a thread of its own: a disk may take seconds, and nobody waits for it.
class PoseKeeper {
 public:
  using Keep = std::function<void(const Pose2& T_map_base)>;

  /// @param keep  called in the thread of this; it must not throw.
  explicit PoseKeeper(Keep keep);
  /// Waits for the pose that is being kept.
  ~PoseKeeper() = default;
  PoseKeeper(const PoseKeeper&) = delete;
  PoseKeeper& operator=(const PoseKeeper&) = delete;

  /// Returns at once. If poses come faster than they are kept, the newest one counts.
  void give(const Pose2& T_map_base);

 private:
  void work(const std::stop_token& stop);

  Keep keep_;
  std::mutex mutex_;
  std::condition_variable_any given_;
  std::optional<Pose2> newest_;
  std::jthread thread_;  // last: it ends before what it uses
};

}  // namespace opal::ros2
