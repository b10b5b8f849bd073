#include "tests/report/page_parts.hpp"

#include "benchmark/experiments/challenges/challenge_report.hpp"
#include "benchmark/experiments/goals/goal_report.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::experiments;
using Catch::Contains;

namespace {

std::vector<JudgedMoment> some_moments() {
  std::vector<JudgedMoment> moments;
  for (int k = 0; k < 20; ++k) {
    JudgedMoment moment;
    moment.time_s = moment.driven_m = k;
    moment.truth = Pose2(2 + 0.1 * k, 2, 0);
    moment.estimate = Pose2(2 + 0.1 * k, 2.1, 0);
    moment.has_pose = k > 3;
    moment.status = k > 8 ? Status::localized : Status::searching;
    moment.hypotheses = k > 3 ? 100 / k : 0;
    moment.under_way = k > 8;
    moments.push_back(moment);
  }
  return moments;
}

/// Every tag that is opened is closed, or closes itself: nothing of a picture swallows what comes after.
void check_nesting(const std::string& page) {
  std::vector<std::string> open;
  for (std::size_t at = page.find("<svg"); at != std::string::npos; at = page.find('<', at + 1)) {
    const std::size_t end = page.find('>', at);
    REQUIRE(end != std::string::npos);
    std::string name = page.substr(at + 1, page.find_first_of(" >/", at + 2) - at - 1);
    if (page[end - 1] == '/') {
      CHECK((page[end - 2] == '\'' || page[end - 2] == '"'));  // a value without quotes would take the slash
      continue;
    }
    if (name.starts_with("/")) {
      if (open.empty()) continue;  // of the page around
      CHECK(open.back() == name.substr(1));
      open.pop_back();
    } else if (name == "svg" || !open.empty()) {
      open.push_back(name);
    }
  }
  CHECK(open.empty());
}

}  // namespace

TEST_CASE("the pages hold the table, a picture per run and a plot per run, and stand alone") {
  const auto map = SemanticMap::read(OPAL_SOURCE_DIR "/maps/example_room.jsonld");
  ChallengeRun challenge;
  challenge.contender = "a<b";
  challenge.challenge = "B1";
  challenge.moments = some_moments();
  judge(challenge);
  GoalRun goal;
  goal.contender = "a<b";
  goal.task = "A1";
  goal.moments = some_moments();
  goal.starts.push_back({{2, 2}, {{3, 3}, {4, 2}}, true});
  const std::vector<ChallengeRun> challenges{challenge};
  const std::vector<GoalRun> goals{goal};
  for (const std::string& page : {challenge_page(*map, challenges), goal_page(*map, goals)}) {
    check_nesting(page);
    CHECK_THAT(page, Contains("a&lt;b") && !Contains("a<b"));
    CHECK_THAT(page, Contains("as published") && Contains("hypotheses") && Contains("</html>"));
    CHECK_THAT(without_drawing(page), Contains("<div class=\"plot\"") && !Contains("<script>") && !Contains("nan") &&
                                          !Contains("href=\"http"));
    CHECK_THAT(page, !Contains(" src="));
  }
}
