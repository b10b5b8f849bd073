#include "learning/gap_leg.hpp"

#include "made_samples.hpp"

#include <catch2/catch.hpp>

using namespace opal;

TEST_CASE("a gap leads from where one leg ends to where the next one begins, along the way that was driven") {
  const std::vector<Sample> samples = made::samples_between(10, 25);
  const Pose2 start = made::truth_at(samples.front()), end = made::truth_at(samples.back());
  const auto gap = gap_leg(robot().parts(), samples, start, end);
  REQUIRE(gap);
  CHECK(gap->is_gap);
  CHECK(gap->visits == std::vector{samples.size()});
  CHECK(gap->views.size() == samples.size());
  REQUIRE(gap->track.size() == samples.size());
  CHECK(distance_m(gap->track.back().T_map_base, end) < 1e-6);
  for (std::size_t k = 0; k < samples.size(); ++k)
    CHECK(distance_m(gap->track[k].T_map_base, made::truth_at(samples[k])) < 0.2);
}

TEST_CASE("a gap that does not lead to where the next leg begins is none") {
  const std::vector<Sample> samples = made::samples_between(10, 25);
  const Pose2 start = made::truth_at(samples.front()), end = made::truth_at(samples.back());
  CHECK_FALSE(gap_leg(robot().parts(), samples, start, Pose2(4, 0, 0) * end));
  CHECK_FALSE(gap_leg(robot().parts(), samples, start, end * Pose2(0, 0, 0.6)));
}

TEST_CASE("what a gap is off at its end is shared out along it") {
  const std::vector<Sample> samples = made::samples_between(10, 25);
  const Pose2 start = made::truth_at(samples.front()), end = made::truth_at(samples.back());
  const Pose2 beside(Point(end.position() + Point(0.3, 0)), end.heading_rad());
  const auto as_driven = gap_leg(robot().parts(), samples, start, end);
  const auto shifted = gap_leg(robot().parts(), samples, start, beside);
  REQUIRE(as_driven);
  REQUIRE(shifted);
  const auto apart_m = [&](std::size_t k) {
    return distance_m(as_driven->track[k].T_map_base, shifted->track[k].T_map_base);
  };
  CHECK(apart_m(0) < 1e-6);
  CHECK(apart_m(samples.size() / 2) == Approx(0.15).margin(0.02));
  CHECK(apart_m(samples.size() - 1) == Approx(0.3).margin(1e-6));
}
