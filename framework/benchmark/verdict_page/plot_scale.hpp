#pragma once

#include <string>
#include <vector>

namespace opal::statistics {

/// Where values lie along an axis of a plot [px].
class PlotScale {
 public:
  /// @param from, to  values at the ends, finite; if equal, some room is made. Logarithmic: both positive.
  PlotScale(double from, double to, double from_px, double to_px, bool logarithmic = false);

  /// Values beyond the ends lie at the ends.
  double place_px(double value) const;
  /// Round values between the ends.
  std::vector<double> ticks() const;
  bool holds(double value) const { return from_ <= value && value <= to_; }

 private:
  double from_, to_, from_px_, to_px_;
  bool logarithmic_;
};

/// "12.3": a coordinate in SVG.
std::string px(double value);

/// A line of SVG, drawn as the class `kind` of the page says.
std::string line(double x1, double y1, double x2, double y2, const std::string& kind);

/// As few digits as tell ticks apart.
std::string tick_text(double value);

}  // namespace opal::statistics
