#pragma once

#include "report/plot.hpp"

#include <string>

namespace opal {

/// Write a plot as a figure that stands alone, as in a paper: PATH.svg and PATH.pdf. It is the plot of the page,
/// without links; intervals stand in their table. The same plot gives the same bytes.
/// @throws Error naming the file that cannot be written.
void write_figure(const std::string& path, const ScatterPlot& plot);
void write_figure(const std::string& path, const IntervalPlot& plot);
void write_figure(const std::string& path, const LinePlot& plot);

}  // namespace opal
