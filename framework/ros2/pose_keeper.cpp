#include "ros2/pose_keeper.hpp"

#include <chrono>
#include <utility>

namespace opal::ros2 {
namespace {

constexpr double kForEver_s = 1e6;
constexpr std::chrono::milliseconds kLookAgain{1000};

}  // namespace

PoseKeeper::PoseKeeper(Keep keep)
    : keep_(std::move(keep)), thread_([this](const std::stop_token& stop) { work(stop); }) {}

PoseKeeper::~PoseKeeper() { poses_.drain(kForEver_s); }

void PoseKeeper::work(const std::stop_token& stop) {
  while (!stop.stop_requested())
    if (const auto T_map_base = poses_.next(stop, kLookAgain)) keep_(*T_map_base);
}

}  // namespace opal::ros2
