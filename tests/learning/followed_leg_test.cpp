#include "learning/followed_leg.hpp"

#include "made_samples.hpp"

#include <catch2/catch.hpp>

using namespace opal;

namespace {

/// Follows the drive from its twentieth second, where the robot is localized for the first time.
/// @param before  what the localizer took for the best pose until then.
std::vector<DriveLeg> legs_after(const std::function<std::optional<PoseEstimate>(const Sample&)>& before) {
  SkippedSamples skipped;
  for (const Sample& sample : made::samples_between(0, 20)) skipped.add(sample, before(sample));
  const std::vector<Sample> samples = made::samples_between(20, 40);
  FollowedLeg leg(robot().parts(), made::estimate_of(samples.front(), Status::localized), samples.front());
  for (const Sample& sample : samples) leg.update(sample, made::estimate_of(sample, Status::localized));
  return leg.finish(skipped);
}

double farthest_off_m(const DriveLeg& leg) {
  double farthest = 0;
  for (const TrackedKeyframe& keyframe : leg.track)
    farthest = std::max(farthest, distance_m(keyframe.T_map_base, robot().truth_at(keyframe.stamp_s)));
  return farthest;
}

}  // namespace

TEST_CASE("a leg is followed back to where the localizer was right and not sure yet") {
  const auto legs = legs_after([](const Sample& sample) { return made::estimate_of(sample, Status::ambiguous); });
  REQUIRE(legs.size() == 2);
  CHECK(farthest_off_m(legs[0]) < 0.3);
  CHECK(farthest_off_m(legs[1]) < 0.3);
  CHECK(legs[1].track.front().stamp_s == Approx(legs[0].track.front().stamp_s));
  CHECK(legs[1].track.back().stamp_s < legs[0].track.front().stamp_s - 15);
  CHECK(legs[1].visits == std::vector{legs[1].track.size()});
  CHECK(legs[1].views.size() == legs[1].track.size());
}

TEST_CASE("a leg is not followed back where the localizer was elsewhere") {
  const double first_s = made::samples_between(0, 20).front().stamp_s;
  const auto legs = legs_after([&](const Sample& sample) {
    const bool is_elsewhere = sample.stamp_s < first_s + 10;
    return made::estimate_of(sample, Status::ambiguous, is_elsewhere ? Pose2(5, 0, 0) : Pose2());
  });
  REQUIRE(legs.size() == 2);
  CHECK(legs[1].track.back().stamp_s >= first_s + 10);
  CHECK(legs[1].track.back().stamp_s < first_s + 12);
}

TEST_CASE("where the localizer said nothing, no leg is followed back") {
  CHECK(legs_after([](const Sample&) { return std::nullopt; }).size() == 1);
}
