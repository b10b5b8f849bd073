#include "report/plot.hpp"

#include "report/html_text.hpp"
#include "report/page_template.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace opal {
namespace {

using nlohmann::ordered_json;

/// As exact as an eye can tell.
ordered_json plotted(double value) {
  if (std::isnan(value)) return nullptr;
  if (std::isinf(value)) return value < 0 ? "-Infinity" : "Infinity";
  return std::stod(fmt::format("{:.5g}", value));
}

ordered_json plotted(const std::vector<double>& values) {
  ordered_json json = ordered_json::array();
  for (const double value : values) json.push_back(plotted(value));
  return json;
}

ordered_json json_of(const PlotAxis& axis) {
  ordered_json json = {{"name", axis.name}};
  if (!axis.unit.empty()) json["unit"] = axis.unit;
  if (axis.logarithmic) json["logarithmic"] = true;
  if (axis.from) json["from"] = plotted(*axis.from);
  if (axis.to) json["to"] = plotted(*axis.to);
  return json;
}

ordered_json json_of(const ScatterPlot::Point& point) {
  ordered_json json = {{"x", plotted(point.x)}, {"y", plotted(point.y)}, {"title", point.title}};
  if (point.within) json["within"] = {plotted((*point.within)[0]), plotted((*point.within)[1])};
  if (!point.links[0].empty() || !point.links[1].empty()) json["links"] = point.links;
  return json;
}

std::string plot_element(const ordered_json& plot, const std::string& label, const std::string& instead) {
  return fmt::format(
      "<div class=\"plot\" role=\"{}\" aria-label=\"{}\"><script type=\"application/json\">{}</script>{}</div>\n",
      instead.empty() ? "img" : "group", html_text(label), json_in_html(plot), instead);
}

}  // namespace

std::string plot_html(const ScatterPlot& plot, const std::string& label) {
  ordered_json json = {{"kind", "scatter"},     {"across", json_of(plot.across)}, {"upwards", json_of(plot.upwards)},
                       {"beyond", plot.beyond}, {"diagonal", plot.diagonal},      {"points", ordered_json::array()}};
  for (const ScatterPlot::Point& point : plot.points) json["points"].push_back(json_of(point));
  return plot_element(json, label, "");
}

std::string plot_html(const IntervalPlot& plot, const std::string& label) {
  ordered_json json = {{"kind", "intervals"},
                       {"axis", json_of(plot.axis)},
                       {"neutral", plotted(plot.neutral)},
                       {"rows", ordered_json::array()}};
  for (const IntervalPlot::Row& row : plot.rows)
    json["rows"].push_back({{"at", plotted(row.at)},
                            {"within", {plotted(row.low), plotted(row.high)}},
                            {"tone", row.tone},
                            {"total", row.total}});
  return plot_element(json, label, html_of(plot.table));
}

std::string plot_html(const LinePlot& plot, const std::string& label) {
  ordered_json json = {{"kind", "lines"},
                       {"across", json_of(plot.across)},
                       {"x", plotted(plot.x)},
                       {"lines", ordered_json::array()},
                       {"spans", ordered_json::array()}};
  for (const LinePlot::Line& line : plot.lines)
    json["lines"].push_back({{"upwards", json_of(line.upwards)}, {"tone", line.tone}, {"y", plotted(line.y)}});
  for (const LinePlot::Span& span : plot.spans)
    json["spans"].push_back(
        {{"from", plotted(span.from)}, {"to", plotted(span.to)}, {"tone", span.tone}, {"title", span.title}});
  return plot_element(json, label, "");
}

std::string plot_html(const BarPlot& plot, const std::string& label) {
  ordered_json json = {{"kind", "bars"},
                       {"across", json_of(plot.across)},
                       {"upwards", json_of(plot.upwards)},
                       {"bars", ordered_json::array()}};
  for (const BarPlot::Bar& bar : plot.bars)
    json["bars"].push_back(
        {{"from", plotted(bar.from)}, {"to", plotted(bar.to)}, {"height", plotted(bar.height)}, {"title", bar.title}});
  return plot_element(json, label, "");
}

}  // namespace opal
