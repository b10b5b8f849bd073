#include "tests/kit/file_content.hpp"
#include "tests/kit/temporary_folder.hpp"

#include "drawing/figure.hpp"
#include "drawing/plot_scale.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace opal;

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

ScatterPlot distances() {
  return {{"evidence, first fix", "m"}, {"mine, first fix", "m"}, {{1, 2, "a"}, {3, kInfinite, "b"}, {NAN, 1, "c"}}};
}

IntervalPlot sites() {
  IntervalPlot plot{{"difference", "points"}, 0, {{{"site", "", false}, {"difference (interval)", "points"}}, {}}, {}};
  plot.rows = {{5, -2, 12, "open", false}, {NAN, NAN, NAN, "open", false}, {8, 1, kInfinite, "good", true}};
  plot.table.rows = {{"hall", "5.0 (-2.0 to 12.0)"}, {"lab & shop", "-"}, {"all", "8.0 (1.0 to ∞)"}};
  return plot;
}

LinePlot over_time() {
  LinePlot plot{{"time", "s"}, {0, 1, 2}, {{{"error", "m", true, 0.01, 10.0}, {1, NAN, 0.1}, "a"}}, {}};
  plot.spans = {{0, 1, "doubt", "not localized"}, {1, 2, "good", "localized"}};
  return plot;
}

/// Both files of a figure, written twice.
template <class Plot>
void check_figure(const Plot& plot) {
  const TemporaryFolder folder;
  write_figure(folder.path_of("first"), plot);
  write_figure(folder.path_of("second"), plot);
  for (const char* ending : {".svg", ".pdf"}) {
    const std::string first = content_of(folder.path_of("first") + ending);
    INFO(ending);
    CHECK(first.size() > 1500);
    CHECK(first == content_of(folder.path_of("second") + ending));
  }
  CHECK(content_of(folder.path_of("first.svg")).find("<svg") != std::string::npos);
  CHECK(content_of(folder.path_of("first.pdf")).starts_with("%PDF-"));
  CHECK(content_of(folder.path_of("first.pdf")).find("%%EOF") != std::string::npos);
}

}  // namespace

TEST_CASE("figures are vector graphics, and the same plot gives the same bytes") {
  check_figure(distances());
  check_figure(sites());
  check_figure(over_time());
}

TEST_CASE("figures without anything in them can be drawn") {
  check_figure(ScatterPlot{{"a"}, {"b"}, {}});
  check_figure(IntervalPlot{{"ratio", "", true}, 1, {{{"site"}}, {}}, {}});
  check_figure(LinePlot{{"time", "s"}, {}, {}, {}});
}

TEST_CASE("a scale shows every finite value, and what is beyond it at its ends") {
  const std::vector<double> values{3, 40, kInfinite, NAN};
  const PlotScale linear({"x"}, values, 0, 100);
  CHECK(linear.low() < 3);
  CHECK(linear.high() > 40);
  CHECK(linear.px(kInfinite) == Approx(100));
  CHECK(linear.px(-kInfinite) == Approx(0));
  CHECK(linear.ticks(5) == std::vector<double>{10, 20, 30, 40});
  const PlotScale logarithmic({"x", "", true}, std::vector<double>{0.5, 20, -1, 0}, 0, 100);
  CHECK(logarithmic.px(std::sqrt(logarithmic.low() * logarithmic.high())) == Approx(50));
  CHECK(logarithmic.ticks(5) == std::vector<double>{0.5, 1, 2, 5, 10, 20});
  const PlotScale held({"share", "%", false, 0.0, 100.0}, std::vector<double>{50}, 0, 100);
  CHECK(held.low() == 0);
  CHECK(held.high() == 100);
}
