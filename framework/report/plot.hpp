#pragma once

#include "report/table.hpp"

#include <array>
#include <optional>
#include <vector>

namespace opal {

/// Descriptions of plots: data, and what its axes are. The page draws them (page/main.js). Numbers need not be finite.

struct PlotAxis {
  std::string name, unit = "";
  bool logarithmic = false;
  std::optional<double> from = {}, to = {};  ///< shown at least
};

struct ScatterPlot {
  struct Point {
    double x = 0, y = 0;
    std::string title;                                 ///< what it is, in words
    std::optional<std::array<double, 2>> within = {};  ///< of y
    std::array<std::string, 2> links = {};             ///< of its left and right half
  };
  PlotAxis across, upwards;
  std::vector<Point> points;
  std::string beyond = "never";  ///< the name of infinity
  bool diagonal = true;          ///< a line where both are equal; both axes show the same, unless they have ends
};

/// Intervals in rows, beside a table that says the same in numbers (Lewis & Clarke 2001).
struct IntervalPlot {
  struct Row {
    double at = 0, low = 0, high = 0;
    std::string tone = "open";  ///< a colour of page/style.css
    bool total = false;         ///< of all others together
  };
  PlotAxis axis;
  double neutral = 0;  ///< where there is no difference
  Table table;
  std::vector<Row> rows;  ///< of the table
};

/// Lines over a common axis, each in a panel of its own.
struct LinePlot {
  struct Line {
    PlotAxis upwards;
    std::vector<double> y;  ///< NaN: a gap
    std::string tone;
  };
  struct Span {
    double from = 0, to = 0;
    std::string tone, title;
  };
  PlotAxis across;
  std::vector<double> x;
  std::vector<Line> lines;  ///< as many y as x
  std::vector<Span> spans;  ///< in a bar below
};

struct BarPlot {
  struct Bar {
    double from = 0, to = 0, height = 0;
    std::string title;
  };
  PlotAxis across, upwards;
  std::vector<Bar> bars;
};

/// HTML for html_page(). @param label  says in words what is plotted.
std::string plot_html(const ScatterPlot& plot, const std::string& label);
std::string plot_html(const IntervalPlot& plot, const std::string& label);
std::string plot_html(const LinePlot& plot, const std::string& label);
std::string plot_html(const BarPlot& plot, const std::string& label);

}  // namespace opal
