#pragma once

#include <string>
#include <vector>

namespace opal {

struct Column {
  std::string name;
  std::string unit = "";  ///< in brackets after the name; empty: none
  bool number = true;     ///< stands to the right
};

struct Cell {
  std::string text;
  std::string link = "";  ///< relative to the page; empty: none

  Cell(std::string words, std::string target = "") : text(std::move(words)), link(std::move(target)) {}
  Cell(const char* words) : text(words) {}
};

/// Text in rows and columns, of which HTML, Markdown, CSV and LaTeX are made. A row that is too short ends in empty
/// cells.
struct Table {
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;
  bool grouped = false;  ///< rows with the same first cell belong together; the page shows it
};

/// Scrolls sideways where it is wider than the page. @throws std::invalid_argument if a row has more cells than
/// columns, as the others do.
std::string html_of(const Table& table);

/// Padded, so that it can be read as it is.
std::string markdown_of(const Table& table);

/// RFC 4180; without links.
std::string csv_of(const Table& table);

/// A `tabular` with the rules of the package booktabs; without links.
std::string latex_of(const Table& table);

}  // namespace opal
