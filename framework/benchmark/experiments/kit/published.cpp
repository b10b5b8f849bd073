#include "benchmark/experiments/kit/published.hpp"

#include "benchmark/experiments/kit/order_statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace opal::experiments {

const std::vector<std::string>& table_3_3_columns() {
  static const std::vector<std::string> columns{"A1", "A3", "B1", "B2", "B3",  "B4",  "B5",
                                                "B6", "B7", "B8", "B9", "B10", "C11", "C12"};
  return columns;
}

std::vector<ThesisTable::Block> table_3_3() {
  return {
      {"thesis' method, as published",
       {{"successful",
         {"yes", "yes", "yes", "yes", "yes", "yes", "yes", "yes", "no", "yes", "yes", "yes", "yes", "no"}},
        {"distance ML m",
         {"1.7", "4.9", "1.7", "8.3", "4.9", "5.3", "1.1", "7.2", "-", "5.5", "7.1", "10.3", "16.4", "-"}},
        {"self-rep. distance m",
         {"13.2", "4.9", "16.3", "22.0", "8.4", "24.1", "15.7", "20.9", "16.9", "5.5", "4.0", "6.0", "2.9", "9.1"}},
        {"ML error after m",
         {"0.05", "0.33", "0.07", "0.23", "0.28", "0.36", "0.13", "0.25", "-", "0.24", "0.51", "0.16", "0.08", "-"}},
        {"max hyp. before",
         {"200", "200", "200", "200", "200", "200", "200", "200", "200", "200", "200", "200", "200", "200"}},
        {"max hyp. after", {"7", "9", "7", "10", "7", "5", "33", "11", "-", "8", "7", "5", "6", "-"}}},
       "12 of 14"},
      {"AMCL, as published",
       {{"successful",
         {"5/5", "5/5", "2/5", "0/5", "5/5", "0/5", "0/5", "0/5", "3/5", "4/5", "4/5", "3/5", "2/5", "5/5"}},
        {"distance ML m", {"5.2", "6.2", "3.9", "-", "9.3", "-", "-", "-", "6.5", "10.3", "1.2", "6.3", "13.1", "8.0"}},
        {"self-rep. distance m",
         {"5", "6.9", "6.4", "-", "13.3", "-", "-", "-", "8", "12.2", "2.9", "7.4", "12.9", "8.7"}},
        {"ML error after m",
         {"0.19", "0.32", "0.18", "-", "0.29", "-", "-", "-", "0.2", "0.17", "0.25", "0.36", "0.42", "0.22"}},
        {"max hyp. before",
         {"50000", "50000", "50000", "-", "50000", "-", "-", "-", "50000", "50000", "50000", "50000", "50000",
          "50000"}},
        {"max hyp. after",
         {"50000", "44217", "50000", "-", "50000", "-", "-", "-", "17378", "28235", "13527", "50000", "50000",
          "50000"}}},
       "38 of 70"}};
}

const std::vector<std::string>& table_4_1_columns() {
  static const std::vector<std::string> columns{"A1", "A2", "A3", "A4", "A5", "A6", "B1", "B2", "B3", "B4", "B5", "B6"};
  return columns;
}

const std::vector<double>& table_4_1_total_s() {
  static const std::vector<double> total_s{37, 41, 56, 82, 72, 139, kNever, 39, 82, 150, 319, 329};
  return total_s;
}

ThesisTable::Block table_4_1() {
  std::vector<std::string> total;
  for (const double time_s : table_4_1_total_s()) total.push_back(minutes(time_s));
  return {"thesis, as published",
          {{"success", {"yes", "yes", "yes", "yes", "yes", "yes", "no", "yes", "yes", "yes", "yes", "yes"}},
           {"pattern type", {"B", "B", "B", "B", "B", "B", "L", "L", "L", "L", "C/L", "L"}},
           {"total time", total},
           {"wrong pattern starts", {"0", "0", "0", "0", "0", "0", "0", "0", "0", "0", "1", "1*"}},
           {"first correct pattern",
            {"0:02", "0:05", "0:02", "0:25", "0:08", "0:20", "0:40", "0:06", "0:41", "0:44", "0:26", "1:31*"}},
           {"circles in local map",
            {"2", "3(5)", "2(4)", "3(8)", "2(3)", "4(9)", "6(17)", "3(4)", "4(13)", "3(14)", "3(6)", "4(12)"}},
           {"places after inspection", {"7", "4", "4", "3", "4", "1", "0", "1", "5", "4", "3", "1"}},
           {"places after arrival", {"4", "4", "2", "1", "1", "1", "3", "1", "1", "1", "1", "1"}},
           {"recoveries", {"0", "0", "0", "0", "0", "0", "1", "0", "0", "0", "2", "2"}}},
          "11 of 12"};
}

ThesisTable::Block with_columns(const ThesisTable::Block& block, const std::vector<std::string>& has,
                                const std::vector<std::string>& wanted) {
  ThesisTable::Block chosen = block;
  for (ThesisTable::Row& row : chosen.rows) {
    std::vector<std::string> cells;
    for (const std::string& column : wanted) {
      const auto at = std::find(has.begin(), has.end(), column);
      cells.push_back(at == has.end() ? "" : row.cells[static_cast<std::size_t>(at - has.begin())]);
    }
    row.cells = std::move(cells);
  }
  return chosen;
}

std::string minutes(double time_s) {
  if (!std::isfinite(time_s)) return "na";
  const int whole_s = static_cast<int>(std::lround(time_s));
  return fmt::format("{}:{:02}", whole_s / 60, whole_s % 60);
}

}  // namespace opal::experiments
