#include "tests/report/page_parts.hpp"

#include "report/html_elements.hpp"
#include "report/plot.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>

using namespace opal;
using Catch::Contains;

namespace {

const std::string kHostile = "</script><img src=x onerror=alert(1)>\"' onload=\"alert(2)<!-- \\";
constexpr double kInfinite = std::numeric_limits<double>::infinity();

nlohmann::json data_of(const std::string& plot) {
  const std::string begin = "<script type=\"application/json\">";
  const std::size_t from = plot.find(begin) + begin.size();
  return nlohmann::json::parse(plot.substr(from, plot.find("</script>") - from));
}

ScatterPlot some_scatter(const std::string& name) {
  return {{name, "m", true},
          {name, "m", true},
          {{1, 2, name, {}, {"a.html", "b.html"}},
           {3, kInfinite, name},
           {0.5, 4, name, {{2, 8}}},
           {std::nan(""), 1, name}}};
}

IntervalPlot some_intervals(const std::string& name) {
  return {{name, "points"},
          0,
          {{{"site", "", false}, {"difference", "points"}}, {{name, "1"}, {"two", "-2"}, {"all", "0.5"}}},
          {{1, -kInfinite, 3, "good"}, {-2, -4, 1e300, "bad"}, {0.5, -1, 2, "open", true}}};
}

LinePlot some_lines(const std::string& name) {
  return {{"time", "s", false, 0.0},
          {0, 1, 2, 3},
          {{{name, "m", true, 0.01, 10.0}, {1, std::nan(""), 0.1, 0.2}, "a"}, {{"count"}, {1, 2, 3, 2}, "b"}},
          {{0, 2, "doubt", name}, {2, 3, "good", "right"}}};
}

BarPlot some_bars(const std::string& name) {
  return {{name}, {"statements", "", true, 1.0}, {{0, 0.5, 10, name}, {0.5, 1, 1000, name}}};
}

std::string some_page(const std::string& name) {
  return html_page(name, text_element("h2", name) + figure(plot_html(some_scatter(name), name), name) +
                             plot_html(some_intervals(name), name) + plot_html(some_lines(name), name) +
                             plot_html(some_bars(name), name) + details(name, text_element("pre", name)) +
                             colour_key({{"good", name}}) + download(name, name));
}

}  // namespace

TEST_CASE("hostile text stays text in every part of a page") {
  const std::string page = some_page(kHostile);
  CHECK(occurrences(page, "<script") == 5);  // data of four plots, and what draws them
  CHECK(occurrences(page, "</script") == 5);
  CHECK_THAT(page, !Contains("<img") && !Contains("<!--") && !Contains("\"' onload"));
  CHECK(data_of(plot_html(some_scatter(kHostile), "a"))["points"][0]["title"] == kHostile);
}

TEST_CASE("bytes that are no UTF-8 do not break a plot") {
  CHECK_NOTHROW(data_of(plot_html(some_bars("\xff\xfe"), "a")));
}

TEST_CASE("values that are not finite reach the plot as what they are") {
  const nlohmann::json points = data_of(plot_html(some_scatter("a"), "a"))["points"];
  CHECK(points[1]["y"] == "Infinity");
  CHECK(points[3]["x"].is_null());
  const nlohmann::json rows = data_of(plot_html(some_intervals("a"), "a"))["rows"];
  CHECK(rows[0]["within"][0] == "-Infinity");
  CHECK(rows[1]["within"][1] == 1e300);
}

TEST_CASE("a page fetches nothing, and runs a script only for its plots") {
  const std::string plain = html_page("plain", text_element("p", "text"));
  CHECK_THAT(plain, Contains("script-src 'none'") && !Contains("<script"));
  for (const std::string& page : {plain, some_page("name")})
    CHECK_THAT(page, Contains("default-src 'none'") && !Contains("<link") && !Contains("<img") && !Contains("url(") &&
                         !Contains(" src=") && !Contains("@import"));
  CHECK(some_page("name").size() < 200'000);
}

TEST_CASE("intervals can be read without a script") {
  CHECK_THAT(plot_html(some_intervals("hall"), "a"), Contains("<td>hall</td>") && Contains("difference [points]"));
}

TEST_CASE("a download gives back the text") {
  CHECK_THAT(download("a.csv", "a,\"b\"\n%"), Contains("data:text/plain;charset=utf-8,a%2C%22b%22%0A%25\""));
}

TEST_CASE("a page with every plot, for a browser: OPAL_REPORT_PAGE names the file", "[.][look]") {
  const char* file = std::getenv("OPAL_REPORT_PAGE");
  REQUIRE(file != nullptr);
  std::ofstream(file) << some_page(kHostile);
}
