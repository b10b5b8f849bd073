#include "ros2/pose_keeper.hpp"

#include <catch2/catch.hpp>

#include <atomic>
#include <future>
#include <vector>

using opal::Pose2;
using opal::ros2::PoseKeeper;

TEST_CASE("nobody waits while a pose is kept, and of those that come meanwhile the newest is kept next") {
  std::vector<double> kept;
  std::promise<void> has_begun, disk, has_kept_two;
  {
    PoseKeeper keeper([&, disk_is_free = disk.get_future().share()](const Pose2& pose) {
      if (kept.empty()) has_begun.set_value();
      disk_is_free.wait();
      kept.push_back(pose.x());
      if (kept.size() == 2) has_kept_two.set_value();
    });
    keeper.give(Pose2(1, 0, 0));
    has_begun.get_future().wait();
    for (int x = 2; x < 50; ++x) keeper.give(Pose2(x, 0, 0));  // would never return
    disk.set_value();
    has_kept_two.get_future().wait();
  }
  CHECK(kept == std::vector<double>{1, 49});
}
