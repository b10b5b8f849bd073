#include "report/table.hpp"

#include "common/csv_table.hpp"
#include "report/html_elements.hpp"
#include "report/html_text.hpp"
#include "report/latex_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace opal {
namespace {

using Cells = std::vector<Cell>;

std::string head_of(const Column& column) {
  return column.unit.empty() ? column.name : column.name + " [" + column.unit + "]";
}

/// Rows of one length, with the heads first.
std::vector<Cells> all_rows(const Table& table) {
  std::vector<Cells> rows(1);
  for (const Column& column : table.columns) rows.front().push_back(head_of(column));
  for (const Cells& row : table.rows) {
    if (row.size() > table.columns.size())
      throw std::invalid_argument(
          fmt::format("a table of {} columns has a row of {} cells", table.columns.size(), row.size()));
    rows.push_back(row);
    rows.back().resize(table.columns.size(), "");
  }
  return rows;
}

/// What Markdown takes for more than text, and what would end a cell, is escaped; brackets only where they make a link.
std::string markdown_text(const std::string& text, bool in_link) {
  std::string escaped;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k], next = k + 1 < text.size() ? text[k + 1] : ' ';
    const bool bracket = (c == '[' || c == ']') && (in_link || next == '(' || next == '[');
    if (bracket || std::string_view("\\|<>*`").find(c) != std::string_view::npos) escaped += '\\';
    escaped += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return escaped;
}

std::string markdown_of(const Cell& cell) {
  if (cell.link.empty()) return markdown_text(cell.text, false);
  return fmt::format("[{}](<{}>)", markdown_text(cell.text, true), markdown_text(cell.link, true));
}

/// Of UTF-8, in characters.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

std::string cell_html(const Cell& cell, const Column& column, const char* tag, bool again) {
  const std::string kind = column.number ? "number" : again ? "again" : "";
  return element(tag, linked(cell.link, html_text(cell.text)), kind);
}

std::string row_html(const Table& table, const Cells& row, const Cells* before, const char* tag) {
  std::string html;
  const bool again = table.grouped && before && !row.empty() && row[0].text == (*before)[0].text;
  for (std::size_t k = 0; k < row.size(); ++k) html += cell_html(row[k], table.columns[k], tag, again && k == 0);
  return element("tr", html, table.grouped && before && !again ? "new" : "") + "\n";
}

std::string latex_row(const Cells& row) {
  std::string latex;
  for (std::size_t k = 0; k < row.size(); ++k) latex += (k == 0 ? "" : " & ") + latex_text(row[k].text);
  return latex + " \\\\\n";
}

}  // namespace

std::string html_of(const Table& table) {
  const std::vector<Cells> rows = all_rows(table);
  std::string body;
  for (std::size_t k = 1; k < rows.size(); ++k) body += row_html(table, rows[k], &rows[k - 1], "td");
  return element("div",
                 element("table", element("thead", row_html(table, rows[0], nullptr, "th")) + "\n" +
                                      element("tbody", "\n" + body)),
                 "wide") +
         "\n";
}

std::string markdown_of(const Table& table) {
  std::vector<std::vector<std::string>> rows;
  std::vector<std::size_t> widths(table.columns.size(), 3);
  for (const Cells& row : all_rows(table)) {
    rows.emplace_back();
    for (std::size_t k = 0; k < row.size(); ++k) {
      rows.back().push_back(markdown_of(row[k]));
      widths[k] = std::max(widths[k], width_of(rows.back().back()));
    }
  }
  std::vector<std::string> rule;
  for (std::size_t k = 0; k < widths.size(); ++k)
    rule.push_back(std::string(widths[k] - 1, '-') + (table.columns[k].number ? ":" : "-"));
  rows.insert(rows.begin() + 1, rule);
  std::string text;
  for (const std::vector<std::string>& row : rows) {
    text += "|";
    for (std::size_t k = 0; k < row.size(); ++k) {
      const std::string room(widths[k] - width_of(row[k]), ' ');
      text += table.columns[k].number ? " " + room + row[k] + " |" : " " + row[k] + room + " |";
    }
    text += "\n";
  }
  return text;
}

std::string csv_of(const Table& table) {
  std::string text;
  for (const Cells& row : all_rows(table)) {
    for (std::size_t k = 0; k < row.size(); ++k) text += (k == 0 ? "" : ",") + csv_field(row[k].text);
    text += "\n";
  }
  return text;
}

std::string latex_of(const Table& table) {
  const std::vector<Cells> rows = all_rows(table);
  std::string columns, body;
  for (const Column& column : table.columns) columns += column.number ? 'r' : 'l';
  for (std::size_t k = 1; k < rows.size(); ++k) body += latex_row(rows[k]);
  return "% needs \\usepackage{booktabs}\n\\begin{tabular}{" + columns + "}\n\\toprule\n" + latex_row(rows.front()) +
         "\\midrule\n" + body + "\\bottomrule\n\\end{tabular}\n";
}

}  // namespace opal
