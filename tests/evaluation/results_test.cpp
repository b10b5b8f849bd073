#include "tests/kit/temporary_folder.hpp"

#include <opal/common/error.hpp>
#include "evaluation/results.hpp"

#include <catch2/catch.hpp>

#include <limits>
#include <sstream>

using namespace opal;

namespace {

struct TextFile : TemporaryFile {
  explicit TextFile(const std::string& text) : TemporaryFile("results.csv", text) {}
};

}  // namespace

TEST_CASE("result rows are what the benchmark reads, and read back as they were") {
  const std::vector<ResultRow> rows{{"hall-q01", 12.5, Pose2(1, 2, -0.5), Status::localized, 0.995, 0.004},
                                    {"a \"b\", c", 13, Pose2(), Status::lost, 0.25, 0.5}};
  std::ostringstream out;
  write_results(out, rows);
  CHECK(out.str() ==
        "query_id,timestamp,x,y,theta,localized_flag,probability,none,status\n"
        "hall-q01,12.500000000,1.000000000,2.000000000,-0.500000000,1,0.995000000,0.004000000,localized\n"
        "\"a \"\"b\"\", c\",13.000000000,0.000000000,0.000000000,0.000000000,0,0.250000000,0.500000000,lost\n");
  const TextFile file(out.str());
  const auto read = read_results(file.path());
  REQUIRE(read.size() == 2);
  CHECK(read[1].query == rows[1].query);
  CHECK(read[0].probability == 0.995);
  CHECK(read[0].localized());
  CHECK(read[1].status == Status::lost);
  CHECK(distance_m(read[0].T_map_laser, rows[0].T_map_laser) < 1e-9);
}

TEST_CASE("alternatives read back as they were; what is not finite is not written") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::ostringstream out;
  write_alternatives(out,
                     std::vector<AlternativeRow>{{"q", 1, Pose2(3, 4, 1), 0.125}, {"q", 2, Pose2(nan, 0, 0), 0.5}});
  const TextFile file(out.str());
  const auto read = read_alternatives(file.path());
  REQUIRE(read.size() == 1);
  CHECK(read[0].probability == 0.125);
}

TEST_CASE("a result without probabilities, or with nonsense, is an error that says where") {
  const TextFile old("query_id,timestamp,x,y,theta,localized_flag\nq,1,2,3,0,1\n");
  CHECK_THROWS_WITH(read_results(old.path()), Catch::Contains(old.path()) && Catch::Contains("'probability'"));
  const std::string header = "query_id,timestamp,x,y,theta,localized_flag,probability,none,status\n";
  const TextFile high(header + "q,1,2,3,0,1,1.5,0,lost\n");
  CHECK_THROWS_WITH(read_results(high.path()), Catch::Contains("line 2") && Catch::Contains("1.5"));
  const TextFile word(header + "q,1,2,3,0,1,0.5,0,sure\n");
  CHECK_THROWS_WITH(read_results(word.path()), Catch::Contains("sure"));
  const TextFile cut(header + "q,1,2\n");
  CHECK_THROWS_WITH(read_results(cut.path()), Catch::Contains("3 fields"));
  CHECK_THROWS_WITH(read_results("/nowhere.csv"), Catch::Contains("/nowhere.csv"));
  const TextFile empty("");
  CHECK_THROWS_AS(read_results(empty.path()), LogError);
}
