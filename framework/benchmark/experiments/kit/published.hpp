#pragma once

#include "benchmark/experiments/kit/thesis_table.hpp"

namespace opal::experiments {

/// Table 3.3 of Hendrikx (2023): one robot, 14 challenges; its own method once, AMCL five times each. Columns
/// A1, A3, B1 to B10, C11, C12.
const std::vector<std::string>& table_3_3_columns();
std::vector<ThesisTable::Block> table_3_3();

/// Table 4.1 of Hendrikx (2023), columns A1 to A6 (binary patterns), B1 to B6 (triples).
const std::vector<std::string>& table_4_1_columns();
ThesisTable::Block table_4_1();
/// Its total time by column [s]; kNever: the robot did not arrive.
const std::vector<double>& table_4_1_total_s();

/// A block without the columns that are not among those wanted; one that has none of the wanted gets "".
ThesisTable::Block with_columns(const ThesisTable::Block& block, const std::vector<std::string>& has,
                                const std::vector<std::string>& wanted);

/// "1:22"
std::string minutes(double time_s);

}  // namespace opal::experiments
