#pragma once

#include "report/plot.hpp"

#include <span>
#include <string>
#include <vector>

namespace opal {

/// Where the values of an axis stand on a page: the same scales and ticks as on the page of a report (page/axes.js).
class PlotScale {
 public:
  /// Over all finite values and what the axis wants shown at least, with some room around. What a logarithmic axis
  /// cannot show is left out.
  PlotScale(const PlotAxis& axis, std::span<const double> values, double from_px, double to_px);

  /// Values beyond the ends, infinite ones too, are at the ends.
  double px(double value) const;
  double low() const { return low_; }
  double high() const { return high_; }

  /// Round numbers between the ends, about so many.
  std::vector<double> ticks(int count) const;

 private:
  bool logarithmic_;
  double low_ = 0, high_ = 1;
  double from_px_, to_px_;
};

/// "error [m]"
std::string title_of(const PlotAxis& axis);
/// A tick's value with four digits at most.
std::string tick_text(double value);

}  // namespace opal
