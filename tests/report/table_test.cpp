#include "tests/report/page_parts.hpp"

#include "report/table.hpp"

#include <catch2/catch.hpp>

#include <sstream>

using namespace opal;
using Catch::Contains;

namespace {

const std::string kHostileCell = "</td><script>alert(1)</script>|[x](javascript:y)\n\"a\",b & c";

Table some_table() {
  return {{{"site", "", false}, {"error", "m"}, {"note", "", false}},
          {{"hall", "0.25", Cell("see", "run.html?a=1&b=2")}, {"café|1", "-∞", ""}, {kHostileCell, "12"}}};
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
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
