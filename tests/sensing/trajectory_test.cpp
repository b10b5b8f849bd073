#include "sensing/trajectory.hpp"

#include <catch2/catch.hpp>

#include <limits>
#include <sstream>
#include <vector>

using namespace opal;

TEST_CASE("a TUM line carries the heading as a quaternion") {
  std::ostringstream out;
  write_tum(out, std::vector<StampedPose>{{1663967375.5484114, Pose2(1.5, -2.25, std::numbers::pi / 2)}});
  std::istringstream line(out.str());
  double stamp_s, x, y, z, qx, qy, qz, qw;
  line >> stamp_s >> x >> y >> z >> qx >> qy >> qz >> qw;
  REQUIRE(line);
  CHECK(std::abs(stamp_s - 1663967375.5484114) < 1e-6);
  CHECK(x == 1.5);
  CHECK(y == -2.25);
  CHECK((z == 0 && qx == 0 && qy == 0));
  CHECK(qz == Approx(std::sqrt(0.5)));
  CHECK(qw == Approx(std::sqrt(0.5)));
}

TEST_CASE("what is not finite is not written, what is huge is") {
  constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
  std::ostringstream out;
  write_tum(out,
            std::vector<StampedPose>{{kNoNumber, Pose2()}, {1, Pose2(kNoNumber, 0, 0)}, {1, Pose2(0, 0, kNoNumber)}});
  CHECK(out.str().empty());
  write_tum(out, std::vector<StampedPose>{{1, Pose2(std::numeric_limits<double>::max(), 0, 0)}});
  CHECK(out.str().size() > 300);
}

TEST_CASE("between two poses a robot moves evenly, and turns the short way; before and after nothing is known") {
  const std::vector<StampedPose> poses{{10, Pose2(1, 0, 3)}, {14, Pose2(3, 4, -3)}};
  const auto at = pose_at(poses, 11);
  REQUIRE(at);
  CHECK(at->x() == Approx(1.5));
  CHECK(at->y() == Approx(1));
  CHECK(at->heading_rad() == Approx(3 + 0.25 * (2 * std::numbers::pi - 6)));
  CHECK(pose_at(poses, 14)->x() == 3);
  CHECK(pose_at(poses, 10)->x() == 1);
  CHECK_FALSE(pose_at(poses, 9.9));
  CHECK_FALSE(pose_at(poses, 14.1));
}
