#include "benchmark/experiments/storeys/storey_report.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::experiments;

namespace {

StoreyRun run_with(double difference, bool is_right, bool is_ride = false) {
  StoreyRun run;
  run.difference = difference;
  run.is_right = is_right;
  run.is_ride = is_ride;
  if (is_right) run.localized_from_m = 4.0;
  return run;
}

std::string cell(const Table& table, std::size_t row, std::size_t column) { return table.rows.at(row).at(column).text; }

}  // namespace

TEST_CASE("drives whose storey can hardly be told stand apart from the others, and rides from drives") {
  const Table table = storey_table({run_with(0.01, false), run_with(0.2, true), run_with(0.3, true),
                                    run_with(0.4, false), run_with(0.5, true, true)});
  REQUIRE(table.rows.size() == 6);
  const std::vector<std::vector<std::string>> expected{
      {"drives", "4", "2"}, {"", "1", "0"}, {"... more tell it", "3", "2"},
      {"rides", "1", "1"},  {"", "0", "0"}, {"... more tell it", "1", "1"}};
  for (std::size_t row = 0; row < expected.size(); ++row)
    for (std::size_t column = expected[row][0].empty() ? 1 : 0; column < 3; ++column) {
      CAPTURE(row, column);
      CHECK(cell(table, row, column) == expected[row][column]);
    }
}
