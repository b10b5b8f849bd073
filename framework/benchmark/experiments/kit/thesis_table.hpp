#pragma once

#include "report/table.hpp"

namespace opal::experiments {

/// A table in the layout of the thesis: a column per run, a block of rows per contender.
struct ThesisTable {
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

/// Its rows, each with the name of its block.
Table rows_of(const ThesisTable& table);

/// The rows in Markdown, and what is said of all columns.
std::string text_of(const ThesisTable& table);
/// The same for a page, with the rows to be saved.
std::string html_of(const ThesisTable& table);

}  // namespace opal::experiments
