#include "evaluation/calibration_page.hpp"

#include "common/phrases.hpp"
#include "report/html_elements.hpp"
#include "report/plot.hpp"
#include "report/quantity_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace opal {
namespace {

std::string bin_text(const ReliabilityBin& bin) {
  return fmt::format("{}: {} of {}, came true {}", interval_text(bin.from, bin.to, 3),
                     count_of(bin.statements, "statement"), fmt::format("{} queries", bin.clusters),
                     within_text(bin.came_true, bin.came_true_within.low, bin.came_true_within.high, 3));
}

/// From a probability on: what was said to the right, what came true upwards, and below how often.
std::string reliability_html(const Calibration& calibration, double from) {
  double lowest = from;
  std::vector<ReliabilityBin> bins = calibration.bins;
  std::erase_if(bins, [&](const ReliabilityBin& bin) { return bin.from < from - 1e-9; });
  for (const ReliabilityBin& bin : bins) lowest = std::min(lowest, std::floor(10 * bin.came_true_within.low) / 10);
  const PlotAxis said{"said (probability)", "", false, from, 1.0};
  ScatterPlot plot{said, {"came true (share)", "", false, lowest, 1.0}, {}};
  BarPlot counts{said, {"statements", "", true, 0.5}, {}};
  for (const ReliabilityBin& bin : bins) {
    const Interval& within = bin.came_true_within;
    plot.points.push_back({bin.said, bin.came_true, bin_text(bin), {{within.low, within.high}}, {}});
    counts.bars.push_back({bin.from, bin.to, double(bin.statements), bin_text(bin)});
  }
  const std::string range = "from " + fixed_text(from, 1) + " on";
  return figure(
      plot_html(plot, "said and come true, " + range) + plot_html(counts, "statements, " + range),
      fmt::format("{}. Dashed: perfectly calibrated. Whiskers: 95 % by the number of queries. Bars: statements "
                  "per bin, on a logarithmic scale.",
                  from > 0 ? "The same " + range : "All probabilities"));
}

std::string chapter_html(const CalibrationChapter& chapter) {
  constexpr double kClose = 0.9;
  const Table table = table_of(chapter.per_statement);
  return text_element("h2", chapter.title) +
         element("section",
                 element("div",
                         reliability_html(chapter.per_statement, 0) + reliability_html(chapter.per_statement, kClose),
                         "side") +
                     html_of(table) + download(chapter.title + ".csv", csv_of(table)) +
                     text_element("p", "Every row counts the same:") +
                     text_element("pre", scores_of(chapter.per_statement)) +
                     text_element("p", "Every query counts the same:") +
                     text_element("pre", scores_of(chapter.per_cluster))) +
         "\n";
}

}  // namespace

std::string calibration_page(const std::string& summary, std::span<const CalibrationChapter> chapters) {
  std::string html = text_element("pre", summary);
  for (const CalibrationChapter& chapter : chapters) html += chapter_html(chapter);
  return html_page("Said and come true", html);
}

}  // namespace opal
