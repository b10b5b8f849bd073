#include "benchmark/experiments/integrity/integrity_page.hpp"
#include "benchmark/statistics/share_bound.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::experiments;
using Catch::Contains;

namespace {

/// @param wrong_s  for how long a wrong pose is called localized.
JudgedDrive drive_of(std::size_t number, const std::string& building, double wrong_s) {
  JudgedDrive drive;
  drive.drive.number = number;
  drive.drive.building_id = building;
  drive.drive.building.kind = "hall";
  drive.run.localized.longest_wrong_s = drive.run.localized.wrong_s = wrong_s;
  drive.run.localized_after_m = static_cast<double>(number);
  return drive;
}

}  // namespace

TEST_CASE("a share's interval is the exact one of Clopper and Pearson where there are no clusters") {
  // Clopper and Pearson 1934; numbers as scipy.stats.binomtest(k, n).proportion_ci() gives them.
  const auto interval = [](double part, double whole) {
    return statistics::share_interval(std::vector<statistics::ClusterCount>{{part, whole}}, 0.05);
  };
  CHECK(interval(0, 10).low == 0);
  CHECK(interval(0, 10).high == Approx(0.3084971));
  CHECK(interval(3, 10).low == Approx(0.0667395).epsilon(1e-4));
  CHECK(interval(3, 10).high == Approx(0.6524529).epsilon(1e-4));
  CHECK(interval(10, 10).high == 1);
  CHECK(interval(0, 0).high == 1);
}

TEST_CASE("what always fails together tells less than what fails apart") {
  std::vector<statistics::ClusterCount> together(20, {0, 10}), apart(20, {1, 10});
  together[0] = together[1] = {10, 10};
  CHECK(statistics::design_effect(apart) == 1);
  CHECK(statistics::design_effect(together) > 5);
  CHECK(statistics::share_interval(together, 0.05).high > statistics::share_interval(apart, 0.05).high + 0.05);
}

TEST_CASE("the spread that few clusters tell is not well known") {
  // Korn and Graubard 1998: 500 trials in 5 clusters without a design effect tell as much as 500 (1.965 / 2.776)^2.
  const std::vector<statistics::ClusterCount> few(5, {1, 100}), many(500, {0.01, 1}), fewer{{2.504, 250.4}};
  CHECK(statistics::share_interval(few, 0.05).high ==
        Approx(statistics::share_interval(fewer, 0.05).high).epsilon(1e-3));
  CHECK(statistics::share_interval(few, 0.05).high > 1.2 * statistics::share_interval(many, 0.05).high);
}

TEST_CASE("a drive is false if it calls a wrong pose localized for longer than a second, or fails") {
  std::vector<JudgedDrive> drives{drive_of(1, "a", 0), drive_of(2, "a", 1.0), drive_of(3, "b", 1.1),
                                  drive_of(4, "b", 0)};
  drives[3].failure = "crashed: signal 11 (SIGSEGV)";
  const std::vector<Stratum> strata = strata_of(drives);
  CHECK(strata.front().drives.size() == 4);
  CHECK(strata.front().false_drives() == 2);
  CHECK_THAT(bound_sentence(strata.front()), Contains("2 of 4 drives did"));
  const std::vector<JudgedDrive> worst = worst_drives(drives, 10);
  REQUIRE(worst.size() == 3);
  CHECK(worst[0].drive.number == 4);
  CHECK(worst[1].drive.number == 3);
  CHECK(worst_drives(drives, 1).size() == 1);
}

TEST_CASE("every drive is in one stratum of each aspect") {
  std::vector<JudgedDrive> drives;
  for (std::size_t k = 0; k < 50; ++k) {
    drives.push_back(drive_of(k, "a", 0));
    drives.back().drive.is_kidnapped = k % 3 == 0;
    drives.back().drive.storeys = k % 5 == 0 ? 3 : 1;
  }
  std::map<std::string, std::size_t> count;
  for (const Stratum& stratum : strata_of(drives)) count[stratum.aspect] += stratum.drives.size();
  CHECK(count.size() == 8);
  for (const auto& [aspect, drives_in] : count) CHECK(drives_in == 50);
}

TEST_CASE("a campaign without a drive, and one with names from elsewhere, have a report") {
  const std::vector<Stratum> nothing = strata_of({});
  CHECK(bound_sentence(nothing.front()) == "No drive has ended yet.");
  std::vector<JudgedDrive> drives{drive_of(1, "<script>alert(1)</script>", 5)};
  const std::string page = integrity_page("opal", strata_of(drives), {{drives[0], "", "worst/00001/page.html"}});
  CHECK_THAT(page, !Contains("<script>alert(1)"));
  CHECK_THAT(page, Contains("worst/00001/page.html") && Contains("for 5.0 s at a time"));
}
