#include "localization/observation/settling.hpp"

#include <catch2/catch.hpp>

#include <vector>

using namespace opal;

namespace {

/// @return at which of the stamps a scan is looked at.
std::vector<double> looks(Settling& settling, double from_s, double to_s, double every_s, const Pose2& at) {
  std::vector<double> all;
  for (double stamp_s = from_s; stamp_s < to_s; stamp_s += every_s)
    if (settling.add(stamp_s, at)) all.push_back(stamp_s);
  return all;
}

}  // namespace

TEST_CASE("a robot at rest looks a few times, the later the rarer, and then no more") {
  Settling settling;
  const std::vector<double> all = looks(settling, 100, 200, 0.05, Pose2(3, 1, 0.4));
  REQUIRE(all.size() == 4);
  CHECK(all.front() == Approx(100.2).margin(0.051));
  for (std::size_t k = 1; k < all.size(); ++k) CHECK(all[k] - 100 == Approx(2 * (all[k - 1] - 100)).margin(0.11));
}

TEST_CASE("a robot that moves never looks for that reason, and looks anew after each stop") {
  Settling settling;
  for (int k = 0; k < 100; ++k) CHECK_FALSE(settling.add(0.1 * k, Pose2(0.02 * k, 0, 0)));
  CHECK(looks(settling, 10, 20, 0.05, Pose2(2, 0, 0)).size() == 4);
  CHECK_FALSE(settling.add(20, Pose2(2.5, 0, 0)));
  CHECK(looks(settling, 20.05, 30, 0.05, Pose2(2.5, 0, 0)).size() == 4);
}

TEST_CASE("however fast scans come, and however rarely, no more are looked at") {
  for (const double every_s : {0.001, 0.025, 0.3, 5.0}) {
    CAPTURE(every_s);
    Settling settling;
    CHECK(looks(settling, 0, 100, every_s, Pose2()).size() == 4);
  }
}

TEST_CASE("a clock that is set back begins a new rest") {
  Settling settling;
  CHECK(looks(settling, 100, 110, 0.1, Pose2()).size() == 4);
  CHECK(looks(settling, 50, 60, 0.1, Pose2()).size() == 4);
}
