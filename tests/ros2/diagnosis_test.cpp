#include "ros2/messages/diagnosis.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace opal;
using namespace opal::ros2;

LiveAnswer answer_at(double stamp_s, Status status) {
  LiveAnswer answer;
  answer.number = 3;
  answer.stamp_s = stamp_s;
  answer.estimate.status = status;
  answer.why = "the reason";
  return answer;
}

}  // namespace

TEST_CASE("before the first scan it is said what is missing") {
  NodeState state;
  state.waits_for = "scans on /scan";
  const std::vector<Diagnosis> told = diagnoses_of({}, state, 5);
  REQUIRE(told.size() == 2);
  CHECK(told[0].level == DiagnosisLevel::warn);
  CHECK(told[0].message == "waits for scans on /scan");
  CHECK(told[1].level == DiagnosisLevel::error);
}

TEST_CASE("each status has its level and its reason") {
  CHECK(diagnoses_of(answer_at(1, Status::localized), {}, 1)[0].level == DiagnosisLevel::ok);
  CHECK(diagnoses_of(answer_at(1, Status::ambiguous), {}, 1)[0].level == DiagnosisLevel::warn);
  CHECK(diagnoses_of(answer_at(1, Status::searching), {}, 1)[0].level == DiagnosisLevel::warn);
  const Diagnosis lost = diagnoses_of(answer_at(1, Status::lost), {}, 1)[0];
  CHECK(lost.level == DiagnosisLevel::error);
  CHECK(lost.message == "lost: the reason");
}

TEST_CASE("a change of the status is a line with the pose, or with the reason") {
  LiveAnswer answer = answer_at(1, Status::localized);
  answer.estimate.T_map_base = Pose2(1.234, -2, 1.5707963);
  CHECK(status_words(answer) == "localized at x 1.23 m, y -2.00 m, heading 90.0 deg");
  CHECK(status_words(answer_at(1, Status::lost)) == "lost: the reason");
}

TEST_CASE("what keeps a node from its first answer is a complaint, and later what clocks say") {
  LiveAnswer answer;
  answer.health = {{HealthFinding::Level::doubtful, "scans", "scan without odometry: 3 times of late"},
                   {HealthFinding::Level::bad, "clock", "scans are stamped 2.0 s later"}};
  CHECK(health_complaints(answer).size() == 2);
  answer.number = 1;
  CHECK(health_complaints(answer) == std::vector<std::string>{"scans are stamped 2.0 s later"});
}

TEST_CASE("another clock is a complaint for stderr, too") {
  CHECK(clock_complaint({}, 5).empty());
  CHECK(clock_complaint(answer_at(10, Status::localized), 10.5).empty());
  CHECK(clock_complaint(answer_at(10, Status::localized), std::nan("")).empty());
  CHECK_THAT(clock_complaint(answer_at(10, Status::localized), 5.3),
             Catch::StartsWith("the newest scan is stamped 4.7 s in the future"));
}

TEST_CASE("clocks that are apart are told by how much") {
  const Diagnosis future = diagnoses_of(answer_at(107.5, Status::localized), {}, 100)[2];
  CHECK(future.level == DiagnosisLevel::error);
  CHECK_THAT(future.message, Catch::Contains("7.5 s in the future"));
  const Diagnosis old = diagnoses_of(answer_at(100, Status::localized), {}, 104)[2];
  CHECK(old.level == DiagnosisLevel::warn);
  CHECK_THAT(old.message, Catch::Contains("4.0 s old"));
  CHECK(diagnoses_of(answer_at(100, Status::localized), {}, 100.2)[2].level == DiagnosisLevel::ok);
}

TEST_CASE("complaints, what was odd and findings about sensors are all told") {
  LiveAnswer answer = answer_at(1, Status::localized);
  answer.health = {{HealthFinding::Level::bad, "laser front", "no scan for 3 s"}};
  NodeState state;
  state.complaints = {"/scan: nobody publishes it"};
  state.odd_counts = {{"clock reset", 2}};
  state.rates_hz = {{"/tf", 50}};
  const std::vector<Diagnosis> told = diagnoses_of(answer, state, 1);
  REQUIRE(told.size() == 4);
  CHECK(told[1].level == DiagnosisLevel::error);
  CHECK(told[1].message == "/scan: nobody publishes it");
  CHECK(told[1].values == std::vector<std::pair<std::string, std::string>>{{"/tf", "50.0 Hz"}, {"clock reset", "2"}});
  CHECK(told[3].name == "opal: laser front");
  CHECK(told[3].level == DiagnosisLevel::error);
}

TEST_CASE("on a map of several storeys, building and storey are told, and the place there") {
  LiveAnswer answer = answer_at(1, Status::localized);
  answer.estimate.has_pose = true;
  answer.estimate.T_map_base = Pose2(204, 51, 0);
  const auto named = [&](const std::string& key) {
    const auto told = diagnoses_of(answer, {}, 1);
    for (const auto& [name, value] : told[0].values)
      if (name == key) return value;
    return std::string();
  };
  CHECK(named("storey").empty());
  answer.estimate.place = {"house", "b", Pose2(4, 1, 0)};
  CHECK(named("building") == "house");
  CHECK(named("storey") == "b");
  CHECK(named("storey_x_m") == "4.000");
}
