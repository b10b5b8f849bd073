#include "report/quantity_text.hpp"

#include <catch2/catch.hpp>

#include <limits>

using namespace opal;

TEST_CASE("what is no number is a dash, and what is infinite says so") {
  constexpr double kBoundless = std::numeric_limits<double>::infinity();
  CHECK(fixed_text(std::nan(""), 2) == "-");
  CHECK(fixed_text(-std::nan(""), 2) == "-");
  CHECK(fixed_text(kBoundless, 2) == "∞");
  CHECK(fixed_text(-kBoundless, 0) == "-∞");
  CHECK(within_text(1, -kBoundless, kBoundless, 1) == "1.0 (-∞ to ∞)");
  CHECK(p_text(std::nan("")) == "-");
}

TEST_CASE("absurd values have no endless digits, and there is no minus before nothing") {
  CHECK(fixed_text(1e300, 3) == "1e+300");
  CHECK(fixed_text(-1e12, 3) == "-1e+12");
  CHECK(fixed_text(1410364800.25, 3) == "1410364800.250");
  CHECK(fixed_text(-0.001, 2) == "0.00");
  CHECK(fixed_text(999999999, 1) == "999999999.0");
}

TEST_CASE("a quantity has its unit, an interval its ends, a share its percent, and a tiny p its bound") {
  CHECK(metres_text(1.239) == "1.24 m");
  CHECK(interval_text(1.21, 3.44, 1) == "1.2 to 3.4");
  CHECK(within_text(2, 1.21, 3.44, 1) == "2.0 (1.2 to 3.4)");
  CHECK(percent_text(0.961) == "96 %");
  CHECK(percent_text(0.9612, 1) == "96.1 %");
  CHECK(p_text(0.00001) == "< 0.0001");
  CHECK(p_text(0.0042) == "0.0042");
  CHECK(p_text(0.042) == "0.042");
  CHECK(pose_text(Pose2(12.1, 3.4, 0)) == "(12.10, 3.40), heading 0.0 deg");
}
