#include "benchmark/experiments/integrity/localized_time.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using opal::experiments::LocalizedTime;

TEST_CASE("the longest time is one without a break: a right answer or an honest one ends it") {
  LocalizedTime time;
  time.add(0.5, false, false);
  time.add(1.0, true, false);  // 0.5 s wrong
  time.add(1.6, true, false);  // 1.1 s
  time.add(1.8, true, true);
  time.add(2.4, true, false);  // 0.6 s
  time.add(2.5, false, false);
  time.add(3.0, true, false);  // 0.5 s
  CHECK(time.longest_wrong_s == Approx(1.1));
  CHECK(time.wrong_s == Approx(2.2));
  CHECK(time.right_s == Approx(0.2));
  CHECK(time.wrong_from_s == 1.0);
}

TEST_CASE("silence is not localized, and a clock that goes back counts nothing twice") {
  LocalizedTime time;
  time.add(0.1, true, false);
  time.add(60, true, false);  // a second of it
  CHECK(time.wrong_s == Approx(1.1));
  time.add(50, true, false);
  time.add(60, true, false);
  CHECK(time.wrong_s == Approx(1.1));
}
