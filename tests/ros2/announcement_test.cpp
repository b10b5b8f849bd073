#include "ros2/messages/announcement.hpp"

#include <catch2/catch.hpp>

#include <limits>

namespace {

using namespace opal;
using namespace opal::ros2;

LiveAnswer answer_that_is(Status status) {
  LiveAnswer answer;
  answer.number = 1;
  answer.stamp_s = 100;
  answer.estimate.status = status;
  answer.estimate.has_pose = true;
  answer.estimate.T_map_base = Pose2(1, 2, 0.5);
  answer.estimate.covariance = Eigen::Vector3d(0.01, 0.04, 0.001).asDiagonal();
  answer.estimate.probability = 0.6;
  answer.estimate.alternatives = {{HypothesisId(7), Pose2(3, 4, 0), 0.3}};
  answer.T_map_odom = Pose2(5, 6, 1);
  return answer;
}

}  // namespace

TEST_CASE("a localized robot gets a transform that is valid for a while, and a pose at the scan's stamp") {
  const Announcement told = announcement_of(answer_that_is(Status::localized), {"map", "odom", 0.5});
  REQUIRE(told.map_to_odom);
  CHECK(told.map_to_odom->stamp_s == Approx(100.5));
  CHECK(told.map_to_odom->parent == "map");
  CHECK(told.map_to_odom->child == "odom");
  CHECK(told.map_to_odom->T_parent_child.x() == 5);
  REQUIRE(told.pose);
  CHECK(told.pose->stamp_s == 100);
  CHECK(told.pose->covariance(1, 1) == 0.04);
  CHECK(told.places.empty());
}

TEST_CASE("while nothing is decided possible places are told, and neither transform nor pose") {
  for (const Status status : {Status::searching, Status::ambiguous}) {
    const Announcement told = announcement_of(answer_that_is(status), {});
    CHECK_FALSE(told.map_to_odom);
    CHECK_FALSE(told.pose);
    REQUIRE(told.places.size() == 2);
    CHECK(told.places[0].probability == Approx(0.6));
    CHECK(told.places[1].T_map_base.x() == 3);
  }
}

TEST_CASE("a lost robot is told nothing, so that its transform runs out") {
  const Announcement told = announcement_of(answer_that_is(Status::lost), {});
  CHECK_FALSE(told.map_to_odom);
  CHECK_FALSE(told.pose);
  CHECK(told.places.empty());
}

TEST_CASE("what is no number is never told") {
  LiveAnswer answer = answer_that_is(Status::localized);
  answer.T_map_odom = Pose2(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  CHECK_FALSE(announcement_of(answer, {}).map_to_odom);
  CHECK_FALSE(announcement_of(answer, {}).pose);
  answer = answer_that_is(Status::ambiguous);
  answer.estimate.alternatives[0].probability = std::numeric_limits<double>::quiet_NaN();
  CHECK(announcement_of(answer, {}).places.size() == 1);
  answer = answer_that_is(Status::localized);
  answer.estimate.has_pose = false;
  CHECK_FALSE(announcement_of(answer, {}).pose);
}
