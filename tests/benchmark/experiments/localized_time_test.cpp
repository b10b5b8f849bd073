#include "benchmark/experiments/kit/localized_time.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using opal::experiments::LocalizedTime;

TEST_CASE("the longest time is one without a break: a right answer or an honest one ends it") {
  LocalizedTime time;
  time.add(0.5, false, false);
  time.add(1.0, true, false);  // 0.8 s wrong
  time.add(1.6, true, false);
  time.add(1.8, true, true);   // 0.6 s right
  time.add(2.4, true, false);  // 0.1 s wrong
  time.add(2.5, false, false);
  time.add(3.0, true, false);
  CHECK(time.longest_wrong_s == Approx(0.8));
  CHECK(time.wrong_s == Approx(0.9));
  CHECK(time.right_s == Approx(0.6));
  CHECK(time.wrong_from_s == 1.0);
}

TEST_CASE("silence is not localized, and a clock that goes back counts nothing twice") {
  LocalizedTime time;
  time.add(0.1, true, false);  // a second of it
  time.add(60, true, false);
  CHECK(time.wrong_s == Approx(1));
  time.add(50, true, false);
  time.add(60, true, false);
  CHECK(time.wrong_s == Approx(1));
}

TEST_CASE("a wrong answer before silence holds for a second, and one after it begins anew") {
  LocalizedTime time;
  time.add(0.5, false, false);
  time.add(1.0, true, false);
  time.add(1.5, true, false);
  time.add(9.0, true, false);
  time.add(9.5, true, true);
  CHECK(time.longest_wrong_s == Approx(1.5));
  CHECK(time.wrong_s == Approx(2.0));
}
