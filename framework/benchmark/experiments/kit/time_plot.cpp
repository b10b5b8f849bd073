#include "benchmark/experiments/kit/time_plot.hpp"

#include "report/html_elements.hpp"

#include <algorithm>
#include <array>

namespace opal::experiments {
namespace {

struct StatusTone {
  const char *tone, *meaning;
};

constexpr std::array<StatusTone, 4> kTones{{{"nothing", "no hypothesis"},
                                            {"doubt", "hypotheses, not called localized"},
                                            {"good", "localized, and right"},
                                            {"bad", "localized, and wrong"}}};

const StatusTone& tone_of(const JudgedMoment& moment) {
  if (moment.localized()) return kTones[moment.right() ? 2 : 3];
  return kTones[moment.has_pose ? 1 : 0];
}

std::vector<LinePlot::Span> spans_of(std::span<const JudgedMoment> moments) {
  std::vector<LinePlot::Span> spans;
  for (const JudgedMoment& moment : moments) {
    const StatusTone& now = tone_of(moment);
    if (!spans.empty()) spans.back().to = moment.time_s;
    if (spans.empty() || spans.back().tone != now.tone)
      spans.push_back({moment.time_s, moment.time_s, now.tone, now.meaning});
  }
  return spans;
}

/// A line on a logarithmic axis; what is below `low` is drawn there, and what is negative is a gap.
template <class Value>
void add(LinePlot& plot, std::span<const JudgedMoment> moments, PlotAxis axis, const char* tone, const Value& value) {
  axis.logarithmic = true;
  LinePlot::Line line{std::move(axis), {}, tone};
  for (const JudgedMoment& moment : moments) {
    const double y = value(moment);
    line.y.push_back(y < 0 ? std::nan("") : std::max(y, *line.upwards.from));
  }
  plot.lines.push_back(std::move(line));
}

}  // namespace

LinePlot lines_over_time(std::span<const JudgedMoment> moments) {
  LinePlot plot{{"time", "s", false, 0.0}, {}, {}, spans_of(moments)};
  for (const JudgedMoment& moment : moments) plot.x.push_back(moment.time_s);
  add(plot, moments, {"error of the best hypothesis", "m", true, 0.01, 10.0}, "a",
      [](const JudgedMoment& m) { return m.has_pose ? m.error_m() : -1; });
  add(plot, moments, {"hypotheses", "", true, 1.0, 10.0}, "b",
      [](const JudgedMoment& m) { return m.hypotheses > 0 ? m.hypotheses : -1; });
  if (std::any_of(moments.begin(), moments.end(), [](const JudgedMoment& m) { return m.cpu_ms > 0; }))
    add(plot, moments, {"CPU per update", "ms", true, 0.1, 10.0}, "c",
        [](const JudgedMoment& m) { return m.cpu_ms > 0 ? m.cpu_ms : -1; });
  return plot;
}

std::string time_plot(std::span<const JudgedMoment> moments) {
  return moments.empty() ? "" : plot_html(lines_over_time(moments), "error and hypotheses over time");
}

std::string status_key() {
  std::vector<std::pair<std::string, std::string>> meanings;
  for (const StatusTone& tone : kTones) meanings.emplace_back(tone.tone, tone.meaning);
  return text_element("p", "The bar below each plot:", "quiet") + colour_key(meanings);
}

}  // namespace opal::experiments
