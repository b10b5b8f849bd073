#include "common/pose_tolerance.hpp"

#include <catch2/catch.hpp>

#include <numbers>

namespace opal {
namespace {

constexpr PoseTolerance kTolerance{0.3, 0.1};

}  // namespace

TEST_CASE("two poses are one place if they are near and turned alike") {
  const Pose2 pose(5, -2, 1);
  CHECK(kTolerance.holds(pose, pose));
  CHECK(kTolerance.holds(pose, Pose2(5.2, -2.2, 1.05)));
  CHECK_FALSE(kTolerance.holds(pose, Pose2(5.31, -2, 1)));
  CHECK_FALSE(kTolerance.holds(pose, Pose2(5, -2, 1.11)));
}

TEST_CASE("headings on both sides of half a turn are alike") {
  CHECK(kTolerance.holds(Pose2(0, 0, std::numbers::pi - 0.04), Pose2(0, 0, -std::numbers::pi + 0.04)));
}

}  // namespace opal
