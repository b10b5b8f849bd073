#include "tests/report/page_parts.hpp"

#include "tests/kit/file_content.hpp"
#include "tests/kit/temporary_folder.hpp"

#include "report/table.hpp"
#include "report/table_files.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using Catch::Contains;

namespace {

const std::string kHostileCell = "</td><script>alert(1)</script>|[x](javascript:y)\n\"a\",b & c";

Table some_table() {
  return {{{"site", "", false}, {"error", "m"}, {"note", "", false}},
          {{"hall", "0.25", Cell("see", "run.html?a=1&b=2")}, {"café|1", "-∞", ""}, {kHostileCell, "12"}}};
}

/// Rows of an RFC 4180 text, read back.
std::vector<std::vector<std::string>> fields_of(const std::string& csv) {
  std::vector<std::vector<std::string>> rows(1, {""});
  bool quoted = false;
  for (const char c : csv) {
    if (c == '"')
      quoted = !quoted, rows.back().back() += "\"";
    else if (c == ',' && !quoted)
      rows.back().emplace_back();
    else if (c == '\n' && !quoted)
      rows.push_back({""});
    else
      rows.back().back() += c;
  }
  rows.pop_back();
  return rows;
}

}  // namespace

TEST_CASE("a table has the same rows and cells in HTML, Markdown and CSV") {
  const Table table = some_table();
  const std::string html = html_of(table);
  CHECK(occurrences(html, "<tr") == 4);
  CHECK(occurrences(html, "<td") == 9);
  CHECK(lines_of(markdown_of(table)).size() == 5);  // head, rule, three rows
  const auto fields = fields_of(csv_of(table));
  REQUIRE(fields.size() == 4);
  for (const auto& row : fields) CHECK(row.size() == 3);
  CHECK(fields[0][1] == "error [m]");
  for (const std::string& text : {html, markdown_of(table), csv_of(table)})
    CHECK_THAT(text, Contains("error [m]") && Contains("0.25") && Contains("-∞") && Contains("alert(1)"));
}

TEST_CASE("nothing in a cell becomes markup, a column or a row") {
  const std::string html = html_of(some_table());
  CHECK_THAT(html, !Contains("<script") && Contains("&lt;script&gt;") && Contains("run.html?a=1&amp;b=2"));
  for (const std::string& line : lines_of(markdown_of(some_table()))) {
    std::size_t bars = occurrences(line, "|") - occurrences(line, "\\|");
    CHECK(bars == 4);
    CHECK(occurrences(line, "<script") == occurrences(line, "\\<script"));
    CHECK(occurrences(line, "[x]") == 0);
  }
  CHECK_THAT(csv_of(some_table()), Contains("\"\"a\"\",b"));
}

TEST_CASE("columns of Markdown stand below each other, whatever their letters") {
  const auto lines = lines_of(markdown_of(some_table()));
  const auto characters = [](const std::string& line) {
    return std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xc0) != 0x80; });
  };
  for (const std::string& line : lines) CHECK(characters(line) == characters(lines[0]));
  CHECK_THAT(lines[1], Contains(":|") || Contains(": |"));
}

TEST_CASE("an empty table still has its head") {
  const Table empty{{{"site", "", false}, {"error", "m"}}, {}};
  CHECK(occurrences(html_of(empty), "<td") == 0);
  CHECK_THAT(html_of(empty), Contains("error [m]"));
  CHECK(lines_of(markdown_of(empty)).size() == 2);
  CHECK(csv_of(empty) == "site,error [m]\n");
  CHECK(csv_of({}) == "\n");
}

TEST_CASE("a short row ends in empty cells, and one that is too long is refused") {
  CHECK(csv_of({{{"a"}, {"b"}}, {{"1"}}}) == "a,b\n1,\n");
  CHECK_THROWS_WITH(html_of({{{"a"}}, {{"1", "2"}}}), Contains("1 columns") && Contains("2 cells"));
}

namespace {

/// Whether braces and mathematics that a text opens are closed; what is escaped opens nothing.
bool is_balanced(const std::string& latex) {
  int depth = 0, dollars = 0;
  for (std::size_t k = 0; k < latex.size(); ++k) {
    if (latex[k] == '\\')
      ++k;
    else if (latex[k] == '{')
      ++depth;
    else if (latex[k] == '}' && --depth < 0)
      return false;
    else if (latex[k] == '$')
      ++dollars;
  }
  return depth == 0 && dollars % 2 == 0;
}

/// Columns of a row: what & parts that is not escaped.
std::size_t latex_cells(const std::string& row) {
  std::size_t cells = 1;
  for (std::size_t k = 0; k < row.size(); ++k) cells += row[k] == '&' && (k == 0 || row[k - 1] != '\\');
  return cells;
}

}  // namespace

TEST_CASE("a table in LaTeX is one tabular, whatever stands in its cells") {
  Table table = some_table();
  table.rows.push_back({"{ } $ % # _ ^ ~ \\ & [", "-1.5 (-2 to ∞)", "\\end{tabular}"});
  const std::string latex = latex_of(table);
  CAPTURE(latex);
  CHECK(is_balanced(latex));
  const std::vector<std::string> lines = lines_of(latex);
  REQUIRE(lines.size() == table.rows.size() + 7);
  CHECK(lines[0] == "% needs \\usepackage{booktabs}");
  CHECK(lines[1] == "\\begin{tabular}{lrl}");
  CHECK(lines[3] == "site & error {[}m{]} & note \\\\");
  for (std::size_t k = 5; k < lines.size() - 2; ++k) {
    CHECK(latex_cells(lines[k]) == table.columns.size());
    CHECK(lines[k].ends_with(" \\\\"));
  }
  CHECK(lines[6] == "café\\textbar{}1 & $-$$\\infty$ &  \\\\");
  CHECK(lines[8] ==
        "\\{ \\} \\$ \\% \\# \\_ \\textasciicircum{} \\textasciitilde{} \\textbackslash{} \\& {[} & $-$1.5 ($-$2 to "
        "$\\infty$) & \\textbackslash{}end\\{tabular\\} \\\\");
  CHECK(lines.back() == "\\end{tabular}");
}

TEST_CASE("a table is three files with the same cells") {
  const TemporaryFolder folder;
  write_table(folder.path_of("table"), some_table());
  const auto content = [&](const char* ending) { return content_of(folder.path_of("table") + ending); };
  CHECK(content(".csv") == csv_of(some_table()));
  CHECK(content(".md") == markdown_of(some_table()));
  CHECK(content(".tex") == latex_of(some_table()));
}
