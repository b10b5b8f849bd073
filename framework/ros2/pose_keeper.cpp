#include "ros2/pose_keeper.hpp"

#include <utility>

namespace opal::ros2 {

PoseKeeper::PoseKeeper(Keep keep)
    : keep_(std::move(keep)), thread_([this](const std::stop_token& stop) { work(stop); }) {}

void PoseKeeper::give(const Pose2& T_map_base) {
  {
    const std::lock_guard lock(mutex_);
    newest_ = T_map_base;
  }
  given_.notify_one();
}

void PoseKeeper::work(const std::stop_token& stop) {
  while (true) {
    std::unique_lock lock(mutex_);
    if (!given_.wait(lock, stop, [this] { return newest_.has_value(); })) return;
    const Pose2 pose = *std::exchange(newest_, std::nullopt);
    lock.unlock();
    keep_(pose);
  }
}

}  // namespace opal::ros2
