#include "benchmark/experiments/kit/thesis_table.hpp"

#include "report/html_elements.hpp"

#include <fmt/format.h>

namespace opal::experiments {
namespace {

std::vector<std::string> sentences_of(const ThesisTable& table) {
  std::vector<std::string> sentences;
  for (const ThesisTable::Block& block : table.blocks)
    if (!block.all.empty()) sentences.push_back(fmt::format("{}, all: {}", block.name, block.all));
  return sentences;
}

}  // namespace

Table rows_of(const ThesisTable& table) {
  Table flat{{{"", "", false}, {"", "", false}}, {}, true};
  for (const std::string& column : table.columns) flat.columns.push_back({column});
  for (const ThesisTable::Block& block : table.blocks)
    for (const ThesisTable::Row& row : block.rows) {
      flat.rows.push_back({block.name, row.name});
      flat.rows.back().insert(flat.rows.back().end(), row.cells.begin(), row.cells.end());
    }
  return flat;
}

std::string text_of(const ThesisTable& table) {
  return fmt::format("{}\n- {}\n", markdown_of(rows_of(table)), fmt::join(sentences_of(table), "\n- "));
}

std::string html_of(const ThesisTable& table) {
  const Table rows = rows_of(table);
  std::string sentences;
  for (const std::string& sentence : sentences_of(table)) sentences += text_element("li", sentence);
  return element("section",
                 html_of(rows) + element("ul", "\n" + sentences, "notes") + download("table.csv", csv_of(rows))) +
         "\n";
}

}  // namespace opal::experiments
