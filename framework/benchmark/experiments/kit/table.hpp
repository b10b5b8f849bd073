#pragma once

#include <string>
#include <vector>

namespace opal::experiments {

/// A table in the layout of the thesis: a column per run, a block of rows per contender.
struct Table {
  struct Row {
    std::string name;
    std::vector<std::string> cells;  ///< by column
  };
  struct Block {
    std::string name;
    std::vector<Row> rows;
    std::string all;  ///< a sentence about all columns
  };
  std::vector<std::string> columns;
  std::vector<Block> blocks;
};

std::string text_of(const Table& table);
std::string html_of(const Table& table);

/// "2.50"; "-" for what is not finite.
std::string number(double value, int decimals);

}  // namespace opal::experiments
