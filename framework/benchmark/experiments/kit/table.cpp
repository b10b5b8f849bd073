#include "benchmark/experiments/kit/table.hpp"

#include "report/html_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace opal::experiments {
namespace {

std::size_t widest(const Table& table, std::size_t column) {
  std::size_t width = table.columns[column].size();
  for (const Table::Block& block : table.blocks)
    for (const Table::Row& row : block.rows) width = std::max(width, row.cells[column].size());
  return width;
}

std::size_t widest_name(const Table& table) {
  std::size_t width = 0;
  for (const Table::Block& block : table.blocks) {
    width = std::max(width, block.name.size());
    for (const Table::Row& row : block.rows) width = std::max(width, row.name.size() + 2);
  }
  return width;
}

std::string padded(const std::string& text, std::size_t width) {
  return text + std::string(width - std::min(width, text.size()), ' ');
}

}  // namespace

std::string number(double value, int decimals) {
  if (!std::isfinite(value)) return "-";
  char text[48];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

std::string text_of(const Table& table) {
  std::string text;
  const std::size_t name = widest_name(table) + 2;
  const auto line = [&](const std::string& first, const std::vector<std::string>& cells) {
    text += padded(first, name);
    for (std::size_t k = 0; k < cells.size(); ++k) text += padded(cells[k], widest(table, k) + 2);
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  };
  for (const Table::Block& block : table.blocks) {
    line(block.name, table.columns);
    for (const Table::Row& row : block.rows) line("  " + row.name, row.cells);
    if (!block.all.empty()) text += "  all: " + block.all + '\n';
    text += '\n';
  }
  return text;
}

std::string html_of(const Table& table) {
  std::string html = "<table>\n";
  const auto cells = [&](const char* tag, const std::string& first, const std::vector<std::string>& all) {
    html += "<tr><th scope=row>" + html_text(first) + "</th>";
    for (const std::string& cell : all) html += std::string("<") + tag + ">" + html_text(cell) + "</" + tag + ">";
    html += "</tr>\n";
  };
  for (const Table::Block& block : table.blocks) {
    html += "<tbody>";
    cells("th", block.name, table.columns);
    for (const Table::Row& row : block.rows) cells("td", row.name, row.cells);
    if (!block.all.empty())
      html += "<tr><td colspan=" + std::to_string(table.columns.size() + 1) +
              " class=all>All: " + html_text(block.all) + "</td></tr>\n";
    html += "</tbody>\n";
  }
  return html + "</table>\n";
}

}  // namespace opal::experiments
